#pragma once
/// \file
/// What a robot knows of a place, small enough to send: nodes and edges with one margin each
/// (paper 7, "tactile submaps"), and the union of several.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tcert/corridor_graph.hpp>
#include <tcert/robot.hpp>
#include <vector>

namespace tcert::federation {

/// Whose margins they are: those of one agent are none of another's.
struct Agent {
  double body_width_m = 0.0;
  double min_turn_radius_m = 0.0;
  double tracking_buffer_m = 0.0;
  double curvature_buffer_per_m = 0.0;
  friend bool operator==(const Agent&, const Agent&) = default;
};
[[nodiscard]] Agent agent_of(const Robot& robot) noexcept;

/// What margins are read by, from the surest; of those that are merged the least sure counts.
enum class MarginKind : std::uint8_t { witness, swept, radial, width };
[[nodiscard]] std::string_view name_of(MarginKind kind) noexcept;
[[nodiscard]] std::optional<MarginKind> margin_kind_from(std::string_view name) noexcept;

struct SubmapNode {
  Pose pose;
  bool in_start = false;
  bool in_goal = false;
  /// A lower bound of the margin of standing there; -infinity: no more than its edges say.
  double margin_m = -std::numeric_limits<double>::infinity();
};

/// A lower bound of the margin of a path between two ends: of one pass, or of a path that is
/// proved. Undirected.
struct SubmapEdge {
  std::array<EdgeEnd, 2> ends;
  double margin_m = 0.0;
  /// How far its path leaves the straight line between the two nodes, at most; infinite: unknown.
  double spread_m = std::numeric_limits<double>::infinity();
};

/// Of an edge, where it is told otherwise than by its pass.
struct EdgeMargin {
  double margin_m = 0.0;
  double spread_m = std::numeric_limits<double>::infinity();
};

/// What was felt in one frame.
struct Source {
  std::string name;  ///< Letters, digits, `.`, `_`, `-` and `/`, 1 to 100 of them.
  MarginKind margins = MarginKind::width;
  /// How far any of its poses may be off in the frame that all share, and any heading; infinite:
  /// nobody knows.
  double frame_error_m = std::numeric_limits<double>::infinity();
  double frame_error_rad = std::numeric_limits<double>::infinity();
  std::vector<SubmapNode> nodes;
  std::vector<SubmapEdge> edges;
};

/// In order: sources by name, nodes by pose, edges by their ends; each once. Two submaps that say
/// the same are then equal, and so are their files.
struct Submap {
  Agent agent;
  std::string synthetic;  ///< Seed of synthetic data, "-" of none, "several"; empty of real data.
  std::vector<Source> sources;
};

inline constexpr std::size_t kLongestName = 100;
[[nodiscard]] bool is_name(std::string_view name) noexcept;

/// What a corridor graph tells others. Where `margins` is given it holds a margin for each edge,
/// and edges without one are left out; else what is certified counts. `poses` stand for the nodes'
/// own where given. Edges that lead nowhere new (both ends one) and margins that are not above 0
/// are left out, with the nodes that only they have: nothing is ever certified by them.
[[nodiscard]] Source source_of(std::span<const Node> nodes,
                               std::span<const Edge> edges,
                               std::span<const std::optional<EdgeMargin>> margins = {},
                               std::span<const SubmapNode> poses = {});

/// The same in order. Of edges with the same ends that of the larger margin is kept, nodes of one
/// pose become one. O(n log n).
[[nodiscard]] Submap in_order(Submap submap);

/// The union: of what both say of a source's frame the larger error counts, of equal edges the
/// larger margin. Commutative, associative and idempotent. \pre both are in order.
/// \throws std::invalid_argument unless their agents are equal.
[[nodiscard]] Submap merge(const Submap& a, const Submap& b);
/// The same of any number of them, at least one, in O(n log n).
[[nodiscard]] Submap merge(std::span<const Submap> submaps);

}  // namespace tcert::federation
