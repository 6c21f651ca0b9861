#include "analysis/cox_risk_pass.hpp"

#include <algorithm>
#include <cmath>

namespace tcert {

void RiskMoments::clear() noexcept { std::fill(sums_.begin(), sums_.end(), 0.0); }

void RiskMoments::add(const RiskMoments& other) noexcept {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    sums_[k] += other.sums_[k];
  }
}

void RiskMoments::add_exactly(const RiskMoments& other, double sign, RiskMoments& rest) noexcept {
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const double part = sign * other.sums_[k];
    const double sum = sums_[k] + part;
    // Knuth's two-sum: the exact error, without a branch on which is larger.
    const double part_in = sum - sums_[k];
    rest.sums_[k] += (sums_[k] - (sum - part_in)) + (part - part_in);
    sums_[k] = sum;
  }
}

}  // namespace tcert
