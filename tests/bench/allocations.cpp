#include "tests/bench/allocations.h"

#include <execinfo.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace {
std::size_t count = 0;  // one thread
bool tracing = false;

void note() {
  ++count;
  if (!tracing) return;
  tracing = false;  // backtrace allocates too
  std::array<void*, 24> calls;
  const int depth = ::backtrace(calls.data(), static_cast<int>(calls.size()));
  ::backtrace_symbols_fd(calls.data() + 2, depth - 2, 2);
  ::backtrace_symbols_fd(calls.data(), 0, 2);
  static_cast<void>(::fputs("--\n", stderr));
  tracing = true;
}
}  // namespace

std::size_t allocations() { return count; }
void trace_allocations(bool on) { tracing = on; }

// glibc's names for what its malloc, calloc, realloc and memalign do; defining ours puts them before its own.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  note();
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  note();
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) {
  note();
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  note();
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  note();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  note();
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? 12 : 0;  // ENOMEM
}
}
