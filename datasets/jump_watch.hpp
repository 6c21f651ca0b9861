#pragma once
/// \file
/// One wrong stamp far ahead would make every later tick too old.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "datasets/tick_line.hpp"

namespace tcert {

/// Holds a tick back that comes after a gap, until the next one says which clock goes on: one that
/// is later confirms it, one that is not refuses it. A tick without a gap is never held.
class JumpWatch {
 public:
  /// \p rays is the number of rays of a tick, \p max_gap_s that of the bundle.
  JumpWatch(std::size_t rays, double max_gap_s);

  struct Verdict {
    std::span<const TickLine> usable;          ///< In order; valid until the next call.
    std::optional<std::int64_t> refused_ns{};  ///< The time of the tick that was held and is wrong.
    std::optional<std::int64_t> go_back_to_ns{};  ///< The time that the next tick must exceed.
  };

  /// The ticks of which it is known now that their time is right.
  [[nodiscard]] Verdict take(const TickLine& line);

  /// The tick that is held at the end of the run, which nothing contradicts any more.
  [[nodiscard]] std::optional<TickLine> last();

 private:
  void hold(const TickLine& line);

  std::vector<RayReading> readings_;  // of the tick that is held
  std::optional<TickLine> held_;
  std::optional<std::int64_t> last_ns_;
  double max_gap_s_;
  std::vector<TickLine> usable_;
};

}  // namespace tcert
