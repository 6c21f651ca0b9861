#include "cli/runs/live/producer.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/runs/errors.hpp"
#include "cli/runs/unix_listener.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kChunk = 65536;

std::string reason() { return std::generic_category().message(errno); }

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

class UnixSocket : public Producer {
 public:
  explicit UnixSocket(const std::string& path) : listener_(path) {}

  [[nodiscard]] const std::string& name() const override { return listener_.name(); }

  [[nodiscard]] int descriptor() const override {
    return client_.get() >= 0 ? client_.get() : listener_.descriptor();
  }

  Event receive(std::string& bytes) override {
    bytes.clear();
    if (client_.get() < 0) {
      client_.reset(listener_.accept());
      return client_.get() >= 0 ? Event::came : Event::none;
    }
    const Event event = read_stream(client_.get(), bytes, Event::left, name());
    if (event == Event::left) {
      client_.reset();
    }
    return event;
  }

 private:
  UnixListener listener_;
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
