#include "cli/commands/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace tcert::cli {

// open() takes the lowest number that is free, and those below are taken already.
void open_standard_streams() noexcept {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) == -1 && errno == EBADF &&
        ::open("/dev/null", O_RDWR) != descriptor) {
      std::abort();
    }
  }
}

}  // namespace tcert::cli
