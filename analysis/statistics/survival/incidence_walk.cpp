#include <cmath>
#include <cstddef>
#include <statistics/survival/incidence_walk.hpp>
#include <statistics/survival/influence_sums.hpp>

namespace tcert::statistics {
namespace {

/// Times and risk sets, added up from the last time so that the smallest are the most exact. Rows
/// are counted beside their weights, so that a set that empties leaves no rounding behind.
void fill_incidence_sets(const IncidenceRows& rows, IncidenceCurves& curves) {
  const auto& [start, stop, event] = *rows.outcome;
  for (const std::uint32_t row : rows.stops) {
    if (curves.time.empty() || curves.time.back() != stop[row]) {
      curves.time.push_back(stop[row]);
    }
  }
  const std::vector<double> zero(curves.time.size(), 0.0);
  curves.at_risk = zero;
  curves.censored = zero;
  curves.event_free.events = zero;
  for (IncidenceCurve& curve : curves.causes) {
    curve.events = zero;
  }
  double later = 0.0;
  std::size_t later_rows = 0;
  std::size_t entered = rows.starts.size();
  std::size_t last = rows.stops.size();
  for (std::size_t k = curves.time.size(); k-- > 0;) {
    double stopped = 0.0;
    std::size_t stopped_rows = 0;
    for (; last > 0 && stop[rows.stops[last - 1]] == curves.time[k]; --last) {
      const std::uint32_t row = rows.stops[last - 1];
      const std::uint32_t cause = (*rows.cause)[row];
      (cause == 0 ? curves.censored : curves.causes[cause - 1].events)[k] += rows.weight(row);
      stopped_rows += rows.weight(row) > 0.0 ? 1 : 0;
    }
    for (const IncidenceCurve& curve : curves.causes) {
      stopped += curve.events[k];
    }
    stopped += curves.censored[k];
    for (; entered > 0 && start[rows.starts[entered - 1]] >= curves.time[k]; --entered) {
      const double weight = rows.weight(rows.starts[entered - 1]);
      later -= weight;
      later_rows -= weight > 0.0 ? 1 : 0;
    }
    later = (later_rows == 0 ? 0.0 : later) + stopped;
    later_rows += stopped_rows;
    curves.at_risk[k] = later;
  }
}

/// What all causes share: with S the event-free probability, the sum H of d / (n (n - d)) over the
/// events of any cause. A row that entered at H = h has the influence H - h on log S while it is at
/// risk, less 1 / (n - d) if it then has its event.
struct Hazard {
  double survival = 1.0;  ///< Just before the present time.
  double sum = 0.0;       ///< H, the present time included once advanced.
  double of_event = 0.0;  ///< 1 / (n - d) at the present time.
};

/// Incidence P of a cause and its variance. V is the sum of S d_k / n (H before - 1 / n). A row at
/// risk has the influence (V - V at entry) - h (P - P at entry) on P; its event of the cause adds
/// S / n; thereafter its influence on log S, fixed now, times the further rise of P.
class CauseWalk {
 public:
  explicit CauseWalk(std::size_t clusters) : sums_(clusters) {}

  void enter(std::uint32_t cluster, double weight, const Hazard& hazard) {
    sums_.add(cluster,
              {weight * (hazard.sum * probability_ - drift_), -weight * hazard.sum, weight});
  }
  /// Before the hazard advances.
  void advance(double events, double at_risk, const Hazard& hazard) {
    const double rise = hazard.survival * events / at_risk;
    drift_ += rise * (hazard.sum - 1.0 / at_risk);
    probability_ += rise;
    jump_ = hazard.survival / at_risk;
  }
  /// After the hazard has advanced.
  void leave(std::uint32_t cluster, double weight, const Hazard& hazard, bool event, bool of_this) {
    const double slope = hazard.sum - (event ? hazard.of_event : 0.0);
    sums_.add(cluster,
              {weight * (drift_ + (of_this ? jump_ : 0.0) - slope * probability_),
               weight * slope,
               -weight});
  }
  void write(IncidenceCurve& curve) const {
    curve.probability.push_back(probability_);
    curve.std_error.push_back(std::sqrt(sums_.sum_of_squares(probability_, drift_)));
  }

 private:
  InfluenceSums sums_;
  double probability_ = 0.0;
  double drift_ = 0.0;
  double jump_ = 0.0;
};

/// Walks up the curves of one group.
class GroupWalk {
 public:
  GroupWalk(const IncidenceRows& rows, std::size_t clusters, IncidenceCurves& curves)
      : rows_(&rows),
        curves_(&curves),
        free_(clusters),
        causes_(curves.causes.size(), CauseWalk(clusters)) {
    if (rows.starts.empty()) {
      for (const std::uint32_t row : rows.stops) {
        enter(row);
      }
    }
  }

  void run() {
    const auto& [start, stop, event] = *rows_->outcome;
    std::size_t entered = 0;
    std::size_t stopped = 0;
    for (std::size_t k = 0; k < curves_->time.size(); ++k) {
      const double time = curves_->time[k];
      for (; entered < rows_->starts.size() && start[rows_->starts[entered]] < time; ++entered) {
        enter(rows_->starts[entered]);
      }
      advance(k);
      for (; stopped < rows_->stops.size() && stop[rows_->stops[stopped]] == time; ++stopped) {
        leave(rows_->stops[stopped]);
      }
      write();
    }
  }

 private:
  void enter(std::uint32_t row) {
    const double weight = rows_->weight(row);
    free_.add(rows_->cluster(row), {-weight * hazard_.sum, 0.0, weight});
    for (CauseWalk& cause : causes_) {
      cause.enter(rows_->cluster(row), weight, hazard_);
    }
  }

  void advance(std::size_t k) {
    const double at_risk = curves_->at_risk[k];
    double events = 0.0;
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      const double of_cause = curves_->causes[c].events[k];
      events += of_cause;
      if (at_risk > 0.0) {
        causes_[c].advance(of_cause, at_risk, hazard_);
      }
    }
    hazard_.of_event = 0.0;
    if (!(events > 0.0)) {
      return;
    }
    const double left = at_risk - events;
    hazard_.survival *= left / at_risk;
    if (left > 0.0) {  // else nothing changes any more
      hazard_.sum += events / (at_risk * left);
      hazard_.of_event = 1.0 / left;
    }
  }

  void leave(std::uint32_t row) {
    const double weight = rows_->weight(row);
    const std::uint32_t of = (*rows_->cause)[row];
    const double slope = hazard_.sum - (of != 0 ? hazard_.of_event : 0.0);
    free_.add(rows_->cluster(row), {weight * slope, 0.0, -weight});
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      causes_[c].leave(rows_->cluster(row), weight, hazard_, of != 0, of == c + 1);
    }
  }

  void write() {
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      causes_[c].write(curves_->causes[c]);
    }
    curves_->event_free.probability.push_back(hazard_.survival);
    curves_->event_free.std_error.push_back(
        hazard_.survival > 0.0
            ? hazard_.survival * std::sqrt(free_.sum_of_squares(0.0, hazard_.sum))
            : 0.0);
  }

  const IncidenceRows* rows_;
  IncidenceCurves* curves_;
  InfluenceSums free_;  ///< Of log S.
  std::vector<CauseWalk> causes_;
  Hazard hazard_;
};

}  // namespace

void walk_incidence(const IncidenceRows& rows, IncidenceCurves& curves) {
  fill_incidence_sets(rows, curves);
  const table::Factor* const cluster = rows.options->cluster;
  GroupWalk(rows, cluster == nullptr ? rows.outcome->rows() : cluster->levels.size(), curves).run();
}

}  // namespace tcert::statistics
