#pragma once
// The worst disagreement with golden values, per quantity.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include "analysis/statistics/survival/survival_golden.hpp"

namespace tcert::statistics {

class Worst {
 public:
  explicit Worst(double tolerance) : tolerance_(tolerance) {}

  /// Relative to `expected`, or to `scale` if it is given.
  void expect(const std::string& quantity, double actual, double expected, double scale = 0.0) {
    const double gap =
        scale > 0.0 ? std::abs(actual - expected) / scale : disagreement(actual, expected);
    EXPECT_LE(gap, tolerance_) << quantity << ": " << actual << ", expected " << expected;
    worst_[quantity] = std::max(worst_[quantity], gap);
  }
  void print() const {
    for (const auto& [quantity, gap] : worst_) {
      std::printf("  worst disagreement of %s: %.1e\n", quantity.c_str(), gap);
    }
  }

 private:
  double tolerance_;
  std::map<std::string, double> worst_;
};

}  // namespace tcert::statistics
