#pragma once
/// \file
/// Separation in logistic regression, decided by a certificate and not by how far a fit has run:
/// whether the likelihood has directions along which it never falls, and for which rows it rises.

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tcert::statistics {

enum class Separation : std::uint8_t {
  none,      ///< A finite estimate exists and is unique.
  quasi,     ///< Some rows are told apart without error, others overlap.
  complete,  ///< Every row is told apart.
};

/// "none", "quasi-complete", "complete".
[[nodiscard]] std::string_view to_string(Separation separation) noexcept;

struct SeparationResult {
  Separation kind = Separation::none;
  std::vector<bool> overlaps;  ///< Per row: false if its fitted probability runs to 0 or 1.
};

/// Rows with 0 < successes < trials hold the likelihood on both sides. \pre the columns of `design`
/// are orthonormal, trials > 0.
///
/// Method: with a_i = +x_i for a row of successes, -x_i for one of failures, both for a mixed one,
/// all scaled to length 1, the directions of recession are the cone C = {d : a_i d >= 0}. The
/// projection of the sum of the a_i onto C, a non-negative least-squares problem in as many
/// dimensions as there are columns (Lawson and Hanson's active sets), is 0 if and only if no d in C
/// has a positive margin (Stiemke's lemma). Otherwise it is such a d; its margins are verified, the
/// rows that have one are set aside, and the rest are asked again, at most once a column. Margins
/// below 1e-9 of a row's length are ties. About O(rows columns^2).
[[nodiscard]] SeparationResult find_separation(const Eigen::MatrixXd& design,
                                               const Eigen::VectorXd& successes,
                                               const Eigen::VectorXd& trials);

/// Whether `functional`' d can be above 0 (first) and below 0 (second) for a direction of
/// recession d. Arguments as above.
struct Signs {
  bool positive = false;
  bool negative = false;
};
[[nodiscard]] std::vector<Signs> recession_signs(const Eigen::MatrixXd& design,
                                                 const Eigen::VectorXd& successes,
                                                 const Eigen::VectorXd& trials,
                                                 const Eigen::MatrixXd& functionals);

}  // namespace tcert::statistics
