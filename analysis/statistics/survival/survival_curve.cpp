#include <statistics/survival/survival_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/basics/time_order.hpp>
#include <statistics/survival/cluster_conditions.hpp>
#include <statistics/survival/influence_sums.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

struct CurveRows {
  const SurvivalOutcome* outcome = nullptr;
  const CurveOptions* options = nullptr;
  std::span<const std::uint32_t> stops;
  std::span<const std::uint32_t> starts;
  bool robust = false;

  [[nodiscard]] double weight(std::uint32_t row) const {
    return options->weights.empty() ? 1.0 : options->weights[row];
  }
};

/// Risk sets, added up from the last time so that the smallest are the most exact. With late entry
/// rows are counted beside their weights, so that a set that empties leaves no rounding behind.
void fill_risk_sets(const CurveRows& rows, std::vector<SurvivalPoint>& points) {
  const auto& [start, stop, event] = *rows.outcome;
  points.reserve(rows.stops.size());  // its pages are not touched before they are used
  for (const std::uint32_t row : rows.stops) {
    if (points.empty() || points.back().time != stop[row]) {
      points.emplace_back().time = stop[row];
    }
    (event[row] != 0 ? points.back().events : points.back().censored) += rows.weight(row);
  }
  if (points.size() < points.capacity() / 2) {
    points.shrink_to_fit();
  }
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

/// Change of a cumulative hazard by the events of a time and its derivatives: by the weight of a
/// row that has its event then, and by that of one that is at risk.
struct HazardStep {
  double hazard = 0.0;
  double variance = 0.0;
  double by_event = 0.0;
  double by_risk = 0.0;
};

HazardStep nelson_aalen(double events, double at_risk) {
  return {
      events / at_risk, events / (at_risk * at_risk), 1.0 / at_risk, -events / (at_risk * at_risk)};
}

/// As if the `rows` events, of the same weight each, came one after another.
HazardStep fleming_harrington(double events, double at_risk, std::size_t rows) {
  HazardStep step;
  const auto m = static_cast<double>(rows);
  for (std::size_t k = 0; k < rows; ++k) {
    const double part = static_cast<double>(k) / m;
    const double left = at_risk - part * events;
    step.hazard += events / m / left;
    step.variance += events / m / (left * left);
    step.by_event += 1.0 / m / left + events / m * part / (left * left);
    step.by_risk -= events / m / (left * left);
  }
  return step;
}

/// The same of -log of the product-limit estimate.
HazardStep product_limit(double events, double at_risk) {
  const double left = at_risk - events;
  return {-std::log1p(-events / at_risk),
          events / (at_risk * left),
          1.0 / left,
          -events / (at_risk * left)};
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

void check(const SurvivalOutcome& outcome, const CurveOptions& options) {
  const std::size_t n = outcome.rows();
  if ((!options.weights.empty() && options.weights.size() != n) ||
      (options.groups != nullptr && options.groups->rows() != n) ||
      (options.cluster != nullptr && options.cluster->rows() != n)) {
    throw std::invalid_argument("survival curve: columns of different length");
  }
  if (!std::all_of(options.weights.begin(), options.weights.end(), [](double weight) {
        return std::isfinite(weight) && weight >= 0.0;
      })) {
    throw std::invalid_argument("survival curve: a weight is negative or not finite");
  }
  if (options.cluster != nullptr &&
      std::any_of(options.cluster->codes.begin(), options.cluster->codes.end(), [&](auto code) {
        return code >= options.cluster->levels.size();
      })) {
    throw std::invalid_argument("survival curve: a cluster is missing");
  }
}

/// The influences of a single cluster sum to 0, which is no variance.
void forget_variances(SurvivalCurve& curve) {
  for (SurvivalPoint& point : curve.points) {
    point.log_std_error = std::numeric_limits<double>::quiet_NaN();
    point.hazard_std_error = std::numeric_limits<double>::quiet_NaN();
  }
}

void name_conditions(SurvivalCurve& curve) {
  if (curve.rows == 0) {
    curve.conditions.push_back({ConditionKind::no_rows, ConditionSeverity::error, {}, curve.group});
  } else if (std::none_of(curve.points.begin(), curve.points.end(), [](const auto& point) {
               return point.events > 0.0;
             })) {
    curve.conditions.push_back(
        {ConditionKind::no_events, ConditionSeverity::warning, {}, curve.group});
  }
}

}  // namespace

double SurvivalPoint::std_error() const noexcept { return survival * log_std_error; }

double SurvivalCurve::time_near(double time) const noexcept {
  return step_time(points, time, [](const SurvivalPoint& point) { return point.time; });
}

const SurvivalPoint* SurvivalCurve::at(double time) const noexcept {
  const auto after = std::upper_bound(
      points.begin(), points.end(), time_near(time), [](double value, const SurvivalPoint& point) {
        return value < point.time;
      });
  return after == points.begin() ? nullptr : &*(after - 1);
}

std::vector<SurvivalCurve> survival_curves(const SurvivalOutcome& outcome,
                                           const CurveOptions& options) {
  check(outcome, options);
  const std::size_t groups = options.groups == nullptr ? 1 : options.groups->levels.size();
  const TimeOrder order = time_order(outcome,
                                     options.groups == nullptr ? std::span<const std::uint32_t>{}
                                                               : std::span(options.groups->codes),
                                     groups);
  const bool fractional = std::any_of(options.weights.begin(),
                                      options.weights.end(),
                                      [](double weight) { return weight != std::floor(weight); });
  std::vector<SurvivalCurve> curves(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    const CurveRows rows{&outcome,
                         &options,
                         order.stops_of(g),
                         order.starts_of(g),
                         options.cluster != nullptr || fractional};
    SurvivalCurve& curve = curves[g];
    curve.group = options.groups == nullptr ? std::string() : options.groups->levels[g];
    curve.rows = rows.stops.size();
    fill_risk_sets(rows, curve.points);
    CurveWalk walk(rows,
                   options.cluster != nullptr ? options.cluster->levels.size()
                   : rows.starts.empty()      ? rows.stops.size()
                                              : outcome.rows());
    for (SurvivalPoint& point : curve.points) {
      walk.step(point);
    }
    name_conditions(curve);
    if (options.cluster != nullptr) {
      const std::size_t clusters = count_clusters(*options.cluster, rows.stops);
      add_group_conditions(clusters, curve.group, curve.conditions);
      if (clusters == 1) {
        forget_variances(curve);
      }
    }
  }
  return curves;
}

}  // namespace tcert::statistics
