#include "analysis/study/terrain/baselines.hpp"
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <terrain/routes.hpp>

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

/// Posterior of the sparse process on a coarse lattice, read between its points.
class SparseField {
 public:
  SparseField(const Grid& grid, const SparseRrtOptions& o) : grid_(grid), prior_(o.prior) {
    double x = 0.0;
    while (x < grid.rows + o.inducing_spacing) {
      double y = 0.0;
      while (y < grid.columns + o.inducing_spacing) {
        inducing_.emplace_back(x, y);
        y += o.inducing_spacing;
      }
      x += o.inducing_spacing;
    }
    const auto m = static_cast<Eigen::Index>(inducing_.size());
    k_mm_.resize(m, m);
    for (Eigen::Index i = 0; i < m; ++i) {
      k_mm_.col(i) = row(inducing_[static_cast<std::size_t>(i)]);
      k_mm_(i, i) += 1e-8 * prior_.variance;
    }
    precision_ = k_mm_;
    moment_ = Eigen::VectorXd::Zero(m);
    prior_factor_.compute(k_mm_);
  }

  void add(const Measurement& measurement) {
    const Eigen::VectorXd k = row(measurement.at);
    precision_ += k * k.transpose() / prior_.noise_variance;
    moment_ += k * ((measurement.value - prior_.mean) / prior_.noise_variance);
  }

  void update() {
    const Eigen::LLT<Eigen::MatrixXd> factor(precision_);
    const Eigen::VectorXd weights = factor.solve(moment_);
    const int rows = grid_.rows / kStep + 2;
    columns_ = grid_.columns / kStep + 2;
    mean_.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns_));
    deviation_.resize(mean_.size());
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns_; ++j) {
        const Eigen::VectorXd k =
            row({static_cast<double>(i * kStep), static_cast<double>(j * kStep)});
        const std::size_t at = place(i, j);
        mean_[at] = prior_.mean + k.dot(weights);
        const double variance = prior_.variance - prior_factor_.matrixL().solve(k).squaredNorm() +
                                factor.matrixL().solve(k).squaredNorm();
        deviation_[at] = std::sqrt(std::max(variance, 0.0));
      }
    }
  }

  [[nodiscard]] double mean(const Position& p) const { return read(mean_, p); }
  [[nodiscard]] double deviation(const Position& p) const { return read(deviation_, p); }

 private:
  static constexpr int kStep = 8;

  /// Of point (i, j) of the coarse lattice.
  [[nodiscard]] std::size_t place(int i, int j) const noexcept {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(j);
  }

  [[nodiscard]] Eigen::VectorXd row(const Position& p) const {
    Eigen::VectorXd k(static_cast<Eigen::Index>(inducing_.size()));
    const double scale = -0.5 / (prior_.length_scale * prior_.length_scale);
    for (Eigen::Index i = 0; i < k.size(); ++i) {
      const double d2 = (p - inducing_[static_cast<std::size_t>(i)]).squaredNorm();
      k(i) = prior_.variance * std::exp(scale * d2);
    }
    return k;
  }

  [[nodiscard]] double read(const std::vector<double>& values, const Position& p) const {
    const double x = std::clamp(p.x(), 0.0, grid_.rows - 1.0) / kStep;
    const double y = std::clamp(p.y(), 0.0, grid_.columns - 1.0) / kStep;
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const double u = x - i;
    const double v = y - j;
    const auto at = [&](int a, int b) { return values[place(a, b)]; };
    return (1 - u) * ((1 - v) * at(i, j) + v * at(i, j + 1)) +
           u * ((1 - v) * at(i + 1, j) + v * at(i + 1, j + 1));
  }

  Grid grid_;
  GpPrior prior_;
  int columns_ = 0;
  std::vector<Position> inducing_;
  Eigen::MatrixXd k_mm_;
  Eigen::MatrixXd precision_;
  Eigen::VectorXd moment_;
  Eigen::LLT<Eigen::MatrixXd> prior_factor_;
  std::vector<double> mean_;
  std::vector<double> deviation_;
};

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
  SparseField field(terrain.grid, options);
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
