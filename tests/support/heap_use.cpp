#include "tests/support/heap_use.hpp"

#include <cstdlib>

namespace palpate::test {
namespace {

thread_local bool counting = false;
thread_local HeapUse use{};

}  // namespace

void begin_heap_count() {
  use = {};
  counting = true;
}

HeapUse end_heap_count() {
  counting = false;
  return use;
}

}  // namespace palpate::test

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace palpate::test {

static void count(std::size_t bytes) {
  if (!counting) return;
  ++use.allocations;
  use.bytes += bytes;
}

}  // namespace palpate::test

// Every way to the heap in a program ends in one of these. glibc's manual allows a program to replace them; its
// own stay reachable by the names with __libc.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  palpate::test::count(size);
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  palpate::test::count(number * size);
  return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) {
  palpate::test::count(size);
  return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  palpate::test::count(size);
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  palpate::test::count(size);
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? 12 : 0;  // ENOMEM
}
}

#endif
