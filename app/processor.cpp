// Before anything else runs: the program is compiled for processors with AVX2 and FMA (x86-64-v3), and would
// stop with "illegal instruction" on an older one. This file alone is compiled for any x86-64.
#if defined(__x86_64__)

#include <unistd.h>

#include <string_view>

namespace {

constexpr int kFirst = 101;  // before the constructors of all static objects
constexpr int kMachineFailed = 3;

bool is_supported() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
         __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0;
}

[[gnu::constructor(kFirst)]] void refuse_an_older_processor() {
  if (is_supported()) return;
  constexpr std::string_view kSaid =
      "Error: this processor has no AVX2 and FMA, for which this palpate was built; build it here with "
      "`cmake --workflow --preset native`\n";
  const auto ignored = ::write(STDERR_FILENO, kSaid.data(), kSaid.size());
  static_cast<void>(ignored);
  ::_exit(kMachineFailed);
}

}  // namespace

#endif
