#pragma once

#include <cstddef>

namespace palpate::test {

// Sanitizers have a heap of their own: there nothing is counted, and these tests are left out.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHeapIsCounted = false;
#else
constexpr bool kHeapIsCounted = true;
#endif

struct HeapUse {
  long allocations = 0;
  std::size_t bytes = 0;  // asked for, whatever was given back meanwhile
};

/// Counts from here on what this thread takes from the heap, by whatever way.
void begin_heap_count();
HeapUse end_heap_count();

/// What `work` takes from the heap.
template <class Work>
HeapUse heap_use(Work work) {
  begin_heap_count();
  work();
  return end_heap_count();
}

}  // namespace palpate::test
