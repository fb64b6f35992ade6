// Preloaded before a program: one call for memory, or every thread but some, fails.
//   QUOIN_FAULT_MEMORY=n   the n-th call since main fails, from 1
//   QUOIN_FAULT_REST=1     and all calls behind it
//   QUOIN_FAULT_THREADS=k  threads behind the k-th cannot be started
//   QUOIN_FAULT_CALLED=fd  a byte is written to this descriptor when the n-th call comes
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

constexpr long never = -1;
std::atomic<long> calls_left = never, threads_left = never;
bool rest_fails = false;
int told = -1;

long number(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? never : std::atol(text);
}

/// Whether this call fails.
bool fails() {
  if (calls_left == never) return false;
  const long left = --calls_left;
  if (left == 0 && told >= 0) (void)!::write(told, "!", 1);
  if (left < 0) calls_left = rest_fails ? 0 : never;
  if (left > 0 || (left < 0 && !rest_fails)) return false;
  errno = ENOMEM;
  return true;
}

using Main = int (*)(int, char**, char**);
Main real_main = nullptr;

/// What the loader and initialisers allocate is not the program's.
int counted_main(int argc, char** argv, char** environment) {
  rest_fails = number("QUOIN_FAULT_REST") == 1;
  told = static_cast<int>(number("QUOIN_FAULT_CALLED"));
  threads_left = number("QUOIN_FAULT_THREADS");
  calls_left = number("QUOIN_FAULT_MEMORY");
  return real_main(argc, argv, environment);
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*rtld_fini)(),
                      void* stack_end) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = main;
  const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

void* malloc(std::size_t size) { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return fails() ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) { return fails() ? nullptr : __libc_realloc(old, size); }
void* memalign(std::size_t alignment, std::size_t size) { return fails() ? nullptr : __libc_memalign(alignment, size); }
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  void* made = memalign(alignment, size);
  if (made == nullptr) return ENOMEM;
  *out = made;
  return 0;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  if (threads_left == 0) return EAGAIN;
  if (threads_left > 0) --threads_left;
  return reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, run, argument);
}

}  // extern "C"
