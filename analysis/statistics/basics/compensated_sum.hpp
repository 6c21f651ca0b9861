#pragma once
/// \file
/// A sum that keeps what rounding loses.

#include <cmath>

namespace tcert::statistics {

/// Neumaier's (1974) sum: the error does not grow with the number of terms, unless they cancel to
/// less than machine epsilon of their sizes. NaN and infinite terms make it NaN or infinite.
class CompensatedSum {
 public:
  void add(double term) noexcept {
    const double sum = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }

  [[nodiscard]] double value() const noexcept {
    // Beside an infinite sum the rest is NaN, which says nothing of its sign.
    return std::isfinite(sum_) ? sum_ + lost_ : sum_;
  }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

}  // namespace tcert::statistics
