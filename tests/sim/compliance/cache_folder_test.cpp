#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/compliance/cache.hpp"

namespace palpate::sim {
namespace {

/// Sets a variable of the environment for a while; nullptr removes it.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  }
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_{};
};

TEST(CacheFolder, FollowsTheEnvironment) {
  const Variable home("HOME", "/home/examiner");
  const Variable xdg("XDG_CACHE_HOME", nullptr);
  const Variable own("PALPATE_CACHE", nullptr);
  EXPECT_EQ(ComplianceCache::default_folder(), "/home/examiner/.cache/palpate");
  {
    const Variable relative("XDG_CACHE_HOME", "caches");  // which the XDG specification says to ignore
    EXPECT_EQ(ComplianceCache::default_folder(), "/home/examiner/.cache/palpate");
  }
  const Variable shared("XDG_CACHE_HOME", "/var/caches");
  EXPECT_EQ(ComplianceCache::default_folder(), "/var/caches/palpate");
  const Variable mine("PALPATE_CACHE", "mine");
  EXPECT_EQ(ComplianceCache::default_folder(), "mine");
}

TEST(CacheFolder, IsNoneWithoutAHome) {
  const Variable home("HOME", nullptr);
  const Variable xdg("XDG_CACHE_HOME", nullptr);
  const Variable own("PALPATE_CACHE", nullptr);
  EXPECT_TRUE(ComplianceCache::default_folder().empty());
}

TEST(CacheSize, IsWholeMebibytesOrGibibytes) {
  {
    const Variable none("PALPATE_CACHE_SIZE", nullptr);
    EXPECT_EQ(ComplianceCache::size_asked_for(), std::uintmax_t{2} << 30);
  }
  for (const auto& [text, bytes] :
       {std::pair{"500 MiB", std::uintmax_t{500} << 20}, std::pair{"3GiB", std::uintmax_t{3} << 30},
        std::pair{"0 MiB", std::uintmax_t{0}}}) {
    const Variable asked("PALPATE_CACHE_SIZE", text);
    EXPECT_EQ(ComplianceCache::size_asked_for(), bytes) << text;
  }
  for (const char* text :
       {"2", "2 GB", "-1 MiB", "1.5 GiB", "GiB", "2  GiB", "99999999999999 GiB", "2 GiB x"}) {
    const Variable asked("PALPATE_CACHE_SIZE", text);
    EXPECT_THROW(ComplianceCache::size_asked_for(), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace palpate::sim
