#pragma once
/// \file
/// The route to the goal over the explored corridors and beyond them, replanned as the certificate
/// moves (paper 5).

#include <cstdint>
#include <tcert/corridor_graph.hpp>
#include <tcert/dstar_lite.hpp>
#include <tcert/geometry.hpp>
#include <tcert/parameter_fields.hpp>
#include <tcert/region.hpp>
#include <vector>

namespace tcert {

/// See parameters/route.def.
struct RouteParameters {
#define TCERT_NUMBER TCERT_MEMBER_NUMBER
#include <tcert/parameters/route.def>
};

/// See parameter_fields.hpp; the first argument only names the list.
template <class Visit>
void visit_fields(const RouteParameters& /*list*/, Visit&& visit) {
  using Group = RouteParameters;
#define TCERT_NUMBER TCERT_VISIT_NUMBER
#include <tcert/parameters/route.def>
}

/// \throws std::invalid_argument naming the member that is out of range.
void validate(const RouteParameters& parameters);

/// What a robust margin is: the edge's less the tracking error, of no use up to `least_m`.
struct RobustMargin {
  double tracking_error_m = 0.0;
  double least_m = 0.0;  ///< epsilon_replan: an edge of no more is closed.
};

/// A route from the last node passed: along explored corridors to `exit`, from there straight to
/// the goal through unexplored space; a node inside G is its own exit.
struct Route {
  PathCost cost = kBlocked;    ///< kBlocked if there is none.
  std::uint32_t next = kNone;  ///< First node after the start; kNone if the exit is the start.
  std::uint32_t exit = kNone;
};

/// The corridor graph as D* Lite sees it: nodes without sides, for a robot that replans backs out,
/// and one frontier edge from every node to the goal, since what is unexplored may be free.
///
/// The constructor takes all memory; every other member is noexcept and allocates nothing.
class RoutePlanner {
 public:
  /// \throws std::invalid_argument if the parameters are out of range.
  RoutePlanner(std::uint32_t max_nodes,
               std::uint32_t max_edges,
               const Region& goal,
               const RobustMargin& margin,
               const RouteParameters& parameters);

  void clear() noexcept;

  /// Takes up what the graph gained, after every fresh tick; `at_node` is the last node passed,
  /// kNone if there is none. Blocks that have lasted long enough are lifted. Where obstacles move
  /// `since_start_m` is the certifier's: all edges are costed anew each time that 1 cm more is
  /// lost, ahead of it. O(new nodes and edges + edges at the node + blocked edges), and O(edges)
  /// then.
  void follow(const CorridorGraph& graph,
              std::uint32_t at_node,
              std::int64_t time_ns,
              double since_start_m = 0.0) noexcept;

  /// Blocks the way ahead of the last node passed, which is not an edge yet: its frontier edge at
  /// once and, if it `violates_force` (G2), the edge that it becomes.
  void block_ahead(bool violates_force) noexcept;

  /// The cheapest route from the last node passed.
  [[nodiscard]] Route replan() noexcept;

  /// The search below: its expansions, and what another search may be compared with.
  [[nodiscard]] const DStarLite& search() const noexcept { return search_; }

 private:
  void take_nodes(const CorridorGraph& graph) noexcept;
  void take_edges_at(const CorridorGraph& graph, std::uint32_t node) noexcept;
  void take_edge(const CorridorGraph& graph, std::uint32_t index) noexcept;
  void block(std::uint32_t edge) noexcept;
  void lift_blocks() noexcept;
  [[nodiscard]] PathCost cost_of(double length_m, double margin_m) const noexcept;

  RobustMargin margin_;
  RouteParameters parameters_;
  Point goal_;
  DStarLite search_;                     // state 0 is the goal, state n + 1 node n
  std::vector<std::uint32_t> frontier_;  // by node: edge of the search
  std::vector<std::uint32_t> corridor_;  // by corridor edge: edge of the search
  std::vector<PathCost> open_cost_;      // by edge of the search: its cost when not blocked
  std::vector<std::int64_t> until_ns_;   // by edge of the search; 0 if not blocked
  std::vector<std::uint32_t> blocked_;   // edges of the search, in no order
  std::size_t blocked_count_ = 0;
  std::uint32_t known_nodes_ = 0;
  std::uint32_t known_edges_ = 0;
  std::uint32_t at_node_ = kNone;
  std::int64_t now_ns_ = 0;
  double lost_m_ = 0.0;  // of every margin, as edges are costed
  bool pending_violates_ = false;
};

}  // namespace tcert
