#pragma once
/// \file
/// A client of a Unix socket.

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

namespace tcert::test_support {

/// Connects to a socket that may not be there yet; -1 after ten seconds.
inline int connected_to(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  for (int attempt = 0; attempt < 500; ++attempt) {
    const int end = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(end, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
      return end;
    }
    ::close(end);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return -1;
}

}  // namespace tcert::test_support
