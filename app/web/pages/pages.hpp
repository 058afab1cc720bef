#pragma once

#include <span>

#include "app/web/server/page.hpp"

namespace palpate::app {

/// Every page that there is: each folder of app/web/pages that holds an index.html and a main.ts. A page has
/// these two, bundled to page.js, and what stands in pages/shared. The build writes this list.
std::span<const Page> pages();

/// The page of this name. Throws std::logic_error: there is none.
const Page& page(std::string_view name);

}  // namespace palpate::app
