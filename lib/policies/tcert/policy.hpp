#pragma once
/// \file
/// Any of the policies, by name.

#include <cstdint>
#include <optional>
#include <string_view>
#include <tcert/camera_policy.hpp>
#include <tcert/histogram_policy.hpp>
#include <tcert/memory_augmented.hpp>
#include <tcert/reactive.hpp>
#include <tcert/replanning_policy.hpp>
#include <tcert/terrain_weighted.hpp>
#include <variant>

namespace tcert::policies {

enum class PolicyKind : std::uint8_t {
  m1,            ///< ReactivePolicy
  m2,            ///< TerrainWeightedPolicy
  m3,            ///< MemoryPolicy
  tvfh,          ///< HistogramPolicy
  td_star_lite,  ///< ReplanningPolicy
  cb_v,          ///< CameraPolicy
};

inline constexpr std::size_t kPolicies = 6;

/// "M1", "M2", "M3", "TVFH", "TD*Lite", "CB-V": as the paper prints them.
[[nodiscard]] std::string_view name_of(PolicyKind kind) noexcept;
/// None, if no policy has that name.
[[nodiscard]] std::optional<PolicyKind> policy_named(std::string_view name) noexcept;

/// A policy of the given kind: what it feels in, what to drive out.
///
/// - Lifetime: the constructor copies all that it is given and takes all memory. `step` and `reset`
///   are noexcept, allocate nothing, take no lock, make no system call and read no clock.
/// - Threads: one at a time; different policies are independent. A copy goes its own way.
/// - The same setup and the same senses give the same commands, to the last bit, after `reset` as
///   well. Mirrored senses give the mirrored commands (mirror_exact.hpp), unless all that the robot
///   has felt so far is its own mirror image: then it turns to the left where it has to choose.
/// - Commands keep |speed| <= cruise_mps, |yaw rate| <= max_yaw_rate_rps, and |speed| >= R_min
///   |yaw rate|, whatever the senses hold. It halts while a tick is stale or the pose unusable.
class Policy {
 public:
  /// \throws std::invalid_argument if the setup is out of range; TVFH and TD*Lite also, if the box
  /// of the course has more than max_policy_cells; std::bad_alloc.
  Policy(PolicyKind kind, const PolicySetup& setup);

  /// One control step. \pre `senses.tick.time_ns` and `senses.travel_m` never fall between two
  /// resets: time or travel that does is taken as standing still.
  Command step(const Senses& senses) noexcept;

  /// Forgets the trial, keeps the memory.
  void reset() noexcept;

  /// In its next step the policy gives the lane up, as it does by itself after give_up_after failed
  /// recoveries: for what watches over it.
  void give_up_lane() noexcept;

  [[nodiscard]] PolicyKind kind() const noexcept { return kind_; }

  /// Recoveries in a row after which the robot was stuck again within recovery_clear_m.
  [[nodiscard]] std::uint32_t failed_recoveries() const noexcept;

  /// Where on the course line the robot is.
  [[nodiscard]] const LineFollower& line() const noexcept;

 private:
  using Any = std::variant<ReactivePolicy,
                           TerrainWeightedPolicy,
                           MemoryPolicy,
                           HistogramPolicy,
                           ReplanningPolicy,
                           CameraPolicy>;
  [[nodiscard]] static Any make(PolicyKind kind, const PolicySetup& setup);
  [[nodiscard]] const Pilot& pilot() const noexcept;

  PolicyKind kind_;
  Any policy_;
};

}  // namespace tcert::policies
