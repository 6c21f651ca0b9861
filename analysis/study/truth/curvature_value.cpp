#include "analysis/study/truth/curvature_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/study/truth/clearance_table.hpp"
#include "analysis/study/truth/curvature_search.hpp"
#include "analysis/study/truth/stretched_path.hpp"

namespace tcert::study {
namespace {

constexpr double kClearanceTolerance = 1e-4;  // of measured clearances
constexpr double kLeastRadius = 0.02;
constexpr int kSteps = 4;

/// What a path is really worth.
CurvatureValue measured(std::vector<Arc> path,
                        const ObstacleDistance& obstacles,
                        const Robot& robot,
                        SlackConvention convention) {
  CurvatureValue value;
  double clearance = std::numeric_limits<double>::infinity();
  double radius = std::numeric_limits<double>::infinity();
  for (const Arc& arc : path) {
    clearance = std::min(clearance, arc_clearance(arc, obstacles, kClearanceTolerance));
    radius = std::min(radius, 1.0 / std::abs(arc.curvature_per_m));
  }
  if (path.empty() || clearance <= 0.0) {
    return value;
  }
  value.clearance_m = clearance;
  value.radius_m = radius;
  value.slack_m = std::min(clearance_slack(clearance, robot.body_width_m, convention),
                           radius - robot.min_turn_radius_m);
  value.path = std::move(path);
  return value;
}

class Rounds {
 public:
  Rounds(const World& world, const Robot& robot, double upper, const CurvatureOptions& options)
      : world_(world),
        robot_(robot),
        obstacles_(world),
        table_(world, obstacles_, options.table_m),
        options_(options),
        steps_(table_.steps_to(*world.goal, clearance_for(upper) - 2.0 * options.table_m)) {
    query_.convention = options.convention;
    query_.body_width_m = robot.body_width_m;
    query_.cell_m = options.cell_m;
    query_.headings = options.headings;
    query_.enough_m = upper;
  }

  /// Asks for a path worth more than the best so far, with arcs worth from `low` to `high`.
  void ask(double low, double high) {
    query_.radii_m.clear();
    query_.worth_m.clear();
    for (int k = 0; k <= kSteps; ++k) {
      const double worth = high - (high - low) * k / kSteps;
      const double radius = robot_.min_turn_radius_m + worth;
      if (radius >= kLeastRadius) {
        query_.radii_m.push_back(radius);
        query_.worth_m.push_back(worth);
      }
    }
    if (!query_.radii_m.empty()) {
      query_.radii_m.push_back(2.0 * query_.radii_m.front());
      query_.worth_m.push_back(query_.radii_m.back() - robot_.min_turn_radius_m);
    }
    // Outside of the bounds the clearance is 0: no path of no more than that leaves them.
    query_.above_m =
        std::max(best_.slack_m, clearance_slack(0.0, robot_.body_width_m, options_.convention));
    CurvatureValue value = measured(
        search_path(world_, table_, steps_, query_), obstacles_, robot_, options_.convention);
    if (value.slack_m > best_.slack_m) {
      best_ = std::move(value);
    }
  }

  /// Asks for a better path by stretching the best so far.
  void stretch() {
    CurvatureValue value =
        measured(stretched_path(world_, robot_, options_.path_cell_m, best_.path),
                 obstacles_,
                 robot_,
                 options_.convention);
    if (value.slack_m > best_.slack_m) {
      best_ = std::move(value);
    }
  }

  [[nodiscard]] const CurvatureValue& best() const noexcept { return best_; }

 private:
  [[nodiscard]] double clearance_for(double slack) const {
    const double half = options_.convention == SlackConvention::width ? 0.5 * slack : slack;
    return half + 0.5 * robot_.body_width_m;
  }

  const World& world_;
  const Robot& robot_;
  ObstacleDistance obstacles_;
  ClearanceTable table_;
  CurvatureOptions options_;
  std::vector<std::uint32_t> steps_;
  CurvatureQuery query_;
  CurvatureValue best_;
};

}  // namespace

CurvatureValue curvature_value(const World& world,
                               const Robot& robot,
                               double upper_m,
                               const CurvatureOptions& options) {
  require_regions(world);
  if (!std::isfinite(upper_m)) {
    return {};
  }
  Rounds rounds(world, robot, upper_m, options);
  // From 0 up if the body fits at all; below it only if that leads nowhere.
  double low = std::min(0.0, upper_m);
  double high = upper_m;
  rounds.ask(low, high);
  if (rounds.best().slack_m < low) {
    high = low;
    low = std::max(-robot.body_width_m, kLeastRadius - robot.min_turn_radius_m);
    rounds.ask(std::min(low, high), high);
  }
  for (int round = 1; round < options.rounds; ++round) {
    const double found = rounds.best().slack_m;
    const double gap = (high - low) / kSteps;
    if (!std::isfinite(found) || found >= upper_m - kClearanceTolerance) {
      break;
    }
    low = found;
    high = std::min(found + gap, upper_m);
    rounds.ask(low, high);
  }
  if (options.path_cell_m > 0.0 && rounds.best().slack_m < upper_m - kClearanceTolerance) {
    rounds.stretch();
  }
  return rounds.best();
}

}  // namespace tcert::study
