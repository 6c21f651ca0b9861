#include <statistics/survival/gray_test.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <statistics/basics/wald_chi_squared.hpp>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {
namespace {

/// One group at one event time.
struct GroupAt {
  double at_risk = 0.0;
  double events = 0.0;     ///< Of the cause.
  double competing = 0.0;  ///< Of the others.
  double before = 1.0;     ///< S(t-): no event of any cause.
  double after = 1.0;      ///< S(t).
  double incidence = 0.0;  ///< F(t-).

  [[nodiscard]] double exposure() const { return at_risk > 0.0 ? at_risk / before : 0.0; }
};

/// All groups of a stratum at one event time.
struct GrayTime {
  std::vector<GroupAt> groups;
  double events = 0.0;    ///< Of the cause, in all groups.
  double exposure = 0.0;  ///< Sum of the groups'.
  double before = 0.0;    ///< F(t-) of all groups.
  double after = 0.0;     ///< F(t).
  double weight = 1.0;    ///< (1 - F(t-))^rho.

  /// What an event of the cause in group k adds to the score of group i, per 1 / exposure of k.
  [[nodiscard]] double contrast(std::size_t i, std::size_t k) const {
    const double own = groups[i].exposure();
    return weight * own * ((i == k ? 1.0 : 0.0) - groups[k].exposure() / exposure);
  }
};

/// What the groups come to at the time; all events of it.
double sum_up(GrayTime& now, double rho) {
  double all = 0.0;
  now.events = now.exposure = 0.0;
  for (GroupAt& group : now.groups) {
    now.events += group.events;
    all += group.events + group.competing;
    now.exposure += group.exposure();
    if (group.at_risk > 0.0) {
      group.after = group.before * (group.at_risk - group.events - group.competing) / group.at_risk;
    }
  }
  now.weight = std::pow(1.0 - now.before, rho);
  now.after = now.before + (now.events > 0.0 ? now.events / now.exposure : 0.0);
  return all;
}

/// From just before the time to just after it.
void pass(GrayTime& now) {
  now.before = now.after;
  for (GroupAt& group : now.groups) {
    if (group.at_risk > 0.0) {
      group.incidence += group.before * group.events / group.at_risk;
    }
    group.before = group.after;
    group.events = group.competing = 0.0;
  }
}

/// The event times of the rows of one stratum, in order.
std::vector<GrayTime> times_of(const CompetingOutcome& outcome,
                               std::uint32_t cause,
                               const table::Factor& groups,
                               std::vector<std::size_t> rows,
                               double rho) {
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return outcome.stop[a] < outcome.stop[b];
  });
  GrayTime now;
  now.groups.resize(groups.levels.size());
  for (const std::size_t row : rows) {
    now.groups[groups.codes[row]].at_risk += 1.0;
  }
  std::vector<GrayTime> times;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t last = first;
    for (; last < rows.size() && outcome.stop[rows[last]] == outcome.stop[rows[first]]; ++last) {
      GroupAt& group = now.groups[groups.codes[rows[last]]];
      const std::uint32_t end = outcome.cause[rows[last]];
      (end == cause ? group.events : group.competing) += end == 0 ? 0.0 : 1.0;
    }
    if (sum_up(now, rho) > 0.0) {
      times.push_back(now);
    }
    pass(now);
    for (; first < last; ++first) {
      now.groups[groups.codes[rows[first]]].at_risk -= 1.0;
    }
  }
  return times;
}

void add_scores(const GrayTime& time, Eigen::VectorXd& scores) {
  double expected_share = 0.0;
  for (const GroupAt& group : time.groups) {
    expected_share += group.exposure() * (1.0 - group.incidence);
  }
  for (std::size_t k = 0; k < time.groups.size(); ++k) {
    const GroupAt& group = time.groups[k];
    const double own = group.exposure() * (1.0 - group.incidence);
    const double expected = time.events > 0.0 ? time.events * own / expected_share : 0.0;
    scores(static_cast<Eigen::Index>(k)) += time.weight * (group.events - expected);
  }
}

/// Of tied events all but the first tell a little less.
double tie_factor(double events, double among) {
  return events > 1.0 ? 1.0 - (events - 1.0) / (among - 1.0) : 1.0;
}

class GrayCovariance {
 public:
  GrayCovariance(const std::vector<GrayTime>& times, Eigen::MatrixXd& covariance)
      : covariance_(covariance),
        k_(static_cast<std::size_t>(covariance.rows())),
        total_(Eigen::MatrixXd::Zero(covariance.rows(), covariance.cols())),
        so_far_(total_) {
    for (const GrayTime& time : times) {
      advance(time, total_);
    }
    for (const GrayTime& time : times) {
      advance(time, so_far_);
      for (std::size_t k = 0; k < k_; ++k) {
        add(time, k);
      }
    }
  }

 private:
  /// The contrasts' integral by the hazard of the subdistribution of all groups.
  void advance(const GrayTime& time, Eigen::MatrixXd& sum) const {
    if (!(time.events > 0.0)) {
      return;
    }
    const double hazard = time.events / (time.exposure * (1.0 - time.before));
    for (std::size_t i = 0; i < k_; ++i) {
      for (std::size_t k = 0; k < k_; ++k) {
        sum(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) +=
            time.contrast(i, k) * hazard;
      }
    }
  }

  /// Events of group k move the scores at once, and later by what they do to its S and F.
  void add(const GrayTime& time, std::size_t k) {
    const GroupAt& group = time.groups[k];
    if (!(group.at_risk > 0.0)) {
      return;
    }
    const auto column = static_cast<Eigen::Index>(k);
    const Eigen::VectorXd later = total_.col(column) - so_far_.col(column);
    const double ratio = group.after > 0.0 ? (1.0 - time.after) / group.after : 0.0;
    if (time.events > 0.0) {
      Eigen::VectorXd change = (1.0 - ratio) * later;
      for (std::size_t i = 0; i < k_; ++i) {
        change(static_cast<Eigen::Index>(i)) += time.contrast(i, k);
      }
      const double ties = tie_factor(time.events, time.exposure * group.before);
      covariance_ += ties * group.before * time.events / (time.exposure * group.at_risk) * change *
                     change.transpose();
    }
    if (group.after > 0.0 && group.competing > 0.0) {
      const Eigen::VectorXd change = ratio * later;
      const double share = group.before / group.at_risk;
      covariance_ += tie_factor(group.competing, group.at_risk) * share * share * group.competing *
                     change * change.transpose();
    }
  }

  Eigen::MatrixXd& covariance_;
  std::size_t k_;
  Eigen::MatrixXd total_;
  Eigen::MatrixXd so_far_;
};

void check(const CompetingOutcome& outcome,
           std::size_t cause,
           const table::Factor& groups,
           const table::Factor* strata) {
  const std::size_t n = outcome.stop.size();
  const auto is_coded = [n](const table::Factor& factor) {
    return factor.rows() == n && std::ranges::all_of(factor.codes, [&](std::uint32_t code) {
             return code < factor.levels.size();
           });
  };
  if (outcome.cause.size() != n || !is_coded(groups) || (strata != nullptr && !is_coded(*strata))) {
    throw std::invalid_argument("Gray's test: columns of different length, or a missing code");
  }
  if (!outcome.start.empty() || cause >= outcome.causes.size()) {
    throw std::invalid_argument("Gray's test: rows that enter late, or no such cause");
  }
}

}  // namespace

GrayTest gray_test(const CompetingOutcome& outcome,
                   std::size_t cause,
                   const table::Factor& groups,
                   const table::Factor* strata,
                   double rho) {
  check(outcome, cause, groups, strata);
  const auto k = static_cast<Eigen::Index>(groups.levels.size());
  GrayTest result;
  result.cause = outcome.causes[cause];
  result.scores = Eigen::VectorXd::Zero(k);
  result.covariance = Eigen::MatrixXd::Zero(k, k);
  std::vector<std::vector<std::size_t>> rows(strata == nullptr ? 1 : strata->levels.size());
  for (std::size_t row = 0; row < outcome.stop.size(); ++row) {
    rows[strata == nullptr ? 0 : strata->codes[row]].push_back(row);
  }
  for (std::vector<std::size_t>& own : rows) {
    const auto times =
        times_of(outcome, static_cast<std::uint32_t>(cause) + 1, groups, std::move(own), rho);
    for (const GrayTime& time : times) {
      add_scores(time, result.scores);
    }
    GrayCovariance(times, result.covariance);
  }
  if (k > 1) {
    result.test =
        wald_test(result.scores.head(k - 1), result.covariance.topLeftCorner(k - 1, k - 1));
  }
  return result;
}

}  // namespace tcert::statistics
