#pragma once
/// \file
/// What a maximised Cox likelihood says of its coefficients. Internal to `fit_cox`.

#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_newton.hpp>
#include <statistics/cox/cox_rows.hpp>

namespace tcert::statistics {

/// Sets the variances (model and robust), the three tests, the coefficients and the information
/// criteria of `fit`, whose likelihoods, degrees of freedom and coefficients are there.
void add_cox_inference(const CoxData& data,
                       const CoxRows& rows,
                       const CoxMaximum& maximum,
                       CoxFit& fit);

}  // namespace tcert::statistics
