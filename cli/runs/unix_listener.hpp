#pragma once
/// \file
/// A Unix socket that is listened on.

#include <sys/stat.h>
#include <unistd.h>

#include <string>

namespace tcert::cli {

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  void reset(int value = -1) {
    if (value_ >= 0) {
      ::close(value_);
    }
    value_ = value;
  }
  [[nodiscard]] int get() const noexcept { return value_; }

 private:
  int value_;
};

/// The file of a listening socket: removed at the end, unless somebody else has put another there.
class SocketFile {
 public:
  SocketFile() = default;
  ~SocketFile();
  SocketFile(const SocketFile&) = delete;
  SocketFile& operator=(const SocketFile&) = delete;

  /// The file at `path` is ours.
  void own(const std::string& path);

 private:
  std::string path_;
  struct stat own_ {};
};

class UnixListener {
 public:
  /// Listens at `path`; a socket that was left behind there, which nobody listens on, is replaced.
  /// \throws UsageError for a path that is no socket's; NoInput if it cannot be listened on.
  explicit UnixListener(std::string path);

  /// "unix:PATH", for messages.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] int descriptor() const noexcept { return listener_.get(); }
  /// The next connection, waited for; -1 if there is none after all. The caller owns it.
  [[nodiscard]] int accept() const noexcept;

 private:
  std::string path_;
  std::string name_;
  Descriptor listener_;
  SocketFile file_;
};

}  // namespace tcert::cli
