#include <statistics/cox/cox_risk_pass.hpp>

#include <algorithm>
#include <array>

namespace tcert::statistics {
namespace {

constexpr std::size_t kUnrolled = 8;  ///< Numbers of columns up to it have a loop of their own.

/// Adds one row with risk `r`.
inline void add_row(double r, const double* x, std::size_t p, bool second, double* sums) noexcept {
  sums[0] += r;
  double* const sum = sums + 1;
  double* triangle = sum + p;
  for (std::size_t a = 0; a < p; ++a) {
    const double rx = r * x[a];
    sum[a] += rx;
    if (second) {
      for (std::size_t b = 0; b <= a; ++b) {
        triangle[b] += rx * x[b];
      }
      triangle += a + 1;
    }
  }
}

/// The number of columns is known, so that the loops unroll.
template <std::size_t P, bool kSecond>
void add_rows(const double* x, const double* risk, std::size_t count, double* sums) noexcept {
  constexpr std::size_t kSize = 1 + P + (kSecond ? P * (P + 1) / 2 : 0);
  std::array<double, kSize> local{};
  for (std::size_t i = 0; i < count; ++i) {
    add_row(risk[i], x + i * P, P, kSecond, local.data());
  }
  for (std::size_t k = 0; k < kSize; ++k) {
    sums[k] += local[k];
  }
}

using AddRows = void (*)(const double*, const double*, std::size_t, double*) noexcept;

template <bool kSecond>
AddRows unrolled(std::size_t columns) noexcept {
  constexpr std::array<AddRows, kUnrolled> kByColumns{add_rows<1, kSecond>,
                                                      add_rows<2, kSecond>,
                                                      add_rows<3, kSecond>,
                                                      add_rows<4, kSecond>,
                                                      add_rows<5, kSecond>,
                                                      add_rows<6, kSecond>,
                                                      add_rows<7, kSecond>,
                                                      add_rows<8, kSecond>};
  return kByColumns[columns - 1];
}

}  // namespace

void RiskMoments::clear() noexcept { std::fill(sums_.begin(), sums_.end(), 0.0); }

void RiskMoments::add(const CoxRows& rows,
                      const RiskScores& risks,
                      std::size_t begin,
                      std::size_t end) noexcept {
  const std::size_t count = end - begin;
  const double* const risk = risks.risk() + begin;
  if (count > 1 && columns_ >= 1 && columns_ <= kUnrolled) {
    const AddRows add_all = second_ ? unrolled<true>(columns_) : unrolled<false>(columns_);
    add_all(rows.row(begin), risk, count, sums_.data());
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    add_row(risk[i], rows.row(begin + i), columns_, second_, sums_.data());
  }
}

void RiskMoments::add(const RiskMoments& other) noexcept {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    sums_[k] += other.sums_[k];
  }
}

void RiskMoments::add_exactly(const RiskMoments& other, double sign, RiskMoments& rest) noexcept {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const double part = sign * other.sums_[k];
    const double sum = sums_[k] + part;
    const double part_in = sum - sums_[k];
    rest.sums_[k] += (sums_[k] - (sum - part_in)) + (part - part_in);
    sums_[k] = sum;
  }
}

RiskPass::RiskPass(const CoxRows& rows, const RiskScores& risks, bool second)
    : rows_(rows),
      risks_(risks),
      truncated_(!rows.sets.late_begin.empty()),
      total_(rows.columns, second),
      rest_(rows.columns, second),
      exact_(rows.columns, second),
      events_(rows.columns, second),
      group_(rows.columns, second) {}

void RiskPass::start_stratum() noexcept {
  total_.clear();
  rest_.clear();
}

void RiskPass::join(const RiskMoments& part, double sign) noexcept {
  if (truncated_) {
    total_.add_exactly(part, sign, rest_);
  } else {
    total_.add(part);
  }
}

RiskSet RiskPass::enter(std::size_t t) noexcept {
  const RiskSets& sets = rows_.sets;
  if (sets.begin[t] != sets.events_begin[t]) {
    group_.clear();
    group_.add(rows_, risks_, sets.begin[t], sets.events_begin[t]);
    join(group_, 1.0);
  }
  events_.clear();
  events_.add(rows_, risks_, sets.events_begin[t], sets.begin[t + 1]);
  if (!truncated_) {
    return {t, total_, events_};
  }
  exact_ = total_;
  exact_.add(rest_);
  return {t, exact_, events_};
}

void RiskPass::leave(std::size_t t) noexcept {
  const RiskSets& sets = rows_.sets;
  join(events_, 1.0);
  if (truncated_ && sets.late_begin[t] != sets.late_begin[t + 1]) {
    group_.clear();
    for (std::size_t k = sets.late_begin[t]; k < sets.late_begin[t + 1]; ++k) {
      group_.add(rows_, risks_, sets.late[k], sets.late[k] + 1U);
    }
    join(group_, -1.0);
  }
}

}  // namespace tcert::statistics
