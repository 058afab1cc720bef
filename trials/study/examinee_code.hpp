#pragma once

#include <span>
#include <string>
#include <string_view>

namespace palpate::trials {

/// Throws std::invalid_argument unless `code` is 1 to 32 letters, digits and hyphens and begins with no hyphen.
/// Codes, never names.
void check_examinee_code(std::string_view code);

/// The code without case, hyphens and leading zeros of its numbers: P01, p1 and P-1 are all "p1".
std::string normal_form(std::string_view code);

/// Throws std::invalid_argument when `code` is none of `known` but reads like one of them.
void check_not_near(std::string_view code, std::span<const std::string> known);

}  // namespace palpate::trials
