#pragma once

#include <span>
#include <string_view>

namespace palpate::app {

struct PageFile {
  std::string_view name;  // "page.js"
  std::string_view bytes;
};

/// A page that a Server serves, its files part of the program.
struct Page {
  std::string_view name;  // "examinee": its folder of app/web/pages
  std::span<const PageFile> files;
};

}  // namespace palpate::app
