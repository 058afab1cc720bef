#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>

namespace palpate::base {

/// The newest value that one thread writes and others read: a sequence lock. The writer never waits; a reader
/// that was overtaken tries again, and gives up after a bounded number of tries. The payload is stored in
/// atomic words, so that a torn read is a discarded value and never a data race.
template <typename T>
class Snapshot {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Snapshot() { write(T{}); }

  /// From one thread only.
  void write(const T& value) {
    std::array<std::uint64_t, kWords> words{};
    std::memcpy(words.data(), &value, sizeof(T));
    const std::uint64_t before = sequence_.load(std::memory_order_relaxed);
    sequence_.store(before + 1, std::memory_order_relaxed);
    // Each release store keeps the odd number before it; a reader who sees a new word also sees that number.
    for (std::size_t i = 0; i < kWords; ++i) words_[i].store(words[i], std::memory_order_release);
    sequence_.store(before + 2, std::memory_order_release);
  }

  /// The newest whole value; nothing when the writer overtook `tries` reads in a row.
  std::optional<T> try_read(int tries = 4) const {
    for (int k = 0; k < tries; ++k) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      std::array<std::uint64_t, kWords> words;
      for (std::size_t i = 0; i < kWords; ++i) words[i] = words_[i].load(std::memory_order_acquire);
      if (before % 2 != 0 || sequence_.load(std::memory_order_relaxed) != before) continue;
      T value;
      std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
      return value;
    }
    return std::nullopt;
  }

  /// For threads that have time: reads until it succeeds.
  T read() const {
    for (;;)
      if (const auto value = try_read()) return *value;
  }

 private:
  static constexpr std::size_t kWords = (sizeof(T) + 7) / 8;
  std::atomic<std::uint64_t> sequence_{0};
  std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace palpate::base
