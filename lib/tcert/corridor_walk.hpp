#pragma once
/// \file
/// The walk along the odometry path that lays nodes, closes edges and keeps the two values T_t and
/// V_t: from the evidence of fresh ticks to a corridor graph with widest-path labels (paper 3.1).

#include <optional>
#include <tcert/corridor_graph.hpp>
#include <tcert/crossing.hpp>
#include <tcert/parameters.hpp>
#include <tcert/pending_pass.hpp>
#include <tcert/robot.hpp>
#include <tcert/swept_margins.hpp>
#include <tcert/widest_labels.hpp>

namespace tcert {

/// The constructor takes all memory; every other member is noexcept and allocates nothing.
///
/// A node is laid at the first tick, at the first tick inside G, where the path turns back, after
/// a break, and each time the path has advanced by the edge length. The edge being walked is
/// pending, not in the graph, until it closes at a new node or at a known one that the path
/// crosses. Two sets of labels: T_t's on (node, side), V_t's on nodes, for a robot may back out. A
/// robot that turns on the spot, R_min = 0, may leave a node by any side, on a path of radius 0.
class CorridorWalk {
 public:
  /// With `swept`, T_t takes its margins from there; it must outlive the walk.
  CorridorWalk(const Robot& robot,
               const CertificateParameters& parameters,
               SweptMargins* swept = nullptr);

  void clear() noexcept;

  /// The first fresh tick of a trial. Nothing is ever tied to S if it lies `outside_start`.
  void begin(const Evidence& evidence, bool outside_start) noexcept;

  /// The next fresh tick. \pre begin() was called.
  void advance(const Evidence& evidence) noexcept;

  /// The next fresh tick, after a break of the path: the pending edge is dropped and a new
  /// component starts. With `bridge_m` above -infinity (ablation A2) the gap becomes an edge of
  /// that margin.
  void advance_after_break(const Evidence& evidence, double bridge_m) noexcept;

  /// Widest-path value from S to G; -infinity until connected. All values are those that hold at
  /// time 0: at another they are less by Evidence::since_start_m, which caps a turn on the spot.
  [[nodiscard]] double certificate_m(double since_start_m = 0.0) const noexcept;
  /// V_t = min(B(u), pending margin - memory deduction); -infinity if the path began outside S.
  [[nodiscard]] double corridor_value_m() const noexcept { return corridor_value_m_; }
  /// B(u): the label of the last node passed, on nodes without sides.
  [[nodiscard]] double reached_m() const noexcept;
  [[nodiscard]] double edge_margin_m() const noexcept { return pending_.margin_m(); }
  [[nodiscard]] bool capacity_exceeded() const noexcept { return capacity_exceeded_; }
  /// Labels raised since the last clear, of both sets.
  [[nodiscard]] std::uint64_t labels_raised() const noexcept {
    return through_.raised() + reached_.raised();
  }
  /// u, the last node passed; kNone before begin() and once capacity has run out.
  [[nodiscard]] std::uint32_t last_node() const noexcept { return at_node_; }
  [[nodiscard]] const CorridorGraph& graph() const noexcept { return graph_; }
  /// Labels of T_t, on (node, side).
  [[nodiscard]] const WidestLabels& through() const noexcept { return through_; }
  /// The same without sides, of a robot that turns on the spot; its margins count up to 0.
  [[nodiscard]] const std::optional<WidestLabels>& turning() const noexcept { return turning_; }
  /// Labels of V_t, on nodes.
  [[nodiscard]] const WidestLabels& reached() const noexcept { return reached_; }

 private:
  bool cross(const Evidence& now) noexcept;
  void leave(std::uint32_t node, Side side, const Evidence& now) noexcept;
  void follow_motion(const Evidence& now) noexcept;
  void close_at_new_node(const Evidence& now, Side entered, Side left) noexcept;
  void start_component(const Evidence& now, double corridor_value_m) noexcept;
  [[nodiscard]] std::uint32_t lay_node(const Evidence& now) noexcept;
  void record(EdgeEnd to, const Pass& pass, const Turn& changed) noexcept;
  void keep(const CorridorGraph::Recorded& recorded) noexcept;
  void relax(std::uint32_t edge) noexcept;
  void restart_pass(const Evidence& first, const Turn& changed) noexcept;
  void join(const Crossing& crossing, const Evidence& now) noexcept;
  void pass_node(const Crossing& crossing, const Evidence& now) noexcept;
  void look_again() noexcept;
  [[nodiscard]] double pending_value_m(const Evidence& now) const noexcept;

  CertificateParameters parameters_;
  CrossingRule rule_;
  SweptMargins* swept_;
  CorridorGraph graph_;
  WidestLabels through_;
  std::optional<WidestLabels> turning_;
  WidestLabels reached_;
  PendingPass pending_;
  Evidence last_;
  std::uint32_t at_node_ = kNone;  // u, the last node passed; kNone once capacity has run out
  Side left_by_ = Side::front;
  double node_travel_m_ = 0.0;
  Turn changed_;             // at u, onto the pass that is being walked
  bool forward_ = true;      // motion along the yaw since u
  double progress_m_ = 0.0;  // along the yaw since u, in the direction of motion
  double furthest_m_ = 0.0;
  double carried_m_ = 0.0;  // stands for B(u) while u is kNone
  double corridor_value_m_ = 0.0;
  bool outside_start_ = false;
  bool goal_entered_ = false;
  bool capacity_exceeded_ = false;
};

}  // namespace tcert
