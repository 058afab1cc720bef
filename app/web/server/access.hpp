#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace palpate::app {

/// A token that nobody guesses: 192 bits from the operating system, as 48 hexadecimal digits.
/// Throws std::runtime_error when the system has no randomness to give.
std::string draw_token();

/// Whether draw_token() could have drawn it.
bool is_token(std::string_view text);

/// What a request claims about where it comes from.
struct Claim {
  std::string_view host{};    // Host header
  std::string_view origin{};  // Origin header, empty when there is none
  std::string_view target{};  // "/TOKEN/page.js"
  bool upgrade = false;       // asks for a WebSocket
};

enum class Access { Granted, WrongHost, WrongOrigin, WrongToken };

/// Lets in only who knows the link and reached us by it: another site's page, or a name that was pointed at
/// the loopback address (DNS rebinding), is turned away. A WebSocket must name its origin.
Access check_access(const Claim& claim, std::string_view token, std::uint16_t port);

/// "page.js" of "/TOKEN/page.js"; "index.html" where the folder itself is asked for.
std::string_view file_of(std::string_view target);

}  // namespace palpate::app
