#pragma once
/// \file
/// The samples of one stream, put in order of time as they come.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <vector>

namespace tcert::recording {

struct Sample {
  std::int64_t time_ns = 0;
  std::vector<double> values;  ///< NaN where there is none.
};

/// What became of the rows of a stream.
struct StreamUse {
  std::size_t rows = 0;        ///< That hold a value of the stream; empty ones are no samples.
  std::size_t empty = 0;       ///< Without any value of it.
  std::size_t unreadable = 0;  ///< Without a time, or part of a pose.
  std::size_t used = 0;
  std::size_t moved = 0;           ///< Used, and later in the file than their time.
  std::size_t same_time = 0;       ///< Not used: of the time of one that is.
  std::size_t set_back = 0;        ///< Not used: the clock was set back.
  std::size_t first_set_back = 0;  ///< The first of these, as the reader counts.
  std::int64_t set_back_by_ns = 0;
  std::int64_t first_ns = std::numeric_limits<std::int64_t>::max();  ///< Of those used.
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
};

/// Passes samples on in order of time. One that is late by less than the window is moved to its
/// place; a later one comes of a clock that was set back, and is not used, for what lies between
/// cannot be known. Of two of one time the first is used. Holds the samples of one window.
class SampleOrder {
 public:
  using Sink = std::function<void(const Sample&)>;

  /// \pre window_ns > 0.
  SampleOrder(std::int64_t window_ns, Sink sink);

  /// `place` is the row or message, for what is said of it.
  void add(std::int64_t time_ns, std::span<const double> values, std::size_t place);

  void count_empty() noexcept { ++use_.empty; }
  void count_unreadable() noexcept {
    ++use_.rows;
    ++use_.unreadable;
  }

  /// Passes on what is left.
  StreamUse finish();

 private:
  struct Waiting {
    Sample sample;
    std::size_t number = 0;  // of the order in the file
  };
  struct Later {
    bool operator()(const Waiting& a, const Waiting& b) const noexcept {
      return a.sample.time_ns != b.sample.time_ns ? a.sample.time_ns > b.sample.time_ns
                                                  : a.number > b.number;
    }
  };

  void pass_until(std::int64_t time_ns);

  std::int64_t window_ns_;
  Sink sink_;
  StreamUse use_;
  std::int64_t newest_ns_ = std::numeric_limits<std::int64_t>::min();
  std::priority_queue<Waiting, std::vector<Waiting>, Later> waiting_;
};

}  // namespace tcert::recording
