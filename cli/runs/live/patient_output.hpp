#pragma once
/// \file
/// Writing for somebody who may read slowly or not at all.

#include <cstddef>
#include <string>
#include <string_view>

namespace tcert::cli {

/// Rows on stdout, each whole and at once. A disk that is full is waited for like a reader that is
/// slow, but without standing still: up to 1 MiB waits here, and what finds no room is dropped.
class RowSink {
 public:
  enum class WhenSlow {
    wait,  ///< Until the reader has room: then whoever sends the ticks waits as well.
    drop,  ///< Up to 1 MiB waits here; a row that finds no room is dropped and counted.
  };

  /// A wait ends when `interrupt` becomes readable.
  RowSink(WhenSlow when_slow, int interrupt) : when_slow_(when_slow), interrupt_(interrupt) {}

  /// False if an interrupt came first. \throws BrokenPipe if nobody reads any more; WriteError, but
  /// not because a disk is full.
  [[nodiscard]] bool put(std::string_view row);

  /// Writes as much as the reader has room for.
  void drain();

  /// Drains for up to `patience_ms`; what is left then is dropped, and the row of which the reader
  /// has only the beginning is cut off.
  void finish(int patience_ms);

  [[nodiscard]] bool waits() const noexcept { return at_ < pending_.size(); }
  /// True if something waits that it is of use to wait for.
  [[nodiscard]] bool waits_for_reader() const noexcept { return waits() && !is_full_; }
  [[nodiscard]] std::size_t dropped() const noexcept { return dropped_; }
  /// What the disk said when it last took nothing; 0 if it always did.
  [[nodiscard]] int disk_error() const noexcept { return disk_error_; }
  /// True if the last row that was written is not whole.
  [[nodiscard]] bool cut_off() const noexcept { return last_written_ != '\n'; }

 private:
  void write_some();

  WhenSlow when_slow_;
  int interrupt_;
  std::string pending_;
  std::size_t at_ = 0;
  char last_written_ = '\n';
  std::size_t dropped_ = 0;
  int disk_error_ = 0;
  bool is_full_ = false;  // since the last write
};

/// Lines on stderr that never wait: one that finds no room is dropped and counted.
class StatusLines {
 public:
  void say(std::string_view line);
  [[nodiscard]] std::size_t dropped() const noexcept { return dropped_; }

 private:
  std::size_t dropped_ = 0;
};

}  // namespace tcert::cli
