#pragma once
/// \file
/// Baseline hazards of a Cox model and predicted survival curves, as R's `basehaz(centered =
/// FALSE)` and `survfit.coxph` have them: Breslow's estimate, Efron's with Efron ties.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/cox/cox.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// Of one stratum, at each distinct time at which a row of it stops.
struct BaselineHazard {
  std::string stratum;  ///< Its level; empty without strata.
  std::vector<double> time;
  std::vector<double> hazard;  ///< Cumulative, of the row asked for; infinity where it runs there
                               ///< with a coefficient.
};

/// One a stratum that has rows. \pre `fit` is the fit to `data`, with inference, without an error.
/// Where coefficients run to infinity it is the limit: an event at which rows of a larger risk in
/// their direction are at risk adds nothing, one at which all are of a smaller risk adds infinity.
/// Of a row `x` (p) with `offset`; by default all 0, where the hazard may under- or overflow if the
/// rows of the fit lie far from it. O(n (log n + p)). \throws std::invalid_argument if `x` has
/// another size.
[[nodiscard]] std::vector<BaselineHazard> cox_baseline(const CoxData& data,
                                                       const CoxFit& fit,
                                                       const Eigen::VectorXd& x = {},
                                                       double offset = 0.0);

/// The curve of one new row in one stratum, at the times of its baseline hazard.
struct CoxCurve {
  std::string stratum;
  std::size_t row = 0;  ///< Of the new rows.
  std::vector<double> time;
  std::vector<double> survival;
  std::vector<double>
      std_err;  ///< Of `survival`; as R's, it uses the robust variance for beta alone.
  std::vector<double> lower;  ///< On the log scale; NaN where survival is 0.
  std::vector<double> upper;  ///< At most 1.
};

/// For every stratum all rows of `design` (k x p, columns as in `data`), with `offset` (k) if the
/// model has one. In the limit of coefficients that run to infinity, as above; a survival of 0 that
/// comes of an infinite hazard has no std_err.
/// O(n (log n + p) + k T p^2). \throws std::invalid_argument if the sizes differ.
[[nodiscard]] std::vector<CoxCurve> cox_curves(const CoxData& data,
                                               const CoxFit& fit,
                                               const Eigen::MatrixXd& design,
                                               const Eigen::VectorXd& offset = {});

}  // namespace tcert::statistics
