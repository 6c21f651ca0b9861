#pragma once
/// \file
/// From ticks to the certificate T_t: the one code path of the live loop and of the replay.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>

namespace tcert {

class CorridorGraph;

/// Conditions met at a tick, or'ed together in CertifiedTick::flags. The last three stay set.
enum TickFlag : std::uint32_t {
  flag_stale = 1U << 0U,        ///< The tick was skipped as evidence.
  flag_bad_input = 1U << 1U,    ///< Pose not finite or time not increasing: skipped.
  flag_missing_ray = 1U << 2U,  ///< A ray has no reading; its side gets no credit.
  flag_break = 1U << 3U,        ///< The path broke here; a new component starts.
  flag_capacity_exceeded =
      1U << 4U,  ///< Nodes, edges or swept cells are used up; new evidence is ignored.
  flag_start_outside = 1U << 5U,  ///< The first tick lies outside S: never a certificate.
  flag_goal_reached = 1U << 6U,   ///< The robot has been inside G.
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
  std::uint32_t flags = 0;
  bool issued = false;  ///< T_t > 0 now or earlier.
};

/// tc_t: T_t once S and G are connected, V_t before.
[[nodiscard]] double series_value(const CertifiedTick& tick) noexcept;

/// Where a certificate is decided.
struct Bottleneck {
  std::uint32_t edge = 0;
  Pose pose;  ///< Of the tick with the smallest margin on that edge.
  double margin_m = 0.0;
  double width_m = 0.0;
  double turn_radius_m = 0.0;
};

/// Certificate of one trial, tick by tick.
///
/// The constructor takes all memory. `update` and `reset` are noexcept, allocate nothing, take no
/// lock and make no system call. One thread at a time. The graph's views stay valid until the
/// next `update` or `reset`.
class Certifier {
 public:
  /// \throws std::invalid_argument if the robot or the parameters are out of range.
  Certifier(const Robot& robot, const Course& course, const CertificateParameters& parameters);
  ~Certifier();
  Certifier(Certifier&& other) noexcept;
  Certifier& operator=(Certifier&& other) noexcept;
  Certifier(const Certifier& other) = delete;
  Certifier& operator=(const Certifier& other) = delete;

  /// Takes the next tick. A tick with a pose that is not finite, a time that does not increase or
  /// the wrong number of rays is skipped and flagged; a ray without a reading is flagged.
  CertifiedTick update(const Tick& tick) noexcept;

  /// m_t(theta_k) of the last fresh tick, one per ray (paper 3.1): the margin of heading along it.
  [[nodiscard]] std::span<const double> ray_margins() const noexcept;

  /// The edge that decides the pessimistic T_t, if S and G are connected; under unknown space taken
  /// for free (A2) what lies ahead may decide instead. O(length of the path).
  [[nodiscard]] std::optional<Bottleneck> bottleneck() const noexcept;

  /// The corridor graph explored so far.
  [[nodiscard]] const CorridorGraph& graph() const noexcept;

  /// The last node that the path passed; kNone before the first and once capacity has run out.
  [[nodiscard]] std::uint32_t last_node() const noexcept;

  /// Forgets the trial, keeps the memory.
  void reset() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tcert
