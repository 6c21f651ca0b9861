#pragma once
/// \file
/// Infinitesimal-jackknife variance of a curve at every time, without a loop over the rows at each.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tcert::statistics {

/// Sum over clusters of (a + b p + c v)^2 for a, b, c of each cluster that change row by row and
/// p, v that change with time. The influence of a row on a curve has this form: a row at risk
/// follows v, one that has left follows p. A change and a sum are both O(1).
class InfluenceSums {
 public:
  struct Terms {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
  };

  explicit InfluenceSums(std::size_t clusters) : terms_(clusters) {}

  void add(std::uint32_t cluster, const Terms& change) noexcept {
    Terms& terms = terms_[cluster];
    count(terms, -1.0);
    terms.a += change.a;
    terms.b += change.b;
    terms.c += change.c;
    count(terms, 1.0);
  }

  [[nodiscard]] double sum_of_squares(double p, double v) const noexcept {
    const double sum = aa_ + p * (2.0 * ab_ + p * bb_) + v * (2.0 * (ac_ + p * bc_) + v * cc_);
    return sum > 0.0 ? sum : 0.0;
  }

 private:
  void count(const Terms& terms, double sign) noexcept {
    aa_ += sign * terms.a * terms.a;
    ab_ += sign * terms.a * terms.b;
    bb_ += sign * terms.b * terms.b;
    ac_ += sign * terms.a * terms.c;
    bc_ += sign * terms.b * terms.c;
    cc_ += sign * terms.c * terms.c;
  }

  std::vector<Terms> terms_;
  double aa_ = 0.0;
  double ab_ = 0.0;
  double bb_ = 0.0;
  double ac_ = 0.0;
  double bc_ = 0.0;
  double cc_ = 0.0;
};

}  // namespace tcert::statistics
