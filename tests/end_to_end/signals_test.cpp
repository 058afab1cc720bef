// What the system would end a program for without a word.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate {
namespace {

constexpr const char* kSaid = "Error: standard output: cannot be written; the result is lost\n";

class Signals : public testing::Test {
 protected:
  /// The exit code of `script`, run by bash, in which $PALPATE is the program and $SAID a file.
  int run_script(const std::string& script) {
    const std::string command = "PALPATE='" + palpate::test::program_file() + "' SAID='" +
                                (folder_ / "said").string() + "' bash -c '" + script + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  std::string said() const { return trials::test::read(folder_ / "said"); }

  trials::test::TemporaryFolder folder_;
};

TEST_F(Signals, AReaderThatHasGoneIsSaid) {
  EXPECT_EQ(run_script("(sleep 0.3; exec $PALPATE stats list 2> $SAID) | true; exit ${PIPESTATUS[0]}"), 3);
  EXPECT_EQ(said(), kSaid);
}

TEST_F(Signals, AFileThatMayGrowNoFurtherIsSaid) {
  EXPECT_EQ(run_script("ulimit -f 1; exec $PALPATE stats list > $SAID.out 2> $SAID"), 3);
  EXPECT_EQ(said(), kSaid);
}

}  // namespace
}  // namespace palpate
