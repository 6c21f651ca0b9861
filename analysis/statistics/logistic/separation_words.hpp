#pragma once
/// \file
/// What separation looks like in the data, in words.

#include <Eigen/Core>
#include <statistics/logistic/logistic.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// Which rows one column tells apart without error: "every row with f = c has y = 1", "every row
/// with x > 0.1 has y = 1, every row with x < 0.1 has y = 0". Where no single column does,
/// "together with other columns". `used` lists the rows. O(rows).
[[nodiscard]] std::string separation_words(const LogisticInput& input,
                                           const std::vector<Eigen::Index>& used,
                                           std::size_t column);

}  // namespace tcert::statistics
