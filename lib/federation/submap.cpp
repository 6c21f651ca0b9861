#include <algorithm>
#include <federation/submap.hpp>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace tcert::federation {
namespace {

auto key_of(const SubmapNode& node) noexcept {
  return std::tuple(node.pose.position.x_m, node.pose.position.y_m, node.pose.yaw_rad);
}

auto key_of(EdgeEnd end) noexcept { return std::pair(end.node, end.side); }

auto key_of(const SubmapEdge& edge) noexcept {
  return std::pair(key_of(edge.ends[0]), key_of(edge.ends[1]));
}

/// 0 and -0 are one place.
double without_sign_of_zero(double value) noexcept { return value + 0.0; }

/// Where each node of a source comes to lie once they are in order.
std::vector<std::uint32_t> order_nodes(std::vector<SubmapNode>& nodes) {
  for (SubmapNode& node : nodes) {
    node.pose = {{without_sign_of_zero(node.pose.position.x_m),
                  without_sign_of_zero(node.pose.position.y_m)},
                 without_sign_of_zero(node.pose.yaw_rad)};
  }
  std::vector<std::uint32_t> order(nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t n) { return std::pair(key_of(nodes[n]), n); });
  std::vector<SubmapNode> ordered;
  std::vector<std::uint32_t> place(nodes.size());
  for (const std::uint32_t n : order) {
    if (ordered.empty() || key_of(ordered.back()) != key_of(nodes[n])) {
      ordered.push_back(nodes[n]);
    }
    ordered.back().in_start = ordered.back().in_start || nodes[n].in_start;
    ordered.back().in_goal = ordered.back().in_goal || nodes[n].in_goal;
    ordered.back().margin_m = std::max(ordered.back().margin_m, nodes[n].margin_m);
    place[n] = static_cast<std::uint32_t>(ordered.size() - 1);
  }
  nodes = std::move(ordered);
  return place;
}

void order_edges(std::vector<SubmapEdge>& edges) {
  for (SubmapEdge& edge : edges) {
    if (key_of(edge.ends[1]) < key_of(edge.ends[0])) {
      std::swap(edge.ends[0], edge.ends[1]);
    }
  }
  std::ranges::sort(edges, [](const SubmapEdge& a, const SubmapEdge& b) {
    if (key_of(a) != key_of(b)) {
      return key_of(a) < key_of(b);
    }
    return a.margin_m != b.margin_m ? a.margin_m > b.margin_m : a.spread_m < b.spread_m;
  });
  const auto is_known = [](const SubmapEdge& a, const SubmapEdge& b) {
    return key_of(a) == key_of(b);
  };
  edges.erase(std::unique(edges.begin(), edges.end(), is_known), edges.end());
}

void put_in_order(Source& source) {
  const std::vector<std::uint32_t> place = order_nodes(source.nodes);
  for (SubmapEdge& edge : source.edges) {
    for (EdgeEnd& end : edge.ends) {
      end.node = place[end.node];
    }
  }
  order_edges(source.edges);
}

/// Adds what `other` says of the same source.
void add(Source& source, const Source& other) {
  const auto offset = static_cast<std::uint32_t>(source.nodes.size());
  source.margins = std::max(source.margins, other.margins);
  source.frame_error_m = std::max(source.frame_error_m, other.frame_error_m);
  source.frame_error_rad = std::max(source.frame_error_rad, other.frame_error_rad);
  source.nodes.insert(source.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (SubmapEdge edge : other.edges) {
    edge.ends[0].node += offset;
    edge.ends[1].node += offset;
    source.edges.push_back(edge);
  }
}

constexpr std::array<std::string_view, 4> kKinds{"witness", "swept", "radial", "width"};

}  // namespace

std::string_view name_of(MarginKind kind) noexcept {
  return kKinds[static_cast<std::size_t>(kind)];
}

std::optional<MarginKind> margin_kind_from(std::string_view name) noexcept {
  const auto* const found = std::ranges::find(kKinds, name);
  return found == kKinds.end() ? std::nullopt
                               : std::optional(static_cast<MarginKind>(found - kKinds.begin()));
}

Agent agent_of(const Robot& robot) noexcept {
  return {robot.body_width_m,
          robot.min_turn_radius_m,
          robot.tracking_buffer_m,
          robot.curvature_buffer_per_m};
}

bool is_name(std::string_view name) noexcept {
  return !name.empty() && name.size() <= kLongestName && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-' || c == '/';
  });
}

Source source_of(std::span<const Node> nodes,
                 std::span<const Edge> edges,
                 std::span<const std::optional<EdgeMargin>> margins,
                 std::span<const SubmapNode> poses) {
  Source source;
  std::vector<std::uint32_t> number(nodes.size(), kNone);
  const auto take = [&](EdgeEnd end) {
    if (number[end.node] == kNone) {
      number[end.node] = static_cast<std::uint32_t>(source.nodes.size());
      const Node& node = nodes[end.node];
      source.nodes.push_back(poses.empty() ? SubmapNode{node.pose, node.in_start, node.in_goal}
                                           : poses[end.node]);
    }
    return EdgeEnd{number[end.node], end.side};
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::optional<EdgeMargin> told =
        margins.empty() ? EdgeMargin{edges[e].certified.margin_m} : margins[e];
    if (told && told->margin_m > 0.0) {
      source.edges.push_back(
          {{take(edges[e].ends[0]), take(edges[e].ends[1])}, told->margin_m, told->spread_m});
    }
  }
  return source;
}

Submap in_order(Submap submap) {
  std::ranges::stable_sort(submap.sources, {}, &Source::name);
  std::vector<Source> sources;
  for (Source& source : submap.sources) {
    if (sources.empty() || sources.back().name != source.name) {
      sources.push_back(std::move(source));
    } else {
      add(sources.back(), source);
    }
  }
  std::ranges::for_each(sources, put_in_order);
  submap.sources = std::move(sources);
  return submap;
}

Submap merge(const Submap& a, const Submap& b) { return merge(std::array{a, b}); }

Submap merge(std::span<const Submap> submaps) {
  Submap all{submaps.front().agent, "", {}};
  for (const Submap& one : submaps) {
    if (!(one.agent == all.agent)) {
      throw std::invalid_argument(
          "the submaps are of agents that differ in body width, turn radius or buffers: a margin "
          "is that of one agent");
    }
    if (all.synthetic.empty()) {
      all.synthetic = one.synthetic;
    } else if (!one.synthetic.empty() && one.synthetic != all.synthetic) {
      all.synthetic = "several";
    }
    all.sources.insert(all.sources.end(), one.sources.begin(), one.sources.end());
  }
  return in_order(std::move(all));
}

}  // namespace tcert::federation
