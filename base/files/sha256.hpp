#pragma once

#include <string>
#include <string_view>

namespace palpate::base {

/// SHA-256 of `bytes` as 64 lower-case hexadecimal digits (OpenSSL).
std::string sha256_hex(std::string_view bytes);

}  // namespace palpate::base
