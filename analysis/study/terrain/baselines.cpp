#include "analysis/study/terrain/baselines.hpp"

#include <algorithm>
#include <cmath>
#include <terrain/routes.hpp>

#include "analysis/study/terrain/sparse_field.hpp"

namespace tcert::terrain {
namespace {

/// Cells that the segment a-b passes, every half cell looked at; a not among them.
template <class Visit>
void along(const Position& a, const Position& b, Visit visit) {
  const double length = (b - a).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * length)));
  Cell before = nearest_cell(a);
  for (int k = 1; k <= steps; ++k) {
    const Cell c = nearest_cell(a + (b - a) * (static_cast<double>(k) / steps));
    if (!(c == before)) {
      visit(c);
      before = c;
    }
  }
}

/// RRT* from one position to another over the field's costs.
class Tree {
 public:
  Tree(const Grid& grid,
       const SparseField& field,
       double threshold,
       const SparseRrtOptions& options,
       const std::function<double()>& uniform)
      : grid_(grid), field_(field), threshold_(threshold), options_(options), uniform_(uniform) {}

  /// The way from `from` to `to`, ends included; straight if no branch came near.
  std::vector<Position> plan(const Position& from, const Position& to) {
    nodes_ = {{from, 0, 0.0}};
    for (int n = 0; n < options_.nodes; ++n) {
      const bool towards_goal = uniform_() < 0.1;
      const double x = uniform_() * (grid_.rows - 1);
      const double y = uniform_() * (grid_.columns - 1);
      grow(towards_goal ? to : Position(x, y));
    }
    std::size_t best = 0;
    double least = cost(from, to);
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
      if ((nodes_[k].at - to).norm() <= options_.rewire) {
        const double through = nodes_[k].cost + cost(nodes_[k].at, to);
        if (through < least) {
          least = through;
          best = k;
        }
      }
    }
    std::vector<Position> way{to};
    for (std::size_t k = best; k != 0; k = nodes_[k].parent) {
      way.push_back(nodes_[k].at);
    }
    way.push_back(from);
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  struct Node {
    Position at;
    std::size_t parent = 0;
    double cost = 0.0;
  };

  [[nodiscard]] double cost(const Position& a, const Position& b) const {
    const double length = (b - a).norm();
    const int pieces = std::max(1, static_cast<int>(length / 4.0));
    double sum = 0.0;
    for (int k = 0; k < pieces; ++k) {
      const Position p = a + (b - a) * ((k + 0.5) / pieces);
      const double shortfall = std::max(0.0, threshold_ - field_.mean(p));
      sum += 1.0 + options_.risk_weight * shortfall / 100.0 +
             options_.uncertainty_weight * field_.deviation(p) / 100.0;
    }
    return length * sum / pieces;
  }

  void grow(const Position& wanted) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
      if ((nodes_[k].at - wanted).squaredNorm() < (nodes_[nearest].at - wanted).squaredNorm()) {
        nearest = k;
      }
    }
    const Eigen::Vector2d step = wanted - nodes_[nearest].at;
    const double length = step.norm();
    if (length == 0.0) {
      return;
    }
    Node node;
    node.at = nodes_[nearest].at + step * std::min(1.0, options_.extend / length);
    node.parent = nearest;
    node.cost = nodes_[nearest].cost + cost(nodes_[nearest].at, node.at);
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      if ((nodes_[k].at - node.at).norm() <= options_.rewire) {
        near.push_back(k);
        const double through = nodes_[k].cost + cost(nodes_[k].at, node.at);
        if (through < node.cost) {
          node.cost = through;
          node.parent = k;
        }
      }
    }
    const std::size_t index = nodes_.size();
    nodes_.push_back(node);
    for (const std::size_t k : near) {
      const double through = node.cost + cost(node.at, nodes_[k].at);
      if (k != node.parent && through < nodes_[k].cost) {
        nodes_[k].parent = index;
        nodes_[k].cost = through;
      }
    }
  }

  Grid grid_;
  const SparseField& field_;
  double threshold_;
  const SparseRrtOptions& options_;
  const std::function<double()>& uniform_;
  std::vector<Node> nodes_;
};

}  // namespace

BaselineResult straight_walk(
    const Terrain& terrain, const CellSet& blocked, double threshold, Cell start, Cell goal) {
  BaselineResult result;
  result.path.push_back(position(start));
  CellSet open(terrain.grid.size(), 1);
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    open[i] = blocked[i] == 0 ? 1 : 0;
  }
  std::vector<Cell> line{start};
  bool clear = true;
  along(position(start), position(goal), [&](Cell c) {
    line.push_back(c);
    clear = clear && open[terrain.grid.index(c)] != 0;
  });
  if (!clear) {
    line = shortest_route(terrain.grid, open, start, goal);
  }
  for (std::size_t k = 1; k < line.size(); ++k) {
    result.path.push_back(position(line[k]));
    result.unsafe_visits += terrain.at(line[k]) < threshold ? 1U : 0U;
  }
  result.reached = !line.empty() && line.back() == goal;
  result.length = clear ? distance(start, goal) : route_length(line);
  result.plans = 1;
  return result;
}

BaselineResult sparse_rrt_walk(const Terrain& terrain,
                               double threshold,
                               Cell start,
                               Cell goal,
                               const SparseRrtOptions& options,
                               const std::function<double()>& uniform) {
  BaselineResult result;
  SparseField field(terrain.grid, options.prior, options.inducing_spacing);
  Position robot = position(start);
  result.path.push_back(robot);
  const Position target = position(goal);
  Tree tree(terrain.grid, field, threshold, options, uniform);
  while (result.plans < static_cast<std::size_t>(options.max_plans)) {
    for (int k = 0; k < options.samples_per_plan; ++k) {
      const double radius = options.sensor_range * std::sqrt(uniform());
      const double angle = 2.0 * M_PI * uniform();
      const Cell c =
          nearest_cell(robot + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      if (terrain.grid.contains(c)) {
        field.add({position(c), terrain.at(c)});
        ++result.samples;
      }
    }
    field.update();
    ++result.plans;
    double left = options.move;
    const std::vector<Position> way = tree.plan(robot, target);
    for (std::size_t k = 1; k < way.size() && left > 0.0; ++k) {
      const double length = (way[k] - robot).norm();
      const Position to =
          length <= left ? way[k] : Position(robot + (way[k] - robot) * (left / length));
      along(
          robot, to, [&](Cell c) { result.unsafe_visits += terrain.at(c) < threshold ? 1U : 0U; });
      const double gone = (to - robot).norm();
      result.length += gone;
      left -= gone;
      robot = to;
      result.path.push_back(robot);
    }
    if ((robot - target).norm() < 0.5) {
      result.reached = true;
      break;
    }
  }
  return result;
}

}  // namespace tcert::terrain
