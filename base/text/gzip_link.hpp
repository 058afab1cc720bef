#pragma once

#include <string>
#include <string_view>

namespace palpate::base {

/// A text as a data: address of a gzip file (RFC 1952, RFC 2397), for a link inside a page that needs no other
/// file. The same text gives the same address. Throws std::runtime_error where zlib or OpenSSL refuse.
std::string gzip_link(std::string_view text);

}  // namespace palpate::base
