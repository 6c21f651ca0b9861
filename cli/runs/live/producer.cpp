#include "cli/runs/live/producer.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kChunk = 65536;

std::string reason() { return std::generic_category().message(errno); }

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

/// Reads from a stream; 0 bytes are its end, nothing is a false alarm. \throws BadData.
Producer::Event read_stream(int descriptor,
                            std::string& bytes,
                            Producer::Event at_end,
                            const std::string& name) {
  bytes.resize(kChunk);
  const ssize_t got = ::read(descriptor, bytes.data(), bytes.size());
  const int error = errno;
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  if (got > 0) {
    return Producer::Event::bytes;
  }
  if (got == 0 || error == ECONNRESET) {
    return at_end;
  }
  if (error == EINTR || error == EAGAIN) {
    return Producer::Event::none;
  }
  throw BadData(name + ": " + std::generic_category().message(error));
}

class StandardInput : public Producer {
 public:
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] int descriptor() const override { return STDIN_FILENO; }
  Event receive(std::string& bytes) override {
    return read_stream(STDIN_FILENO, bytes, Event::end, name_);
  }

 private:
  std::string name_ = "stdin";
};

/// The file of a listening socket: removed at the end, unless somebody else has put another there.
class SocketFile {
 public:
  SocketFile() = default;
  ~SocketFile() {
    struct stat now {};
    if (!path_.empty() && ::lstat(path_.c_str(), &now) == 0 && now.st_dev == own_.st_dev &&
        now.st_ino == own_.st_ino) {
      ::unlink(path_.c_str());
    }
  }
  SocketFile(const SocketFile&) = delete;
  SocketFile& operator=(const SocketFile&) = delete;

  /// The file at `path` is ours.
  void own(const std::string& path) {
    if (::lstat(path.c_str(), &own_) == 0) {
      path_ = path;
    }
  }

 private:
  std::string path_;
  struct stat own_ {};
};

class UnixSocket : public Producer {
 public:
  explicit UnixSocket(std::string path) : path_(std::move(path)), name_("unix:" + path_) {
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
      throw NoInput("cannot listen on '" + name_ + "': " + reason());
    }
  }

  [[nodiscard]] const std::string& name() const override { return name_; }

  [[nodiscard]] int descriptor() const override {
    return client_.get() >= 0 ? client_.get() : listener_.get();
  }

  Event receive(std::string& bytes) override {
    bytes.clear();
    if (client_.get() < 0) {
      client_.reset(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      return client_.get() >= 0 ? Event::came : Event::none;
    }
    const Event event = read_stream(client_.get(), bytes, Event::left, name_);
    if (event == Event::left) {
      client_.reset();
    }
    return event;
  }

 private:
  /// A socket that was left behind: nobody listens on it. Any other file refuses connections too.
  static bool is_forsaken(const std::string& path, const sockaddr* address, socklen_t size) {
    struct stat file {};
    const bool is_socket = ::lstat(path.c_str(), &file) == 0 && S_ISSOCK(file.st_mode);
    const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    const bool forsaken =
        is_socket && ::connect(probe.get(), address, size) != 0 && errno == ECONNREFUSED;
    errno = EADDRINUSE;
    return forsaken;
  }

  std::string path_;
  std::string name_;
  Descriptor listener_;
  SocketFile file_;
  Descriptor client_;
};

/// Every datagram is one or more whole lines.
class UdpSocket : public Producer {
 public:
  explicit UdpSocket(std::uint16_t port)
      : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    constexpr int kOn = 1;
    constexpr int kBuffer = 1 << 20;
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RXQ_OVFL, &kOn, sizeof kOn);
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &kBuffer, sizeof kBuffer);
    if (::bind(socket_.get(), generic, size) != 0 ||
        ::getsockname(socket_.get(), generic, &size) != 0) {
      throw NoInput("cannot listen on 'udp:" + std::to_string(port) + "': " + reason());
    }
    name_ = "udp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] int descriptor() const override { return socket_.get(); }
  [[nodiscard]] std::size_t lost() const override { return lost_; }

  Event receive(std::string& bytes) override {
    bytes.resize(kChunk);
    iovec part{bytes.data(), bytes.size()};
    alignas(cmsghdr) std::array<char, 64> control{};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t got = ::recvmsg(socket_.get(), &message, MSG_DONTWAIT);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    for (cmsghdr* c = CMSG_FIRSTHDR(&message); got >= 0 && c != nullptr;
         c = CMSG_NXTHDR(&message, c)) {
      if (c->cmsg_level == SOL_SOCKET && c->cmsg_type == SO_RXQ_OVFL) {
        std::uint32_t lost = 0;
        std::memcpy(&lost, CMSG_DATA(c), sizeof lost);
        lost_ = lost;
      }
    }
    if (!bytes.empty() && bytes.back() != '\n') {
      bytes += '\n';
    }
    return bytes.empty() ? Event::none : Event::bytes;
  }

 private:
  Descriptor socket_;
  std::string name_;
  std::size_t lost_ = 0;
};

}  // namespace

std::unique_ptr<Producer> open_producer(const std::string& where) {
  const std::string_view text = where;
  if (text.empty()) {
    return std::make_unique<StandardInput>();
  }
  if (text.starts_with("unix:")) {
    return std::make_unique<UnixSocket>(where.substr(5));
  }
  if (text.starts_with("udp:")) {
    std::uint16_t port = 0;
    const char* const end = text.data() + text.size();
    if (const auto [rest, error] = std::from_chars(text.data() + 4, end, port);
        error == std::errc{} && rest == end) {
      return std::make_unique<UdpSocket>(port);
    }
  }
  throw UsageError("--listen: found '" + where + "', expected unix:PATH or udp:PORT");
}

}  // namespace tcert::cli
