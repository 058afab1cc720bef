#include "base/threads/snapshot.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace palpate::base {
namespace {

struct Payload {
  std::array<std::uint64_t, 9> words{};  // all equal, unless torn
};

TEST(Snapshot, ReadsWhatWasWritten) {
  Snapshot<Payload> snapshot;
  EXPECT_EQ(snapshot.read().words[8], 0U);
  Payload payload;
  payload.words.fill(7);
  snapshot.write(payload);
  EXPECT_EQ(snapshot.read().words, payload.words);
}

// Run under the tsan preset this also proves that there is no data race.
TEST(Snapshot, IsNeverTornWhileOneThreadWritesAndTwoRead) {
  Snapshot<Payload> snapshot;
  std::atomic<bool> done{false};
  std::atomic<int> torn{0};
  const auto check = [&] {
    std::uint64_t before = 0;
    while (!done) {
      const auto payload = snapshot.try_read();
      if (!payload) continue;
      for (const std::uint64_t word : payload->words) torn += word != payload->words[0];
      torn += payload->words[0] < before;  // values only grow: no older one comes after a newer one
      before = payload->words[0];
    }
  };
  std::thread first(check), second(check);
  for (std::uint64_t i = 1; i <= 200'000; ++i) {
    Payload payload;
    payload.words.fill(i);
    snapshot.write(payload);
  }
  done = true;
  first.join();
  second.join();
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(snapshot.read().words[0], 200'000U);
}

}  // namespace
}  // namespace palpate::base
