#include "support/allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

// The sanitizers bring a malloc of their own.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TCERT_OWN_MALLOC 0
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define TCERT_OWN_MALLOC 0
#endif
#if !defined(TCERT_OWN_MALLOC) && defined(__GLIBC__)
#define TCERT_OWN_MALLOC 1
#endif

namespace {

std::atomic<std::size_t> allocations{0};
std::atomic<std::size_t> mallocs{0};

}  // namespace

namespace tcert::test_support {

std::size_t allocation_count() noexcept { return allocations.load(); }
std::size_t malloc_count() noexcept { return mallocs.load(); }

}  // namespace tcert::test_support

void* operator new(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) {
    return memory;
  }
  throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

#if TCERT_OWN_MALLOC
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  mallocs.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  mallocs.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  mallocs.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  mallocs.fetch_add(1, std::memory_order_relaxed);
  return __libc_memalign(alignment, size);
}
}
#endif
