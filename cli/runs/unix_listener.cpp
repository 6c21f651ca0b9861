#include "cli/runs/unix_listener.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

/// A socket that was left behind: nobody listens on it. Any other file refuses connections too.
bool is_forsaken(const std::string& path, const sockaddr* address, socklen_t size) {
  struct stat file {};
  const bool is_socket = ::lstat(path.c_str(), &file) == 0 && S_ISSOCK(file.st_mode);
  const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const bool forsaken =
      is_socket && ::connect(probe.get(), address, size) != 0 && errno == ECONNREFUSED;
  errno = EADDRINUSE;
  return forsaken;
}

}  // namespace

SocketFile::~SocketFile() {
  struct stat now {};
  if (!path_.empty() && ::lstat(path_.c_str(), &now) == 0 && now.st_dev == own_.st_dev &&
      now.st_ino == own_.st_ino) {
    ::unlink(path_.c_str());
  }
}

void SocketFile::own(const std::string& path) {
  if (::lstat(path.c_str(), &own_) == 0) {
    path_ = path;
  }
}

UnixListener::UnixListener(std::string path) : path_(std::move(path)), name_("unix:" + path_) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path_.empty() || path_.size() >= sizeof address.sun_path) {
    throw UsageError("--listen " + name_ + ": the path must have 1 to " +
                     std::to_string(sizeof address.sun_path - 1) + " bytes");
  }
  std::memcpy(address.sun_path, path_.c_str(), path_.size());
  listener_.reset(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto* const generic = reinterpret_cast<const sockaddr*>(&address);
  const auto bind = [&] { return ::bind(listener_.get(), generic, sizeof address) == 0; };
  bool bound = bind();
  if (!bound && errno == EADDRINUSE && is_forsaken(path_, generic, sizeof address)) {
    ::unlink(path_.c_str());
    bound = bind();
  }
  if (bound) {
    file_.own(path_);
  }
  if (!bound || ::listen(listener_.get(), 4) != 0) {
    throw NoInput("cannot listen on '" + name_ + "': " + std::generic_category().message(errno));
  }
}

int UnixListener::accept() const noexcept {
  return ::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC);
}

}  // namespace tcert::cli
