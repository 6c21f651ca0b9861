#pragma once
/// \file
/// How a run goes, on stderr: words, and on a terminal a line that says how far long work is.

#include <chrono>
#include <cstddef>
#include <string>

#include "cli/runs/progress.hpp"

namespace tcert::cli {

class TerminalProgress : public Progress {
 public:
  /// \param quiet only what has to be said.
  explicit TerminalProgress(bool quiet) noexcept : quiet_(quiet) {}

  using Progress::say;
  void say(std::string_view lines) override;
  void sum_up(std::string_view lines) override;
  void show(std::string_view text) override;
  /// That of the environment's COLUMNS, else of the terminal.
  [[nodiscard]] std::size_t width() const override;

 private:
  using Clock = std::chrono::steady_clock;

  void begin(std::string_view what, std::size_t total) override;
  /// Draws at most ten times a second.
  void reach(std::size_t done) override;
  /// Removes the line.
  void end() override;
  void draw(Clock::time_point now) const;

  bool quiet_;
  bool visible_ = false;
  std::string what_;
  std::size_t total_ = 0;
  std::size_t done_ = 0;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace tcert::cli
