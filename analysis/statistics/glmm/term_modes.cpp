#include <statistics/glmm/term_modes.hpp>

#include <limits>
#include <utility>

namespace tcert::statistics {

std::vector<TermModes> term_modes(const std::vector<TermRows>& terms,
                                  const std::vector<Eigen::MatrixXd>& factors,
                                  const SparseCurvature* inverted,
                                  const Eigen::VectorXd& u,
                                  double sigma) {
  std::vector<TermModes> result;
  Eigen::Index first = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Eigen::Index q = terms[t].scale.size();
    const auto levels = static_cast<Eigen::Index>(terms[t].levels.size());
    const Eigen::MatrixXd factor = terms[t].scale.cwiseInverse().asDiagonal() * factors[t];
    TermModes modes;
    modes.modes.setConstant(levels, q, std::numeric_limits<double>::quiet_NaN());
    modes.sds = modes.modes;
    for (Eigen::Index level = 0; level < levels && inverted != nullptr; ++level, first += q) {
      modes.modes.row(level) = (factor * u.segment(first, q)).transpose();
      Eigen::MatrixXd block(q, q);
      for (Eigen::Index b = 0; b < q; ++b) {
        for (Eigen::Index a = b; a < q; ++a) {
          block(a, b) = inverted->inverse_of_level(first + b, a - b);
          block(b, a) = block(a, b);
        }
      }
      modes.sds.row(level) =
          sigma * (factor * block * factor.transpose()).diagonal().cwiseSqrt().transpose();
    }
    result.push_back(std::move(modes));
  }
  return result;
}

}  // namespace tcert::statistics
