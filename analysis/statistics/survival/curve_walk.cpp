#include <cmath>
#include <cstddef>
#include <limits>
#include <statistics/survival/curve_walk.hpp>
#include <statistics/survival/hazard_step.hpp>
#include <statistics/survival/influence_sums.hpp>

namespace tcert::statistics {
namespace {

/// A point per distinct stop, with what ends there.
void fill_stops(const CurveRows& rows, std::vector<SurvivalPoint>& points) {
  const auto& stop = rows.outcome->stop;
  points.reserve(rows.stops.size());  // its pages are not touched before they are used
  for (const std::uint32_t row : rows.stops) {
    if (points.empty() || points.back().time != stop[row]) {
      points.emplace_back().time = stop[row];
    }
    (rows.outcome->event[row] != 0 ? points.back().events : points.back().censored) +=
        rows.weight(row);
  }
  if (points.size() < points.capacity() / 2) {
    points.shrink_to_fit();
  }
}

/// Risk sets, added up from the last time so that the smallest are the most exact. With late entry
/// rows are counted beside their weights, so that a set that empties leaves no rounding behind.
void fill_risk_sets(const CurveRows& rows, std::vector<SurvivalPoint>& points) {
  const auto& [start, stop, event] = *rows.outcome;
  double later = 0.0;
  std::size_t later_rows = 0;
  std::size_t last = rows.stops.size();
  std::size_t entered = rows.starts.size();
  for (std::size_t k = points.size(); k-- > 0;) {
    SurvivalPoint& point = points[k];
    for (; entered > 0 && start[rows.starts[entered - 1]] >= point.time; --entered) {
      const double weight = rows.weight(rows.starts[entered - 1]);
      later -= weight;
      later_rows -= weight > 0.0 ? 1 : 0;
    }
    if (!rows.starts.empty()) {
      later = later_rows == 0 ? 0.0 : later;
      for (; last > 0 && stop[rows.stops[last - 1]] == point.time; --last) {
        later_rows += rows.weight(rows.stops[last - 1]) > 0.0 ? 1 : 0;
      }
    }
    later += point.events + point.censored;
    point.at_risk = later;
  }
}

/// Robust variance of a cumulative hazard. A row's influence is what its being at risk adds, until
/// it stops, and what its event adds.
class RobustVariance {
 public:
  explicit RobustVariance(std::size_t clusters) : sums_(clusters) {}

  void enter(std::uint32_t cluster, double weight) noexcept {
    sums_.add(cluster, {-weight * by_risk_, 0.0, weight});
  }
  void advance(const HazardStep& step) noexcept {
    by_risk_ += step.by_risk;
    by_event_ = step.by_event;
  }
  void leave(std::uint32_t cluster, double weight, bool event) noexcept {
    sums_.add(cluster, {weight * (by_risk_ + (event ? by_event_ : 0.0)), 0.0, -weight});
  }
  [[nodiscard]] double value() const noexcept { return sums_.sum_of_squares(0.0, by_risk_); }

 private:
  InfluenceSums sums_;
  double by_risk_ = 0.0;
  double by_event_ = 0.0;
};

/// Walks up a curve.
class CurveWalk {
 public:
  CurveWalk(const CurveRows& rows, std::size_t clusters)
      : rows_(&rows),
        survival_variance_(rows.robust ? clusters : 0),
        hazard_variance_(rows.robust ? clusters : 0) {
    if (rows.robust && rows.starts.empty()) {
      for (std::size_t k = 0; k < rows.stops.size(); ++k) {
        enter(k, rows.stops[k]);
      }
    }
  }

  void step(SurvivalPoint& point) {
    const auto& [start, stop, event] = *rows_->outcome;
    if (rows_->robust) {
      for (; entered_ < rows_->starts.size() && start[rows_->starts[entered_]] < point.time;
           ++entered_) {
        enter(rows_->starts[entered_], rows_->starts[entered_]);
      }
    }
    std::size_t last = stopped_;
    std::size_t events = 0;
    const bool needs_rows =
        rows_->robust || rows_->options->hazard == HazardEstimate::fleming_harrington;
    for (; needs_rows && last < rows_->stops.size() && stop[rows_->stops[last]] == point.time;
         ++last) {
      events += event[rows_->stops[last]];
    }
    if (point.events > 0.0) {
      advance(point, events);
    }
    if (rows_->robust) {
      for (std::size_t k = stopped_; k < last; ++k) {
        leave(k, rows_->stops[k]);
      }
    }
    stopped_ = last;
    write(point);
  }

 private:
  [[nodiscard]] std::uint32_t cluster_of(std::size_t at, std::uint32_t row) const {
    if (rows_->options->cluster != nullptr) {
      return rows_->options->cluster->codes[row];
    }
    return rows_->starts.empty() ? static_cast<std::uint32_t>(at) : row;
  }
  void enter(std::size_t at, std::uint32_t row) {
    survival_variance_.enter(cluster_of(at, row), rows_->weight(row));
    hazard_variance_.enter(cluster_of(at, row), rows_->weight(row));
  }
  void leave(std::size_t at, std::uint32_t row) {
    const bool event = rows_->outcome->event[row] != 0;
    survival_variance_.leave(cluster_of(at, row), rows_->weight(row), event);
    hazard_variance_.leave(cluster_of(at, row), rows_->weight(row), event);
  }

  void advance(const SurvivalPoint& point, std::size_t events) {
    const bool tied = rows_->options->hazard == HazardEstimate::fleming_harrington;
    const HazardStep hazard = tied ? fleming_harrington(point.events, point.at_risk, events)
                                   : nelson_aalen(point.events, point.at_risk);
    hazard_ += hazard.hazard;
    hazard_greenwood_ += hazard.variance;
    hazard_variance_.advance(hazard);
    if (rows_->options->survival == SurvivalEstimate::exponential) {
      survival_ = std::exp(-hazard_);
      return;
    }
    survival_ *= (point.at_risk - point.events) / point.at_risk;
    if (point.events < point.at_risk) {
      const HazardStep product = product_limit(point.events, point.at_risk);
      greenwood_ += product.variance;
      survival_variance_.advance(product);
    } else {
      greenwood_ = std::numeric_limits<double>::infinity();
    }
  }

  void write(SurvivalPoint& point) const {
    point.survival = survival_;
    point.cumulative_hazard = hazard_;
    const double hazard = rows_->robust ? hazard_variance_.value() : hazard_greenwood_;
    point.hazard_std_error = std::sqrt(hazard);
    if (rows_->options->survival == SurvivalEstimate::exponential) {
      point.log_std_error = point.hazard_std_error;
    } else if (!rows_->robust) {
      point.log_std_error = std::sqrt(greenwood_);
    } else {
      point.log_std_error = survival_ > 0.0 ? std::sqrt(survival_variance_.value()) : 0.0;
    }
  }

  const CurveRows* rows_;
  RobustVariance survival_variance_;
  RobustVariance hazard_variance_;
  std::size_t entered_ = 0;
  std::size_t stopped_ = 0;
  double survival_ = 1.0;
  double greenwood_ = 0.0;
  double hazard_ = 0.0;
  double hazard_greenwood_ = 0.0;
};

}  // namespace

void walk_curve(const CurveRows& rows, std::vector<SurvivalPoint>& points) {
  fill_stops(rows, points);
  fill_risk_sets(rows, points);
  const table::Factor* const cluster = rows.options->cluster;
  CurveWalk walk(rows,
                 cluster != nullptr    ? cluster->levels.size()
                 : rows.starts.empty() ? rows.stops.size()
                                       : rows.outcome->rows());
  for (SurvivalPoint& point : points) {
    walk.step(point);
  }
}

}  // namespace tcert::statistics
