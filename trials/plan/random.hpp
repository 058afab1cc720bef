#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::trials {

/// xoshiro256**, written out so that one seed gives the same order and the same observers with every compiler
/// and library. Source: [Blackman2021].
class Generator {
 public:
  using State = std::array<std::uint64_t, 4>;

  explicit Generator(const State& state) : state_(state) {}

  std::uint64_t next();                      // uniform over 64 bits
  std::uint64_t below(std::uint64_t bound);  // uniform over 0 .. bound-1, unbiased by rejection; bound > 0
  bool coin() { return (next() >> 63) != 0; }
  double uniform();  // in [0, 1), 53 bits
  double normal();   // mean 0, standard deviation 1 (polar method)

 private:
  State state_;
  std::optional<double> spare_;
};

/// Where randomness comes from: a seed (repeatable) or, without one, the operating system's entropy.
using Seed = std::optional<std::uint64_t>;

/// A generator of its own for each purpose ("order of P01, session 1"): with a seed, from SHA-256 of seed and
/// purpose, so that streams are unrelated and none depends on what was drawn for another; without a seed,
/// from the operating system, whatever the purpose. Throws std::system_error when the system has no entropy
/// to give.
Generator make_generator(Seed seed, std::string_view purpose);

/// Fisher-Yates: every order is as likely as any other.
template <typename Item>
void shuffle(std::vector<Item>& items, Generator& generator) {
  for (std::size_t last = items.size(); last > 1; --last) {
    const std::size_t other = generator.below(last);
    std::swap(items[last - 1], items[other]);
  }
}

}  // namespace palpate::trials
