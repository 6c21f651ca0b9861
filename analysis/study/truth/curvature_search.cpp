#include "analysis/study/truth/curvature_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <stdexcept>

#include "datasets/worlds/region_distance.hpp"

namespace tcert::study {
namespace {

constexpr double kMostPoses = 33'554'432.0;  // about 1 GB
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = 0xffff'ffffU;

/// An arc from the origin along +x with the points at which its clearance is looked up.
struct Move {
  double curvature_per_m = 0.0;
  double worth_m = 0.0;
  double spacing_m = 0.0;
  std::vector<Pose> points;  ///< The last is the end.
};

struct SearchNode {
  Pose pose;
  std::uint32_t parent = kNone;
  std::uint16_t move = 0;
  float value = 0.0F;
};

struct Entry {
  float value = 0.0F;
  std::uint32_t steps = 0;
  std::uint32_t node = 0;
};

bool operator<(const Entry& a, const Entry& b) {  // the greatest comes first
  if (a.value != b.value) {
    return a.value < b.value;
  }
  return a.steps != b.steps ? a.steps > b.steps : a.node > b.node;
}

class Search {
 public:
  Search(const World& world,
         const ClearanceTable& table,
         const std::vector<std::uint32_t>& steps,
         const CurvatureQuery& query)
      : world_(world), table_(table), steps_(steps), query_(query) {
    const Point size = world.bounds.high - world.bounds.low;
    const double columns = std::ceil(size.x_m / query.cell_m);
    const double rows = std::ceil(size.y_m / query.cell_m);
    if (!(columns * rows * query.headings <= kMostPoses)) {
      throw std::invalid_argument("world '" + world.name +
                                  "': too large for the search with a turning limit; expected a "
                                  "larger cell, or no curvature");
    }
    columns_ = static_cast<std::size_t>(columns);
    seen_.assign(
        columns_ * static_cast<std::size_t>(rows) * static_cast<std::size_t>(query.headings),
        false);
    make_moves();
  }

  [[nodiscard]] std::vector<Arc> run() {
    add_sources();
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      const SearchNode node = nodes_[entry.node];
      if (node.move == kArrived) {
        return trace(entry.node);
      }
      const std::size_t cell = cell_of(node.pose);
      if (seen_[cell]) {
        continue;
      }
      seen_[cell] = true;
      expand(entry.node);
    }
    return {};
  }

 private:
  static constexpr std::uint16_t kArrived = 0xffffU;

  void make_moves() {
    const double length = 1.5 * query_.cell_m;
    const auto add = [&](double curvature, double worth) {
      Move move{curvature, worth, 0.0, {}};
      constexpr int kPoints = 4;
      move.spacing_m = length / kPoints;
      for (int i = 1; i <= kPoints; ++i) {
        move.points.push_back(pose_at({Pose{}, curvature, length}, i * move.spacing_m));
      }
      moves_.push_back(std::move(move));
    };
    add(0.0, kInfinity);
    for (std::size_t k = 0; k < query_.radii_m.size(); ++k) {
      if (query_.worth_m[k] > query_.above_m) {
        add(1.0 / query_.radii_m[k], query_.worth_m[k]);
        add(-1.0 / query_.radii_m[k], query_.worth_m[k]);
      }
    }
  }

  [[nodiscard]] double slack_at(Point p) const {
    return clearance_slack(table_.at(p), query_.body_width_m, query_.convention);
  }

  [[nodiscard]] std::size_t cell_of(const Pose& pose) const {
    const auto column =
        static_cast<std::size_t>((pose.position.x_m - world_.bounds.low.x_m) / query_.cell_m);
    const auto row =
        static_cast<std::size_t>((pose.position.y_m - world_.bounds.low.y_m) / query_.cell_m);
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double turns = pose.yaw_rad / kTurn;
    const auto heading = static_cast<std::size_t>(
        std::min((turns - std::floor(turns)) * query_.headings, query_.headings - 0.5));
    return (row * columns_ + column) * static_cast<std::size_t>(query_.headings) + heading;
  }

  void push(const Pose& pose, std::uint32_t parent, std::uint16_t move, double value) {
    const auto kept = static_cast<float>(std::min(value, query_.enough_m));
    nodes_.push_back({pose, parent, move, kept});
    queue_.push({kept,
                 steps_[table_.nearest(pose.position)],
                 static_cast<std::uint32_t>(nodes_.size() - 1)});
  }

  void add_sources() {
    const auto add = [&](Point p) {
      const double value = slack_at(p);
      if (value > query_.above_m) {
        for (int k = 0; k < query_.headings; ++k) {
          push({p, 2.0 * std::numbers::pi * k / query_.headings}, kNone, 0, value);
        }
      }
    };
    const Extent extent = extent_of(*world_.start);
    const Point middle = 0.5 * (extent.low + extent.high);
    const double step = query_.cell_m;
    const auto across = static_cast<int>(0.5 * (extent.high.x_m - extent.low.x_m) / step);
    const auto along = static_cast<int>(0.5 * (extent.high.y_m - extent.low.y_m) / step);
    for (int y = -along; y <= along; ++y) {
      for (int x = -across; x <= across; ++x) {
        const Point p = middle + step * Point{static_cast<double>(x), static_cast<double>(y)};
        if (contains(*world_.start, p)) {
          add(p);
        }
      }
    }
  }

  void expand(std::uint32_t index) {
    const Pose from = nodes_[index].pose;
    const auto limit = static_cast<double>(nodes_[index].value);
    const Point u = direction(from.yaw_rad);
    for (std::size_t m = 0; m < moves_.size(); ++m) {
      const Move& move = moves_[m];
      double value = std::min(limit, move.worth_m);
      bool arrives = false;
      Pose pose;
      for (const Pose& local : move.points) {
        const Point p = local.position;
        pose = {from.position + Point{u.x_m * p.x_m - u.y_m * p.y_m, u.y_m * p.x_m + u.x_m * p.y_m},
                from.yaw_rad + local.yaw_rad};
        value = std::min(value, slack_at(pose.position));
        if (value <= query_.above_m) {
          break;
        }
        if (contains(*world_.goal, pose.position)) {
          arrives = true;
          break;
        }
      }
      if (value <= query_.above_m) {
        continue;
      }
      if (arrives) {
        // A node of its own at the start of the last arc; the arc follows from `last_`.
        last_.push_back({pose, index, static_cast<std::uint16_t>(m), 0.0F});
        push(pose, static_cast<std::uint32_t>(last_.size() - 1), kArrived, value);
      } else if (!seen_[cell_of(pose)]) {
        push(pose, index, static_cast<std::uint16_t>(m), value);
      }
    }
  }

  /// Arcs up to an arrival; the last is cut at the point at which it was seen to be in G.
  [[nodiscard]] std::vector<Arc> trace(std::uint32_t arrival) const {
    const SearchNode& last = last_[nodes_[arrival].parent];
    std::vector<Arc> arcs{arc_of(last.parent, last.move)};
    double& length = arcs.front().length_m;
    for (const Pose& local : moves_[last.move].points) {
      (void)local;
      length += moves_[last.move].spacing_m;
      if (contains(*world_.goal, pose_at(arcs.front(), length).position)) {
        break;
      }
    }
    std::uint32_t index = last.parent;
    while (nodes_[index].parent != kNone) {
      const SearchNode& node = nodes_[index];
      Arc arc = arc_of(node.parent, node.move);
      arc.length_m =
          moves_[node.move].spacing_m * static_cast<double>(moves_[node.move].points.size());
      arcs.push_back(arc);
      index = node.parent;
    }
    std::reverse(arcs.begin(), arcs.end());
    return arcs;
  }

  [[nodiscard]] Arc arc_of(std::uint32_t from, std::uint16_t move) const {
    return {nodes_[from].pose, moves_[move].curvature_per_m, 0.0};
  }

  const World& world_;
  const ClearanceTable& table_;
  const std::vector<std::uint32_t>& steps_;
  const CurvatureQuery& query_;
  std::size_t columns_ = 0;
  std::vector<Move> moves_;
  std::vector<SearchNode> nodes_;
  std::vector<SearchNode> last_;  // parent and move of each arrival
  std::vector<bool> seen_;
  std::priority_queue<Entry> queue_;
};

}  // namespace

std::vector<Arc> search_path(const World& world,
                             const ClearanceTable& table,
                             const std::vector<std::uint32_t>& steps,
                             const CurvatureQuery& query) {
  return Search(world, table, steps, query).run();
}

}  // namespace tcert::study
