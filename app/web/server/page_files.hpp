#pragma once

#include <span>
#include <string_view>

namespace palpate::app {

/// A file of the examinee's page, part of the program.
struct PageFile {
  std::string_view name;  // "page.js"
  std::string_view bytes;
};

std::span<const PageFile> page_files();

}  // namespace palpate::app
