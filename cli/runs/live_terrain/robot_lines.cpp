#include "cli/runs/live_terrain/robot_lines.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <string_view>
#include <system_error>
#include <table/atomic_file.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/interrupt.hpp"

namespace tcert::cli {
namespace {

/// \throws std::system_error for what is no signal.
void wait_for(std::array<pollfd, 2>& wait) {
  while (::poll(wait.data(), wait.size(), -1) < 0) {
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "cannot wait for the robot");
    }
  }
}

/// Once there is room a pipe takes so many bytes without waiting; a socket is told not to.
[[nodiscard]] ssize_t write_some(int descriptor, std::string_view bytes) {
  bytes = bytes.substr(0, PIPE_BUF);
  const ssize_t sent = ::send(descriptor, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  return sent < 0 && errno == ENOTSOCK ? ::write(descriptor, bytes.data(), bytes.size()) : sent;
}

/// False if nobody reads, or if it is interrupted while nobody does. \throws table::WriteError.
[[nodiscard]] bool write_whole(int descriptor, std::string_view text, int interrupt) {
  while (!text.empty()) {
    std::array<pollfd, 2> wait{{{interrupt, POLLIN, 0}, {descriptor, POLLOUT, 0}}};
    wait_for(wait);
    if (wait[1].revents == 0) {
      return false;
    }
    const ssize_t written = write_some(descriptor, text);
    if (written < 0 && (errno == EINTR || errno == EAGAIN)) {
      continue;
    }
    if (written < 0) {
      if (errno == EPIPE || errno == ECONNRESET) {
        return false;
      }
      throw table::WriteError("cannot write a row: " + std::generic_category().message(errno));
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

RobotLines::RobotLines(const std::string& listen, Progress& progress)
    : interrupt_(interrupt_descriptor()) {
  if (listen.empty()) {
    return;
  }
  if (!listen.starts_with("unix:")) {
    throw UsageError("--listen: found '" + listen + "', expected unix:PATH");
  }
  const UnixListener listener(listen.substr(5));
  progress.say("tcert live terrain: listening on " + listener.name());
  std::array<pollfd, 2> wait{{{interrupt_, POLLIN, 0}, {listener.descriptor(), POLLIN, 0}}};
  wait_for(wait);
  if (wait[0].revents != 0) {
    ended_ = true;
    return;
  }
  connection_.reset(listener.accept());
  if (connection_.get() < 0) {
    throw NoInput("cannot listen on '" + listener.name() +
                  "': " + std::generic_category().message(errno));
  }
}

std::optional<std::string> RobotLines::next() {
  std::string line;
  const int input = is_connected() ? connection_.get() : STDIN_FILENO;
  while (!lines_.next(line)) {
    if (ended_) {
      return std::nullopt;
    }
    std::array<pollfd, 2> wait{{{interrupt_, POLLIN, 0}, {input, POLLIN, 0}}};
    wait_for(wait);
    if (wait[0].revents != 0) {
      ended_ = true;
      return std::nullopt;
    }
    std::array<char, 65536> bytes{};
    const ssize_t got = ::read(input, bytes.data(), bytes.size());
    if (got > 0) {
      lines_.add({bytes.data(), static_cast<std::size_t>(got)});
    } else if (got == 0 || errno != EINTR) {
      lines_.end();
      ended_ = true;
    }
  }
  return line;
}

bool RobotLines::answer(const std::string& row) {
  const bool shown = write_whole(STDOUT_FILENO, row, interrupt_);
  return is_connected() ? write_whole(connection_.get(), row, interrupt_) : shown;
}

bool RobotLines::remark(const std::string& text) {
  return !is_connected() || write_whole(connection_.get(), "# " + text + '\n', interrupt_);
}

}  // namespace tcert::cli
