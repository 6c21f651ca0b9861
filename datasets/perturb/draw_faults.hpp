#pragma once
/// \file
/// Which faults befall a stream of a trial, and when.

#include <cstdint>
#include <string_view>
#include <vector>

#include "datasets/perturb/fault.hpp"

namespace tcert::perturb {

/// The streams of a trial, in the order of their draws.
enum class StreamKind : std::uint8_t { pose, tactile, control };

struct FaultDraw {
  std::uint64_t seed = 1;
  std::string_view trial_id;
  StreamKind stream = StreamKind::tactile;
  std::int64_t begin_ns = 0;  ///< Of the trial's time, to which every fault keeps.
  std::int64_t end_ns = 0;
  bool has_links = true;               ///< Samples of the stream can be lost and be late.
  std::vector<std::size_t> rays{};     ///< Those with readings in the stream.
  std::vector<std::size_t> feeling{};  ///< Those of them with a force.
};

/// In order of start, those of one start in the order of kinds. Each kind of each stream has draws
/// of its own, keyed by seed, trial, stream and kind: whatever else is drawn, they are the same.
///
/// - Dropouts: continuous-time Gilbert-Elliott, good and bad by turns for exponential times, begun
/// in
///   the stationary state, so that the share of time in the bad one is bad / (good + bad); cut at
///   the trial's ends.
/// - All others begin by a Poisson process, on a ray drawn evenly, and have the length that is
/// asked
///   for. One that would not be over by the end of the trial does not begin.
/// O(faults log faults). \pre options are within the bounds of the command.
[[nodiscard]] std::vector<Injection> draw_faults(const FaultOptions& options,
                                                 const FaultDraw& draw);

}  // namespace tcert::perturb
