#pragma once
/// \file
/// Gray's test of equal cumulative incidence in k groups (Gray 1988). Checked against
/// `cmprsk::cuminc`.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/survival/cumulative_incidence.hpp>
#include <string>
#include <table/factor.hpp>

namespace tcert::statistics {

struct GrayTest {
  std::string cause;
  Eigen::VectorXd scores;             ///< Observed less expected events of the cause, groups.
  Eigen::MatrixXd covariance;         ///< Of the scores, groups x groups.
  std::optional<ChiSquareTest> test;  ///< Empty where the groups cannot be told apart.
};

/// Of `outcome.causes[cause]`, the others competing: events of a group are compared with its share
/// of R_k = at risk times (1 - F_k(t-)) / S_k(t-), those who can no longer have the event counted
/// on; differences weigh (1 - F)^rho, F that of all groups. Rows are taken as independent; `strata`
/// may be null. O(n log n + k^2 times). \throws std::invalid_argument if lengths differ, a code is
/// missing, rows enter late, or there is no such cause.
[[nodiscard]] GrayTest gray_test(const CompetingOutcome& outcome,
                                 std::size_t cause,
                                 const table::Factor& groups,
                                 const table::Factor* strata = nullptr,
                                 double rho = 0.0);

}  // namespace tcert::statistics
