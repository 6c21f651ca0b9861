/// Preloaded into a program: ends it, as kill -9 does, before call number TCERT_KILL_AT of those
/// that give files their names or bring them to the disk. Counts the calls of all threads, and
/// writes how many there were into the file TCERT_CALLS_TO.
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

std::atomic<long> calls{0};

bool is_now(const char* variable, long call) {
  const char* const at = std::getenv(variable);
  return at != nullptr && call == std::atol(at);
}

void count() {
  const long call = ++calls;
  if (is_now("TCERT_STOP_AT", call)) {
    ::kill(::getpid(), SIGSTOP);
  }
  if (is_now("TCERT_KILL_AT", call)) {
    ::kill(::getpid(), SIGKILL);
    for (;;) {
      ::pause();
    }
  }
}

/// Ends with the program.
struct Count {
  Count() = default;
  ~Count() {
    if (const char* const to = std::getenv("TCERT_CALLS_TO")) {
      if (std::FILE* const file = std::fopen(to, "w")) {
        std::fprintf(file, "%ld\n", calls.load());
        std::fclose(file);
      }
    }
  }
  Count(const Count&) = delete;
  Count& operator=(const Count&) = delete;
};
const Count written;

/// The function that this one stands in front of.
template <class Function>
Function* behind(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int fsync(int descriptor) {
  count();
  return behind<int(int)>("fsync")(descriptor);
}

int syncfs(int descriptor) noexcept {
  count();
  return behind<int(int)>("syncfs")(descriptor);
}

int rename(const char* from, const char* to) noexcept {
  count();
  return behind<int(const char*, const char*)>("rename")(from, to);
}

int renameat2(
    int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
  count();
  return behind<int(int, const char*, int, const char*, unsigned)>("renameat2")(
      from_folder, from, to_folder, to, flags);
}
}
