#pragma once

#include <string>

namespace palpate::app {

/// `palpate stats batch`: answers each line of `file` ("-": standard input) on standard output, in order, as
/// soon as it is read. A line that cannot be answered gives {"line": 3, "error": "..."}. Throws
/// std::invalid_argument at the end when there was one, or when the file cannot be opened or is a folder;
/// std::system_error when reading fails.
void run_batch(const std::string& file);

}  // namespace palpate::app
