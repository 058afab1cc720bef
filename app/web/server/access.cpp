#include "app/web/server/access.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <array>
#include <stdexcept>

namespace palpate::app {
namespace {

/// Takes the same time wherever the two differ.
bool same(std::string_view a, std::string_view b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

std::string_view token_of(std::string_view target) {
  if (target.empty() || target.front() != '/') return {};
  target.remove_prefix(1);
  const auto slash = target.find('/');
  return slash == std::string_view::npos ? std::string_view{} : target.substr(0, slash);
}

}  // namespace

std::string draw_token() {
  std::array<unsigned char, 24> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw std::runtime_error("the operating system gave no random numbers for the link");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool is_token(std::string_view text) {
  return text.size() == 48 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

Access check_access(const Claim& claim, std::string_view token, std::uint16_t port) {
  const std::string host = fmt::format("127.0.0.1:{}", port);
  if (claim.host != host) return Access::WrongHost;
  const bool origin_given = !claim.origin.empty();
  if ((claim.upgrade || origin_given) && claim.origin != "http://" + host) return Access::WrongOrigin;
  if (!same(token_of(claim.target), token)) return Access::WrongToken;
  return Access::Granted;
}

std::string_view file_of(std::string_view target) {
  const auto slash = target.rfind('/');
  const std::string_view name = target.substr(slash + 1);
  return name.empty() ? "index.html" : name;
}

}  // namespace palpate::app
