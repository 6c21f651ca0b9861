#include "cli/runs/live/patient_output.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <climits>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/printable.hpp>

#include "cli/runs/errors.hpp"

namespace tcert::cli {
namespace {

constexpr std::size_t kRoom = std::size_t{1} << 20U;

bool takes_more(int descriptor) {
  pollfd wait{descriptor, POLLOUT, 0};
  return ::poll(&wait, 1, 0) > 0;
}

bool is_socket(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 && S_ISSOCK(status.st_mode);
}

/// True for what may pass when somebody makes room.
bool is_of_a_disk(int error) {
  return error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO;
}

/// A pipe with room takes so many bytes without waiting; a socket is told not to.
ssize_t write_without_waiting(int descriptor, const char* bytes, std::size_t size) {
  static const std::array<bool, 3> sockets{false, is_socket(1), is_socket(2)};
  size = std::min<std::size_t>(size, PIPE_BUF);
  return sockets[static_cast<std::size_t>(descriptor)]
             ? ::send(descriptor, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL)
             : ::write(descriptor, bytes, size);
}

}  // namespace

void RowSink::write_some() {
  const ssize_t written =
      write_without_waiting(STDOUT_FILENO, pending_.data() + at_, pending_.size() - at_);
  is_full_ = written < 0 && is_of_a_disk(errno);
  if (written >= 0) {
    at_ += static_cast<std::size_t>(written);
    last_written_ = at_ > 0 ? pending_[at_ - 1] : last_written_;
  } else if (is_full_) {
    disk_error_ = errno;
  } else if (errno == EPIPE) {
    throw BrokenPipe("stdout");
  } else if (errno != EINTR && errno != EAGAIN) {
    throw table::WriteError("cannot write to stdout: " + std::generic_category().message(errno));
  }
  if (at_ == pending_.size()) {
    pending_.clear();
    at_ = 0;
  }
}

void RowSink::drain() {
  is_full_ = false;  // perhaps not any more
  while (waits_for_reader() && takes_more(STDOUT_FILENO)) {
    write_some();
  }
}

bool RowSink::put(std::string_view row) {
  if ((when_slow_ == WhenSlow::drop || is_full_) && pending_.size() - at_ + row.size() > kRoom) {
    drain();
    if (pending_.size() - at_ + row.size() > kRoom) {
      ++dropped_;
      return true;
    }
  }
  if (at_ > kRoom) {
    pending_.erase(0, at_);
    at_ = 0;
  }
  pending_ += row;
  drain();
  while (when_slow_ == WhenSlow::wait && waits_for_reader()) {
    std::array<pollfd, 2> wait{{{STDOUT_FILENO, POLLOUT, 0}, {interrupt_, POLLIN, 0}}};
    if (::poll(wait.data(), wait.size(), -1) > 0 && wait[1].revents != 0) {
      return false;
    }
    drain();
  }
  return true;
}

void RowSink::finish(int patience_ms) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::milliseconds(patience_ms);
  drain();
  while (waits_for_reader() && Clock::now() < until) {
    pollfd wait{STDOUT_FILENO, POLLOUT, 0};
    ::poll(&wait, 1, 10);
    drain();
  }
  dropped_ += static_cast<std::size_t>(
      std::count(pending_.begin() + static_cast<std::ptrdiff_t>(at_), pending_.end(), '\n'));
  pending_.clear();
  at_ = 0;
}

void StatusLines::say(std::string_view line) {
  std::string text = table::printable(line);
  text.resize(std::min<std::size_t>(text.size(), PIPE_BUF - 1));
  text += '\n';
  if (!takes_more(STDERR_FILENO) ||
      write_without_waiting(STDERR_FILENO, text.data(), text.size()) < 0) {
    ++dropped_;
  }
}

}  // namespace tcert::cli
