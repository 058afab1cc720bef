#include "analysis/psychometric/shape.hpp"

#include <fmt/core.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "analysis/psychometric/shape_kernels.hpp"

namespace palpate::analysis {

Shape shape_from_name(std::string_view name) {
  for (const Shape shape :
       {Shape::Logistic, Shape::Gaussian, Shape::Weibull, Shape::GumbelLeft, Shape::GumbelRight}) {
    if (name == name_of(shape)) return shape;
  }
  throw std::invalid_argument(
      fmt::format("shape is '{}'; accepted: logistic, gaussian, weibull, gumbel-left, gumbel-right", name));
}

std::string_view name_of(Shape shape) {
  switch (shape) {
    case Shape::Logistic:
      return "logistic";
    case Shape::Gaussian:
      return "gaussian";
    case Shape::Weibull:
      return "weibull";
    case Shape::GumbelLeft:
      return "gumbel-left";
    case Shape::GumbelRight:
      break;
  }
  return "gumbel-right";
}

std::string_view formula_of(Shape shape) {
  switch (shape) {
    case Shape::Logistic:
      return "F(x) = 1/(1 + exp(-beta (x - alpha)))";
    case Shape::Gaussian:
      return "F(x) = Phi(beta (x - alpha))";
    case Shape::Weibull:
      return "F(x) = 1 - exp(-(x/alpha)^beta)";
    case Shape::GumbelLeft:
      return "F(x) = 1 - exp(-exp(beta (x - alpha)))";
    case Shape::GumbelRight:
      break;
  }
  return "F(x) = exp(-exp(-beta (x - alpha)))";
}

bool on_log_levels(Shape shape) {
  return shape == Shape::Weibull;
}
double to_scale(Shape shape, double level) {
  return on_log_levels(shape) ? std::log(level) : level;
}
double from_scale(Shape shape, double place) {
  return on_log_levels(shape) ? std::exp(place) : place;
}

double shape_quantile(Shape shape, double p) {
  switch (shape) {
    case Shape::Logistic:
      return std::log(p) - std::log1p(-p);
    case Shape::Gaussian:
      return boost::math::quantile(boost::math::normal(), p);
    case Shape::GumbelRight:
      return -std::log(-std::log(p));
    case Shape::Weibull:
    case Shape::GumbelLeft:
      break;
  }
  return std::log(-std::log1p(-p));
}

ShapeValue shape_at(Shape shape, double eta) {
  return with_kernel(shape, [&](auto kernel) { return kernel.at(eta); });
}

}  // namespace palpate::analysis
