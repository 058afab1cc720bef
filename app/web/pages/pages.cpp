#include "app/web/pages/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace palpate::app {

const Page& page(std::string_view name) {
  const auto found = std::ranges::find(pages(), name, &Page::name);
  if (found == pages().end()) throw std::logic_error(fmt::format("there is no page \"{}\"", name));
  return *found;
}

}  // namespace palpate::app
