#include "cli/runs/live_terrain/robot_lines.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <table/atomic_file.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/interrupt.hpp"

namespace tcert::cli {
namespace {

/// False if nobody reads. \throws table::WriteError.
[[nodiscard]] bool write_whole(int descriptor, const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const ssize_t written = ::write(descriptor, text.data() + at, text.size() - at);
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      if (errno == EPIPE || errno == ECONNRESET) {
        return false;
      }
      throw table::WriteError("cannot write a row: " + std::generic_category().message(errno));
    }
    at += static_cast<std::size_t>(written);
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
  while (::poll(wait.data(), wait.size(), -1) < 0 && errno == EINTR) {
  }
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
  const int input = connection_.get() >= 0 ? connection_.get() : STDIN_FILENO;
  while (!lines_.next(line)) {
    if (ended_) {
      return std::nullopt;
    }
    std::array<pollfd, 2> wait{{{interrupt_, POLLIN, 0}, {input, POLLIN, 0}}};
    if (::poll(wait.data(), wait.size(), -1) < 0) {
      continue;  // By a signal.
    }
    if (wait[0].revents != 0) {
      ended_ = true;
      return std::nullopt;
    }
    std::array<char, 65536> bytes;
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
  const bool shown = write_whole(STDOUT_FILENO, row);
  return connection_.get() >= 0 ? write_whole(connection_.get(), row) : shown;
}

}  // namespace tcert::cli
