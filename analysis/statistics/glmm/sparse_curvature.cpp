#include <cmath>
#include <statistics/glmm/selected_inverse.hpp>
#include <statistics/glmm/sparse_curvature.hpp>

namespace tcert::statistics {

SparseCurvature::SparseCurvature(const std::vector<TermRows>& terms, Eigen::Index rows) {
  for (const TermRows& term : terms) {
    per_row_ += term.scale.size();
    effects_ += term.scale.size() * static_cast<Eigen::Index>(term.levels.size());
  }
  pairs_ = pair_index(0, per_row_);
  of_.resize(static_cast<std::size_t>(rows * per_row_));
  Eigen::Index first = 0;
  Eigen::Index place = 0;
  for (const TermRows& term : terms) {
    const Eigen::Index q = term.scale.size();
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index j = 0; j < q; ++j) {
        of_[static_cast<std::size_t>(i * per_row_ + place + j)] =
            first + static_cast<Eigen::Index>(term.codes[static_cast<std::size_t>(i)]) * q + j;
      }
    }
    first += q * static_cast<Eigen::Index>(term.levels.size());
    place += q;
  }
  // Terms follow each other in u, so that a row's places ascend: (b, a) is below the diagonal.
  std::vector<Eigen::Triplet<double>> elements;
  for (Eigen::Index k = 0; k < effects_; ++k) {
    elements.emplace_back(static_cast<int>(k), static_cast<int>(k), 1.0);
  }
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Eigen::Index* const at = places(i);
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      for (Eigen::Index a = 0; a < b; ++a) {
        elements.emplace_back(static_cast<int>(at[b]), static_cast<int>(at[a]), 0.0);
      }
    }
  }
  h_.resize(effects_, effects_);
  h_.setFromTriplets(elements.begin(), elements.end());
  const auto place_of = [this](Eigen::Index row, Eigen::Index column) {
    const int* const begin = h_.innerIndexPtr() + h_.outerIndexPtr()[column];
    const int* const end = h_.innerIndexPtr() + h_.outerIndexPtr()[column + 1];
    return static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<int>(row)) -
                                    h_.innerIndexPtr());
  };
  for (Eigen::Index k = 0; k < effects_; ++k) {
    diagonal_.push_back(place_of(k, k));
  }
  pair_.resize(static_cast<std::size_t>(rows * pairs_));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Eigen::Index* const at = places(i);
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      for (Eigen::Index a = 0; a <= b; ++a) {
        pair_[static_cast<std::size_t>(i * pairs_ + pair_index(a, b))] =
            static_cast<std::int32_t>(place_of(at[b], at[a]));
      }
    }
  }
  cholesky_.analyzePattern(h_);
}

void SparseCurvature::find_inverse_places() {
  const Matrix& factor = cholesky_.matrixL().nestedExpression();
  const auto& order = cholesky_.permutationP().indices();
  inverse_from_.resize(static_cast<std::size_t>(h_.nonZeros()));
  for (int column = 0; column < h_.outerSize(); ++column) {
    for (Matrix::InnerIterator it(h_, column); it; ++it) {
      const int a = order.size() > 0 ? order[static_cast<Eigen::Index>(it.row())]
                                     : static_cast<int>(it.row());
      const int b = order.size() > 0 ? order[column] : column;
      const int* const begin = factor.innerIndexPtr() + factor.outerIndexPtr()[std::min(a, b)];
      const int* const end = factor.innerIndexPtr() + factor.outerIndexPtr()[std::min(a, b) + 1];
      inverse_from_[static_cast<std::size_t>(&it.value() - h_.valuePtr())] =
          static_cast<std::size_t>(std::lower_bound(begin, end, std::max(a, b)) -
                                   factor.innerIndexPtr());
    }
  }
}

bool SparseCurvature::factorise(const RowMajorMatrix& values, const Eigen::VectorXd& weight) {
  double* const value = h_.valuePtr();
  std::fill_n(value, h_.nonZeros(), 0.0);
  for (const std::size_t place : diagonal_) {
    value[place] = 1.0;
  }
  const std::int32_t* place = pair_.data();
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const double* const row = values.data() + i * per_row_;
    for (Eigen::Index b = 0; b < per_row_; ++b) {
      const double weighted = weight[i] * row[b];
      for (Eigen::Index a = 0; a <= b; ++a) {
        value[*place++] += weighted * row[a];
      }
    }
  }
  cholesky_.factorize(h_);
  return cholesky_.info() == Eigen::Success;
}

double SparseCurvature::half_log_determinant() const {
  const Matrix& factor = cholesky_.matrixL().nestedExpression();
  double log_pivots = 0.0;
  for (int j = 0; j < factor.outerSize(); ++j) {
    log_pivots += std::log(factor.valuePtr()[factor.outerIndexPtr()[j]]);
  }
  return log_pivots;
}

void SparseCurvature::invert() {
  if (inverse_from_.empty()) {
    find_inverse_places();
  }
  const std::vector<double> all = selected_inverse(cholesky_.matrixL().nestedExpression());
  inverse_.resize(inverse_from_.size());
  for (std::size_t k = 0; k < inverse_.size(); ++k) {
    inverse_[k] = all[inverse_from_[k]];
  }
}

}  // namespace tcert::statistics
