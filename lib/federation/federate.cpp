#include <algorithm>
#include <cmath>
#include <federation/federate.hpp>
#include <numbers>
#include <stdexcept>

namespace tcert::federation {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

Union numbered_through(const Submap& submap) {
  Union known;
  for (std::uint32_t s = 0; s < submap.sources.size(); ++s) {
    const Source& source = submap.sources[s];
    const auto offset = static_cast<std::uint32_t>(known.nodes.size());
    known.nodes.insert(known.nodes.end(), source.nodes.begin(), source.nodes.end());
    known.source.resize(known.nodes.size(), s);
    for (SubmapEdge edge : source.edges) {
      edge.ends[0].node += offset;
      edge.ends[1].node += offset;
      known.edges.push_back(edge);
    }
  }
  return known;
}

/// What a node offers to a join.
struct Joint {
  double margin_m = kNever;                   // the largest of its own and its edges'
  double reach_m = 0.0;                       // beside an edge, a join ends no further off
  std::array<bool, 2> leads{};                // on, by the side that a join has at it
  std::array<std::vector<Stretch>, 2> edges;  // by side: those of a known path
};

std::size_t at(Side side) noexcept { return static_cast<std::size_t>(side); }

std::vector<Joint> joints_of(const Union& known) {
  std::vector<Joint> joints(known.nodes.size());
  for (const SubmapEdge& edge : known.edges) {
    const double length_m = distance(known.nodes[edge.ends[0].node].pose.position,
                                     known.nodes[edge.ends[1].node].pose.position);
    for (const EdgeEnd& end : edge.ends) {
      Joint& joint = joints[end.node];
      joint.margin_m = std::max(joint.margin_m, edge.margin_m);
      joint.leads[at(opposite(end.side))] = true;
      if (2.0 * edge.spread_m < edge.margin_m) {
        joint.reach_m = std::max(joint.reach_m, length_m + 0.5 * edge.margin_m);
        joint.edges[at(end.side)].push_back({known.nodes[edge.ends[0].node].pose.position,
                                             known.nodes[edge.ends[1].node].pose.position,
                                             edge.margin_m,
                                             edge.spread_m});
      }
    }
  }
  for (std::size_t n = 0; n < joints.size(); ++n) {
    joints[n].margin_m = std::max(joints[n].margin_m, known.nodes[n].margin_m);
    if (known.nodes[n].in_start || known.nodes[n].in_goal) {
      joints[n].leads = {true, true};
    }
  }
  return joints;
}

/// The pose that a way has where it leaves a node by this side.
Pose leaving(const Pose& pose, Side side) noexcept {
  return {pose.position, side == Side::front ? pose.yaw_rad : pose.yaw_rad + std::numbers::pi};
}

class Joining {
 public:
  Joining(const Submap& submap, Union& known)
      : submap_(submap), known_(known), joints_(joints_of(known)) {}

  void join_all() {
    const std::size_t before = known_.edges.size();
    std::vector<std::uint32_t> by_x;  // nodes that can be joined, from the left
    for (std::uint32_t n = 0; n < known_.nodes.size(); ++n) {
      const double error_m = submap_.sources[known_.source[n]].frame_error_m;
      if (joints_[n].margin_m > 0.0 && std::isfinite(error_m)) {
        by_x.push_back(n);
        widest_m_ = std::max(widest_m_, joints_[n].margin_m);
        furthest_m_ = std::max(furthest_m_, joints_[n].reach_m);
      }
    }
    std::ranges::sort(by_x, [&](std::uint32_t a, std::uint32_t b) {
      return x_of(a) != x_of(b) ? x_of(a) < x_of(b) : a < b;
    });
    for (std::size_t i = 0; i < by_x.size(); ++i) {
      const double reach_m = std::max(0.5 * (joints_[by_x[i]].margin_m + widest_m_),
                                      joints_[by_x[i]].reach_m + furthest_m_);
      for (std::size_t k = i + 1; k < by_x.size(); ++k) {
        if (x_of(by_x[k]) - x_of(by_x[i]) > reach_m) {
          break;
        }
        look_at(std::min(by_x[i], by_x[k]), std::max(by_x[i], by_x[k]));
      }
    }
    std::ranges::sort(known_.edges.begin() + static_cast<std::ptrdiff_t>(before),
                      known_.edges.end(),
                      {},
                      [](const SubmapEdge& edge) {
                        const auto& [a, b] = edge.ends;
                        return std::array{2 * std::uint64_t{a.node} + at(a.side),
                                          2 * std::uint64_t{b.node} + at(b.side)};
                      });
  }

 private:
  [[nodiscard]] double x_of(std::uint32_t node) const {
    return known_.nodes[node].pose.position.x_m;
  }

  void count(std::size_t pairs) {
    pairs_ += pairs;
    if (pairs_ > kMostPairs) {
      throw std::length_error("the submaps have more than " + std::to_string(kMostPairs) +
                              " pairs of nodes, or of edges at them, that might be joined; merge "
                              "fewer of them");
    }
  }

  void look_at(std::uint32_t u, std::uint32_t v) {
    count(1);
    const double reach_m = std::max(0.5 * (joints_[u].margin_m + joints_[v].margin_m),
                                    joints_[u].reach_m + joints_[v].reach_m);
    if (known_.source[u] == known_.source[v] ||
        distance(known_.nodes[u].pose.position, known_.nodes[v].pose.position) > reach_m) {
      return;
    }
    const Source& a = submap_.sources[known_.source[u]];
    const Source& b = submap_.sources[known_.source[v]];
    const FrameError error{a.frame_error_m + b.frame_error_m,
                           a.frame_error_rad + b.frame_error_rad};
    for (const Side left_by : {Side::back, Side::front}) {
      for (const Side entered_by : {Side::back, Side::front}) {
        join({u, left_by}, {v, entered_by}, error);
      }
    }
  }

  void join(EdgeEnd from, EdgeEnd to, const FrameError& error) {
    const Joint& first = joints_[from.node];
    const Joint& second = joints_[to.node];
    if (!first.leads[at(from.side)] || !second.leads[at(to.side)]) {
      return;
    }
    const Pose begin = leaving(known_.nodes[from.node].pose, from.side);
    const Pose end = leaving(known_.nodes[to.node].pose, opposite(to.side));
    const std::optional<JoinShape> shape = join_shape(begin, end, error, submap_.agent);
    if (!shape) {
      return;
    }
    double margin_m = join_margin({begin, first.margin_m}, {end, second.margin_m}, *shape);
    const std::vector<Stretch>& ahead = first.edges[at(from.side)];
    const std::vector<Stretch>& behind = second.edges[at(to.side)];
    count(ahead.size() * (behind.size() + 1) + behind.size());
    for (const Stretch& one : ahead) {
      margin_m = std::max(margin_m, margin_beside(begin, end, *shape, &one, nullptr));
    }
    for (const Stretch& other : behind) {
      margin_m = std::max(margin_m, margin_beside(begin, end, *shape, nullptr, &other));
      for (const Stretch& one : ahead) {
        margin_m = std::max(margin_m, margin_beside(begin, end, *shape, &one, &other));
      }
    }
    if (margin_m > 0.0) {
      if (++known_.joins > kMostJoins) {
        throw std::length_error("the submaps have more than " + std::to_string(kMostJoins) +
                                " joins; merge fewer of them");
      }
      known_.edges.push_back({{from, to}, margin_m});
    }
  }

  const Submap& submap_;
  Union& known_;
  std::vector<Joint> joints_;
  double widest_m_ = 0.0;
  double furthest_m_ = 0.0;
  std::size_t pairs_ = 0;
};

}  // namespace

Federation federate(const Submap& submap) {
  Federation result;
  result.known = numbered_through(submap);
  Joining(submap, result.known).join_all();
  const bool turns = submap.agent.min_turn_radius_m == 0.0;
  result.way = widest_way(result.known.nodes, result.known.edges, turns);
  for (const Source& source : submap.sources) {
    result.own.push_back(widest_way(source.nodes, source.edges, turns).margin_m);
  }
  return result;
}

}  // namespace tcert::federation
