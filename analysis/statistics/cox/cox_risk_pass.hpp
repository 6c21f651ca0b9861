#pragma once
/// \file
/// One pass over all risk sets, from each stratum's last event time to its first, with the sums
/// over the rows at risk.

#include <cstddef>
#include <statistics/cox/cox_rows.hpp>
#include <vector>

namespace tcert::statistics {

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

  /// Adds the rows at places begin..end - 1. O((end - begin) p^2), or p without second moments.
  void add(const CoxRows& rows,
           const RiskScores& risks,
           std::size_t begin,
           std::size_t end) noexcept;

  void add(const RiskMoments& other) noexcept;

  /// Adds `sign` times `other` and keeps in `rest` what rounding loses (Knuth's two-sum), so that
  /// rows can leave again without trace.
  void add_exactly(const RiskMoments& other, double sign, RiskMoments& rest) noexcept;

 private:
  std::size_t columns_;
  bool second_;
  std::vector<double> sums_;
};

/// At one event time.
struct RiskSet {
  std::size_t time;           ///< Its number in `RiskSets`.
  const RiskMoments& others;  ///< Rows at risk without an event now.
  const RiskMoments& events;  ///< Rows with an event now.
};

/// The rows at risk as the pass goes down in time.
class RiskPass {
 public:
  RiskPass(const CoxRows& rows, const RiskScores& risks, bool second);

  /// Before the last event time of a stratum.
  void start_stratum() noexcept;

  /// Lets in the rows whose last event time is `t`. Downwards.
  [[nodiscard]] RiskSet enter(std::size_t t) noexcept;

  /// Lets out the rows whose first event time is `t`.
  void leave(std::size_t t) noexcept;

 private:
  void join(const RiskMoments& part, double sign) noexcept;

  const CoxRows& rows_;
  const RiskScores& risks_;
  bool truncated_;
  RiskMoments total_;  ///< All at risk; with late entry its rounded part.
  RiskMoments rest_;   ///< Late entry: what `total_` lacks.
  RiskMoments exact_;  ///< Late entry: `total_` + `rest_`.
  RiskMoments events_;
  RiskMoments group_;
};

/// Calls `visit(RiskSet)` for every event time, strata upwards, times downwards. O(m p^2), or
/// O(m p) without second moments.
template <class Visit>
void for_each_risk_set(const CoxRows& rows,
                       const RiskScores& risks,
                       bool second,
                       const Visit& visit) {
  const RiskSets& sets = rows.sets;
  RiskPass pass(rows, risks, second);
  for (std::size_t s = 0; s < sets.strata(); ++s) {
    pass.start_stratum();
    for (std::size_t t = sets.stratum_begin[s + 1]; t-- > sets.stratum_begin[s];) {
      visit(pass.enter(t));
      pass.leave(t);
    }
  }
}

}  // namespace tcert::statistics
