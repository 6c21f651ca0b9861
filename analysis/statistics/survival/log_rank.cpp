#include <statistics/survival/log_rank.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <statistics/basics/time_order.hpp>
#include <statistics/basics/wald_chi_squared.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// Sums over the event times of one stratum.
class LogRankStratum {
 public:
  LogRankStratum(const SurvivalOutcome& outcome,
                 const table::Factor& groups,
                 std::span<const std::uint32_t> stops,
                 std::span<const std::uint32_t> starts)
      : outcome_(&outcome),
        groups_(&groups),
        stops_(stops),
        starts_(starts),
        at_risk_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(groups.levels.size()))),
        events_(at_risk_) {
    if (starts.empty()) {
      for (const std::uint32_t row : stops) {
        at_risk_(group(row)) += 1.0;
      }
      all_ = static_cast<double>(stops.size());
    }
  }

  template <typename Visit>
  void for_each_event_time(Visit visit) {
    const auto& [start, stop, event] = *outcome_;
    std::size_t entered = 0;
    for (std::size_t first = 0; first < stops_.size();) {
      const double time = stop[stops_[first]];
      std::size_t last = first;
      double events = 0.0;
      for (; last < stops_.size() && stop[stops_[last]] == time; ++last) {
        if (event[stops_[last]] != 0) {
          events_(group(stops_[last])) += 1.0;
          events += 1.0;
        }
      }
      if (events > 0.0) {
        for (; entered < starts_.size() && start[starts_[entered]] < time; ++entered) {
          at_risk_(group(starts_[entered])) += 1.0;
          all_ += 1.0;
        }
        visit(events, all_, events_, at_risk_);
        survival_ *= (all_ - events) / all_;
      }
      for (; first < last; ++first) {
        at_risk_(group(stops_[first])) -= 1.0;
        events_(group(stops_[first])) = 0.0;
        all_ -= 1.0;
      }
    }
  }

  [[nodiscard]] double survival() const noexcept { return survival_; }

 private:
  [[nodiscard]] Eigen::Index group(std::uint32_t row) const {
    return static_cast<Eigen::Index>(groups_->codes[row]);
  }

  const SurvivalOutcome* outcome_;
  const table::Factor* groups_;
  std::span<const std::uint32_t> stops_;
  std::span<const std::uint32_t> starts_;
  Eigen::VectorXd at_risk_;
  Eigen::VectorXd events_;
  double all_ = 0.0;
  double survival_ = 1.0;  ///< Pooled, before the present time.
};

void check(const SurvivalOutcome& outcome,
           const table::Factor& groups,
           const table::Factor* strata,
           double rho) {
  if (groups.rows() != outcome.rows() || (strata != nullptr && strata->rows() != outcome.rows())) {
    throw std::invalid_argument("log-rank test: columns of different length");
  }
  if (std::any_of(groups.codes.begin(), groups.codes.end(), [&](std::uint32_t code) {
        return code >= groups.levels.size();
      })) {
    throw std::invalid_argument("log-rank test: a group is missing");
  }
  if (!std::isfinite(rho)) {
    throw std::invalid_argument("log-rank test: rho must be finite");
  }
}

/// Quadratic form of observed - expected over the groups that have an expected event.
void set_statistic(LogRankTest& test) {
  std::vector<Eigen::Index> used;
  for (std::size_t g = 0; g < test.groups.size(); ++g) {
    if (test.groups[g].expected > 0.0) {
      used.push_back(static_cast<Eigen::Index>(g));
    }
  }
  if (used.empty()) {
    test.conditions.push_back({ConditionKind::no_events, ConditionSeverity::error, {}, {}});
    return;
  }
  if (used.size() < 2) {
    test.conditions.push_back({ConditionKind::one_group, ConditionSeverity::error, {}, {}});
    return;
  }
  const auto size = static_cast<Eigen::Index>(used.size()) - 1;
  Eigen::VectorXd difference(size);
  Eigen::MatrixXd covariance(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto row = used[static_cast<std::size_t>(i) + 1];
    const LogRankGroup& group = test.groups[static_cast<std::size_t>(row)];
    difference(i) = group.observed - group.expected;
    for (Eigen::Index j = 0; j < size; ++j) {
      covariance(i, j) = test.covariance(row, used[static_cast<std::size_t>(j) + 1]);
    }
  }
  test.df = used.size() - 1;
  const std::optional<ChiSquareTest> form = wald_test(difference, covariance);
  if (!form) {
    test.conditions.push_back({ConditionKind::zero_variance, ConditionSeverity::error, {}, {}});
    return;
  }
  test.chi_squared = form->statistic;
  test.p_value = form->p_value;
}

/// The covariance of one event time, upper triangle: of the groups at risk, the others add nothing.
/// `present` is room to work in.
void add_hypergeometric(double scale,
                        double all,
                        const Eigen::VectorXd& at_risk,
                        std::vector<Eigen::Index>& present,
                        Eigen::MatrixXd& covariance) {
  present.clear();
  for (Eigen::Index g = 0; g < at_risk.size(); ++g) {
    if (at_risk(g) > 0.0) {
      present.push_back(g);
    }
  }
  for (const Eigen::Index a : present) {
    const double share = scale / all * at_risk(a);
    for (const Eigen::Index b : present) {
      if (b > a) {
        break;
      }
      covariance(b, a) -= share * at_risk(b);
    }
    covariance(a, a) += scale * at_risk(a);
  }
}

}  // namespace

LogRankTest log_rank_test(const SurvivalOutcome& outcome,
                          const table::Factor& groups,
                          const table::Factor* strata,
                          double rho) {
  check(outcome, groups, strata, rho);
  const auto k = static_cast<Eigen::Index>(groups.levels.size());
  LogRankTest test;
  test.rho = rho;
  for (const std::string& level : groups.levels) {
    test.groups.push_back({level, 0, 0.0, 0.0});
  }
  for (const std::uint32_t code : groups.codes) {
    ++test.groups[code].rows;
  }
  const TimeOrder order =
      time_order(outcome,
                 strata == nullptr ? std::span<const std::uint32_t>{} : std::span(strata->codes),
                 strata == nullptr ? 1 : strata->levels.size());
  Eigen::VectorXd observed = Eigen::VectorXd::Zero(k);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(k);
  test.covariance = Eigen::MatrixXd::Zero(k, k);
  std::vector<Eigen::Index> present;
  for (std::size_t s = 0; s < order.groups(); ++s) {
    LogRankStratum stratum(outcome, groups, order.stops_of(s), order.starts_of(s));
    stratum.for_each_event_time([&](double events,
                                    double all,
                                    const Eigen::VectorXd& events_of,
                                    const Eigen::VectorXd& at_risk) {
      const double weight = rho == 0.0 ? 1.0 : std::pow(stratum.survival(), rho);
      observed += weight * events_of;
      expected += (weight * events / all) * at_risk;
      if (all > 1.0) {
        const double scale = weight * weight * events * (all - events) / (all * (all - 1.0));
        add_hypergeometric(scale, all, at_risk, present, test.covariance);
      }
    });
  }
  test.covariance = Eigen::MatrixXd(test.covariance.selfadjointView<Eigen::Upper>());
  for (Eigen::Index g = 0; g < k; ++g) {
    test.groups[static_cast<std::size_t>(g)].observed = observed(g);
    test.groups[static_cast<std::size_t>(g)].expected = expected(g);
  }
  set_statistic(test);
  return test;
}

}  // namespace tcert::statistics
