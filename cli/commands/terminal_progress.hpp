#pragma once
/// \file
/// A line on stderr that says how far long work is; silent unless stderr is a terminal.

#include <chrono>
#include <cstddef>
#include <string>

namespace tcert::cli {

/// One thread at a time. The line is removed by the destructor.
class Progress {
 public:
  Progress(std::string what, std::size_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done; redraws at most ten times a second.
  void advance() { reach(done_ + 1); }

  /// So many are done.
  void reach(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;

  void draw(Clock::time_point now) const;

  std::string what_;
  std::size_t total_ = 0;
  std::size_t done_ = 0;
  bool visible_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace tcert::cli
