#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace palpate::sim {

/// While it lives, this thread takes denormal numbers (below 2.2e-308) for 0: processors compute with them many times as
/// slowly, and no force or length is that small. Elsewhere than on x86 it does nothing.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | kFlushToZero | kDenormalsAreZero); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE2__)
 private:
  static constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;  // bits of MXCSR
  unsigned before_;
#endif
};

}  // namespace palpate::sim
