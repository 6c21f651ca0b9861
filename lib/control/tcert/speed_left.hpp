#pragma once
/// \file
/// The speed that a body has just left: its tracking error goes on holding for a while (FaSTrack's
/// switch between planners).

#include <array>
#include <cstddef>
#include <cstdint>

namespace tcert {

/// The largest speed commanded lately that still counts. A speed counts from when it was commanded
/// until `hold_s` of it after it was left for a smaller one. noexcept, allocates nothing.
class SpeedLeft {
 public:
  void reset() noexcept { count_ = 0; }

  /// `speed_mps` is commanded from `time_ns` on; `hold_s` is how long its error goes on holding
  /// after it is left. \pre times do not fall between two resets.
  void command(double speed_mps, double hold_s, std::int64_t time_ns) noexcept;

  /// The largest speed that counts at `time_ns`; 0 if none was commanded.
  [[nodiscard]] double at(std::int64_t time_ns) const noexcept;

 private:
  struct Entry {
    double speed_mps = 0.0;
    double hold_s = 0.0;
    std::int64_t left_ns = 0;  // of the newest: not left yet
  };
  // Speeds fall from the oldest to the newest. A fall that finds no room counts as the smallest
  // that is kept: longer than it has to, never shorter.
  static constexpr std::size_t kMost = 32;
  std::array<Entry, kMost> entries_{};
  std::size_t count_ = 0;
};

}  // namespace tcert
