#include "cli/commands/terminal_progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>

#include "cli/commands/output.hpp"
#include "reports/table.hpp"

namespace tcert::cli {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};

/// A narrower terminal is written to as if it were this wide.
constexpr std::size_t kNarrowest = 40;

std::size_t columns_of_environment() {
  const char* const text = std::getenv("COLUMNS");  // NOLINT(concurrency-mt-unsafe): none sets it.
  std::size_t columns = 0;
  if (text != nullptr) {
    const std::string_view digits(text);
    std::from_chars(digits.data(), digits.data() + digits.size(), columns);
  }
  return columns;
}

std::size_t columns_of_terminal() {
  winsize size{};
  const bool known = ::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0;
  return known ? size.ws_col : 0;
}

}  // namespace

void TerminalProgress::say(std::string_view lines) { tcert::cli::say(lines); }

void TerminalProgress::sum_up(std::string_view lines) {
  if (!quiet_) {
    tcert::cli::say(lines);
  }
}

void TerminalProgress::show(std::string_view text) { print(text); }

std::size_t TerminalProgress::width() const {
  const std::size_t told = columns_of_environment();
  const std::size_t columns = told > 0 ? told : columns_of_terminal();
  return columns > 0 ? std::max(columns, kNarrowest) : 0;
}

void TerminalProgress::begin(std::string_view what, std::size_t total) {
  what_ = what;
  total_ = total;
  done_ = 0;
  visible_ = !quiet_ && total > 0 && ::isatty(STDERR_FILENO) == 1;
  start_ = Clock::now();
  last_ = start_;
}

void TerminalProgress::end() {
  if (visible_ && done_ > 0) {
    std::fputs("\r\033[K", stderr);
  }
  visible_ = false;
}

void TerminalProgress::reach(std::size_t done) {
  done_ = done;
  const auto now = Clock::now();
  if (visible_ && (now - last_ >= kRedraw || done_ == total_)) {
    last_ = now;
    draw(now);
  }
}

void TerminalProgress::draw(Clock::time_point now) const {
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done_) / elapsed_s;
  const double left_s = static_cast<double>(total_ - done_) / rate;
  const std::string line = "\r\033[K" + what_ + " " + std::to_string(done_) + "/" +
                           std::to_string(total_) + "  " + fixed(rate, 0) + "/s  " +
                           fixed(left_s, 0) + " s left";
  std::fputs(line.c_str(), stderr);
}

}  // namespace tcert::cli
