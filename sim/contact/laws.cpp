#include "sim/contact/laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "sim/contact/exact/exact.hpp"
#include "sim/contact/kuroda/kuroda.hpp"
#include "sim/contact/none/none.hpp"
#include "sim/contact/sibille/sibille.hpp"
#include "sim/scene/accepted.hpp"

namespace palpate::sim {
namespace {

constexpr std::array kLaws{
    &kNone,
    &kSibille,
    &kKuroda,
    &kExact,
};

const std::vector<std::string_view>& law_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    all.reserve(kLaws.size());
    for (const ContactLaw* law : kLaws) all.push_back(law->name);
    return all;
  }();
  return names;
}

}  // namespace

std::span<const ContactLaw* const> contact_laws() {
  return kLaws;
}

const ContactLaw& contact_law(std::string_view name) {
  const auto found = std::ranges::find(kLaws, name, &ContactLaw::name);
  if (found == kLaws.end())
    throw std::invalid_argument(
        fmt::format("contact.model: found \"{}\", accepted: {}", name, fmt::join(law_names(), ", ")));
  return **found;
}

std::string choice_of_contact_models() {
  const std::span<const std::string_view> names = law_names();
  return fmt::format("{} or {}", fmt::join(names.first(names.size() - 1), ", "), names.back());
}

base::Words contact_model_words() {
  base::Words words;
  for (const ContactLaw* law : kLaws) words.now.push_back({law->name, law->meaning});
  return words;
}

}  // namespace palpate::sim
