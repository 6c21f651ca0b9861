#include <statistics/logistic/logistic_refit.hpp>

#include <statistics/logistic/separation.hpp>
#include <stdexcept>
#include <vector>

namespace tcert::statistics {

LogisticRefit::LogisticRefit(const LogisticInput& input, const NewtonOptions& options)
    : problem_(logistic_problem(input)),
      options_(options),
      input_rows_(input.design.rows()),
      input_columns_(input.design.cols()),
      start_(Eigen::VectorXd::Zero(problem_.space.rank())) {
  const LogisticMaximum maximum = maximum_of(input, problem_, options);
  warm_ = maximum.newton.converged() && maximum.separation.kind == Separation::none;
  if (warm_) {
    start_ = maximum.newton.coefficients;
  }
}

LogisticReplicate LogisticRefit::fit(std::span<const std::uint32_t> multiplicities) const {
  if (static_cast<Eigen::Index>(multiplicities.size()) != input_rows_) {
    throw std::invalid_argument("logistic replicate: one multiplicity per row of the input");
  }
  BinomialRows rows = problem_.rows;
  std::vector<Eigen::Index> drawn;
  for (std::size_t i = 0; i < problem_.used.size(); ++i) {
    const std::uint32_t times = multiplicities[static_cast<std::size_t>(problem_.used[i])];
    rows.successes[static_cast<Eigen::Index>(i)] *= times;
    rows.trials[static_cast<Eigen::Index>(i)] *= times;
    if (times > 0) {
      drawn.push_back(static_cast<Eigen::Index>(i));
    }
  }
  const auto separated = [&] {
    return find_separation(
               problem_.space.basis(drawn, Eigen::all), rows.successes(drawn), rows.trials(drawn))
               .kind != Separation::none;
  };
  NewtonResult newton =
      maximise_binomial(problem_.space.basis, rows, start_, std::nullopt, options_, separated);
  LogisticReplicate replicate;
  replicate.termination = newton.termination;
  if (newton.converged()) {
    replicate.coefficients = std::move(newton.coefficients);
  }
  return replicate;
}

Eigen::VectorXd LogisticRefit::linear_predictor(const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd eta = problem_.space.basis * coefficients;
  if (problem_.rows.offset.size() > 0) {
    eta += problem_.rows.offset;
  }
  return eta;
}

Eigen::VectorXd LogisticRefit::column_coefficients(const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(input_columns_);
  const Eigen::VectorXd kept = inverse_triangle(problem_.space) * coefficients;
  for (std::size_t k = 0; k < problem_.space.kept.size(); ++k) {
    all[static_cast<Eigen::Index>(problem_.space.kept[k])] = kept[static_cast<Eigen::Index>(k)];
  }
  return all;
}

}  // namespace tcert::statistics
