#include "trials/plan/random.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <bit>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

#include "base/files/sha256.hpp"

namespace palpate::trials {
namespace {

Generator::State state_from_entropy() {
  Generator::State state{};
  // Up to 256 bytes come whole once the system's pool is ready; before that the call waits.
  ssize_t got = -1;
  do {
    got = ::getrandom(state.data(), sizeof state, 0);
  } while (got < 0 && errno == EINTR);
  if (got != static_cast<ssize_t>(sizeof state))
    throw std::system_error(errno, std::generic_category(), "the operating system gave no entropy");
  return state;
}

}  // namespace

std::uint64_t Generator::next() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

std::uint64_t Generator::below(std::uint64_t bound) {
  assert(bound > 0);
  const std::uint64_t unfair = -bound % bound;  // 2^64 mod bound: as many values are thrown away
  for (;;) {
    const std::uint64_t drawn = next();
    if (drawn >= unfair) return drawn % bound;
  }
}

double Generator::uniform() {
  return static_cast<double>(next() >> 11) * 0x1p-53;
}

double Generator::normal() {
  if (spare_) {
    const double value = *spare_;
    spare_.reset();
    return value;
  }
  for (;;) {
    const double u = 2 * uniform() - 1, v = 2 * uniform() - 1, s = u * u + v * v;
    if (s >= 1 || s == 0) continue;
    const double scale = std::sqrt(-2 * std::log(s) / s);
    spare_ = v * scale;
    return u * scale;
  }
}

Generator make_generator(Seed seed, std::string_view purpose) {
  if (!seed) return Generator(state_from_entropy());
  const std::string digest = base::sha256_hex(fmt::format("palpate random 1\n{}\n{}", *seed, purpose));
  Generator::State state{};
  for (std::size_t i = 0; i < state.size(); ++i)
    state[i] = std::stoull(digest.substr(16 * i, 16), nullptr, 16);
  return Generator(state);
}

}  // namespace palpate::trials
