#pragma once

#include <string>

namespace palpate::test {

/// The root of the source, absolute. (A function and no macro: the tests compile to the same bytes in every
/// clone.)
const std::string& source_folder();

/// The palpate that was built.
const std::string& program_file();

}  // namespace palpate::test
