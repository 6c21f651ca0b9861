#include <statistics/logistic/separation.hpp>

#include <cmath>
#include <statistics/logistic/cone_projection.hpp>
#include <string_view>

namespace tcert::statistics {
namespace {

/// A margin of this share of a row's length is a tie.
constexpr double kTie = 1e-9;

/// The signed rows and the data row of each.
struct SignedRows {
  Eigen::MatrixXd rows;
  std::vector<Eigen::Index> of;
};

SignedRows signed_rows(const Eigen::MatrixXd& design,
                       const Eigen::VectorXd& successes,
                       const Eigen::VectorXd& trials) {
  SignedRows result;
  const auto mixed = ((successes.array() > 0.0) && (successes.array() < trials.array())).count();
  result.rows.resize(design.rows() + mixed, design.cols());
  Eigen::Index at = 0;
  const auto add = [&](Eigen::Index row, double sign, double norm) {
    result.rows.row(at++) = design.row(row) * (sign / norm);
    result.of.push_back(row);
  };
  for (Eigen::Index i = 0; i < design.rows(); ++i) {
    const double norm = design.row(i).norm();
    if (norm == 0.0) {
      continue;  // its probability does not depend on the coefficients
    }
    if (successes[i] > 0.0) {
      add(i, 1.0, norm);
    }
    if (successes[i] < trials[i]) {
      add(i, -1.0, norm);
    }
  }
  result.rows.conservativeResize(at, Eigen::NoChange);
  return result;
}

/// Leaves the rows without a margin along `direction`; those with one no longer overlap.
void set_aside(SignedRows& signed_rows,
               const Eigen::VectorXd& direction,
               std::vector<bool>& overlaps) {
  const Eigen::VectorXd margins = signed_rows.rows * direction.normalized();
  Eigen::Index left = 0;
  for (Eigen::Index i = 0; i < margins.size(); ++i) {
    const Eigen::Index row = signed_rows.of[static_cast<std::size_t>(i)];
    if (margins[i] > kTie) {
      overlaps[static_cast<std::size_t>(row)] = false;
      continue;
    }
    signed_rows.rows.row(left) = signed_rows.rows.row(i);
    signed_rows.of[static_cast<std::size_t>(left)] = row;
    ++left;
  }
  signed_rows.rows.conservativeResize(left, Eigen::NoChange);
  signed_rows.of.resize(static_cast<std::size_t>(left));
}

/// Rounding of a sum of `n` rows of length 1.
double smallest_sum(Eigen::Index n) { return std::max(kTie, 1e-15 * static_cast<double>(n)); }

}  // namespace

std::string_view to_string(Separation separation) noexcept {
  switch (separation) {
    case Separation::none:
      return "none";
    case Separation::quasi:
      return "quasi-complete";
    case Separation::complete:
      return "complete";
  }
  return "";
}

SeparationResult find_separation(const Eigen::MatrixXd& design,
                                 const Eigen::VectorXd& successes,
                                 const Eigen::VectorXd& trials) {
  SeparationResult result;
  result.overlaps.assign(static_cast<std::size_t>(design.rows()), true);
  SignedRows rest = signed_rows(design, successes, trials);
  for (Eigen::Index round = 0; round < design.cols() && rest.rows.rows() > 0; ++round) {
    const Eigen::VectorXd sum = rest.rows.colwise().sum().transpose();
    const auto direction = project_on_cone(rest.rows, sum, smallest_sum(rest.rows.rows()));
    if (!direction || direction->isZero(0.0)) {
      break;
    }
    const Eigen::Index before = rest.rows.rows();
    set_aside(rest, *direction, result.overlaps);
    if (rest.rows.rows() == before) {
      break;
    }
    result.kind = Separation::quasi;
  }
  if (result.kind == Separation::quasi && rest.rows.rows() == 0) {
    result.kind = Separation::complete;
  }
  return result;
}

std::vector<Signs> recession_signs(const Eigen::MatrixXd& design,
                                   const Eigen::VectorXd& successes,
                                   const Eigen::VectorXd& trials,
                                   const Eigen::MatrixXd& functionals) {
  const SignedRows rows = signed_rows(design, successes, trials);
  std::vector<Signs> result;
  for (Eigen::Index j = 0; j < functionals.cols(); ++j) {
    const Eigen::VectorXd target = functionals.col(j).normalized();
    const auto reaches = [&](const Eigen::VectorXd& goal) {
      const auto nearest = project_on_cone(rows.rows, goal, kTie);
      return nearest && !nearest->isZero(0.0);
    };
    result.push_back({reaches(target), reaches(-target)});
  }
  return result;
}

}  // namespace tcert::statistics
