#pragma once
/// \file
/// From ticks to the certificate T_t: the one code path of the live loop and of the replay.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tcert/bottleneck.hpp>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>

namespace tcert {

class CorridorGraph;

/// Conditions met at a tick, or'ed together in CertifiedTick::flags. Those from
/// flag_capacity_exceeded to flag_memory_evicted stay set.
enum TickFlag : std::uint32_t {
  flag_stale = 1U << 0U,        ///< The tick was skipped as evidence.
  flag_bad_input = 1U << 1U,    ///< Pose not usable or time not increasing: skipped.
  flag_missing_ray = 1U << 2U,  ///< A ray has no reading; its side gets no credit.
  flag_break = 1U << 3U,        ///< The path broke here; a new component starts.
  flag_capacity_exceeded =
      1U << 4U,  ///< Nodes, edges or swept cells are used up; new evidence is ignored.
  flag_start_outside = 1U << 5U,   ///< The first tick lies outside S: never a certificate.
  flag_goal_reached = 1U << 6U,    ///< The robot has been inside G.
  flag_memory_evicted = 1U << 7U,  ///< Contact memory that still counted gave way: V_t may be high.
  flag_across_heading =
      1U << 8U,  ///< The robot moves off its heading; its sides count for less here.
};

/// What is known after a tick. Lengths in metres. NaN means not known at this tick;
/// -infinity in a certificate or corridor value means that there is no path yet.
struct CertifiedTick {
  std::int64_t time_ns = 0;
  double travel_m = 0.0;     ///< Distance travelled, dead band applied.
  double left_m = kMissing;  ///< Free width on the left, trailing minimum.
  double right_m = kMissing;
  double width_m = kMissing;           ///< Free width across the heading.
  double turn_radius_m = kMissing;     ///< Before the curvature buffer.
  double margin_m = kMissing;          ///< m_t.
  double edge_margin_m = kMissing;     ///< Smallest m on the pending edge.
  double memory = 0.0;                 ///< M_t at the robot, in [0, 1].
  double corridor_value_m = kMissing;  ///< V_t.
  double certificate_m = kMissing;     ///< T_t.
  std::uint32_t contacts = 0;          ///< Rays in contact.
  std::uint32_t new_contacts = 0;      ///< Rays whose contact began at this tick.
  std::uint32_t nodes = 0;
  std::uint32_t edges = 0;
  std::uint32_t labels_raised = 0;  ///< Work of this tick in the graph; at most 8 (edges + 2).
  std::uint32_t flags = 0;
  bool issued = false;                ///< T_t > 0 now or earlier.
  double footing_slack_m = kMissing;  ///< Least margin of slope, step and slip; unless felt, NaN.
  /// For how long T_t stays above 0 if nothing more is felt: T_t / 2u where obstacles move at u and
  /// T_t is above 0, else NaN.
  double valid_for_s = kMissing;
};

/// tc_t: T_t once S and G are connected, V_t before.
[[nodiscard]] double series_value(const CertifiedTick& tick) noexcept;

/// Certificate of one trial, tick by tick.
///
/// - Lifetime: the constructor copies all that it is given and takes all memory. `update` and
///   `reset` are noexcept, allocate nothing, take no lock, make no system call and read no clock.
///   The views of ray_margins() and graph() stay valid until the next `update` or `reset`.
/// - Threads: one at a time; different certifiers are independent. Nothing global is kept.
/// - Capacity is that of the parameters. When nodes or edges are used up, new evidence is ignored
///   and flag_capacity_exceeded stays set: T_t is then never above that of a run with more. When
///   contact memory that still counts has to give way, flag_memory_evicted stays set: V_t may then
///   be too high by at most lambda_M; T_t does not depend on it.
/// - Work of one `update`: at most two edges change, and each raises every label at most once per
///   edge, so that at most 8 (edges + 2) labels rise; the path is compared with the nodes nearby,
///   all of them at worst. Both are bounded by the capacity.
class Certifier {
 public:
  /// \throws std::invalid_argument if robot, course or parameters are out of range; std::bad_alloc.
  Certifier(const Robot& robot, const Course& course, const CertificateParameters& parameters);
  ~Certifier();
  Certifier(Certifier&& other) noexcept;
  Certifier& operator=(Certifier&& other) noexcept;
  Certifier(const Certifier& other) = delete;
  Certifier& operator=(const Certifier& other) = delete;

  /// Takes the next tick. Refused input is flagged, never thrown and never credited: a pose that is
  /// not finite or beyond kLargestPose, a time that does not increase, a wrong number of rays
  /// (flag_bad_input: the tick is skipped, and the next one is judged by the last good time); a
  /// stale tick (flag_stale: skipped); a reading that is NaN or infinite (flag_missing_ray: its
  /// side counts as the half body).
  CertifiedTick update(const Tick& tick) noexcept;

  /// m_t(theta_k) of the last fresh tick, one per ray (paper 3.1): the margin of heading along it.
  [[nodiscard]] std::span<const double> ray_margins() const noexcept;

  /// The edge that decides the pessimistic T_t, if S and G are connected; under unknown space taken
  /// for free (A2) what lies ahead may decide instead. O(length of the path).
  [[nodiscard]] std::optional<Bottleneck> bottleneck() const noexcept;

  /// The corridor graph explored so far. Where obstacles move its margins are those that hold at
  /// the first tick; now they are less by since_start_m().
  [[nodiscard]] const CorridorGraph& graph() const noexcept;

  /// 2u times the time since the first tick; 0 where nothing moves.
  [[nodiscard]] double since_start_m() const noexcept;

  /// The last node that the path passed; kNone before the first and once capacity has run out.
  [[nodiscard]] std::uint32_t last_node() const noexcept;

  /// Forgets the trial, keeps the memory.
  void reset() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcert
