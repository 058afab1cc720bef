#include "analysis/mixed/link.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>
#include <stdexcept>
#include <string>

namespace palpate::analysis {

Link link_from_name(std::string_view name) {
  if (name == "logit") return Link::Logit;
  if (name == "probit") return Link::Probit;
  throw std::invalid_argument(fmt::format("link is '{}'; accepted: logit, probit", name));
}

std::string_view name_of(Link link) {
  return link == Link::Logit ? "logit" : "probit";
}

double quantile_of(Link link, double p) {
  return link == Link::Logit ? std::log(p / (1 - p)) : quantile(boost::math::normal(), p);
}

}  // namespace palpate::analysis
