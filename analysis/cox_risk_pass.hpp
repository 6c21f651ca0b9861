#pragma once
/// \file
/// One pass over all risk sets, from each stratum's last event time to its first, with the sums
/// over the rows at risk.

#include <cstddef>
#include <vector>

#include "analysis/cox_rows.hpp"

namespace tcert {

/// Sums over rows of weight x risk score times 1, x and x x': one number, p of them, and the lower
/// triangle by rows.
class RiskMoments {
 public:
  RiskMoments(std::size_t columns, bool second)
      : columns_(columns),
        second_(second),
        sums_(1 + columns + (second ? columns * (columns + 1) / 2 : 0), 0.0) {}

  [[nodiscard]] double zeroth() const noexcept { return sums_[0]; }
  [[nodiscard]] const double* first() const noexcept { return sums_.data() + 1; }
  [[nodiscard]] const double* second() const noexcept { return sums_.data() + 1 + columns_; }

  void clear() noexcept;

  /// Adds a row with risk `r`.
  void add(double r, const double* x) noexcept {
    double* sum = sums_.data();
    *sum++ += r;
    double* triangle = sum + columns_;
    for (std::size_t a = 0; a < columns_; ++a) {
      const double rx = r * x[a];
      sum[a] += rx;
      if (second_) {
        for (std::size_t b = 0; b <= a; ++b) {
          triangle[b] += rx * x[b];
        }
        triangle += a + 1;
      }
    }
  }

  void add(const RiskMoments& other) noexcept;

  /// Adds `sign` times `other` and keeps in `rest` what rounding loses (Neumaier), so that rows
  /// can leave again without trace.
  void add_exactly(const RiskMoments& other, double sign, RiskMoments& rest) noexcept;

 private:
  std::size_t columns_;
  bool second_;
  std::vector<double> sums_;
};

/// At one event time.
struct RiskSet {
  std::size_t time;            ///< Its number in `RiskSets`.
  const RiskMoments& others;   ///< Rows at risk without an event now.
  const RiskMoments& events;   ///< Rows with an event now.
};

/// Calls `visit(RiskSet)` for every event time, strata upwards, times downwards. O(m p^2), or
/// O(m p) without second moments.
template <class Visit>
void for_each_risk_set(const CoxRows& rows, const RiskScores& risks, bool second, Visit&& visit) {
  const RiskSets& sets = rows.sets;
  RiskMoments total(rows.columns, second);
  RiskMoments rest(rows.columns, second);
  RiskMoments events(rows.columns, second);
  RiskMoments group(rows.columns, second);
  RiskMoments others(rows.columns, second);
  const bool truncated = !sets.late_begin.empty();
  const auto risk = [&](std::size_t place) { return rows.weight[place] * risks.score[place]; };
  const auto join = [&](const RiskMoments& part, double sign) {
    if (truncated) {
      total.add_exactly(part, sign, rest);
    } else {
      total.add(part);
    }
  };
  for (std::size_t s = 0; s < sets.strata(); ++s) {
    total.clear();
    rest.clear();
    for (std::size_t t = sets.stratum_begin[s + 1]; t-- > sets.stratum_begin[s];) {
      group.clear();
      for (std::size_t place = sets.begin[t]; place < sets.events_begin[t]; ++place) {
        group.add(risk(place), rows.row(place));
      }
      join(group, 1.0);
      events.clear();
      for (std::size_t place = sets.events_begin[t]; place < sets.begin[t + 1]; ++place) {
        events.add(risk(place), rows.row(place));
      }
      if (truncated) {
        others = total;
        others.add(rest);
        visit(RiskSet{t, others, events});
      } else {
        visit(RiskSet{t, total, events});
      }
      join(events, 1.0);
      if (truncated && sets.late_begin[t] != sets.late_begin[t + 1]) {
        group.clear();
        for (std::size_t k = sets.late_begin[t]; k < sets.late_begin[t + 1]; ++k) {
          group.add(risk(sets.late[k]), rows.row(sets.late[k]));
        }
        join(group, -1.0);
      }
    }
  }
}

}  // namespace tcert
