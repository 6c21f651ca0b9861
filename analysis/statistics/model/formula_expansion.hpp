#pragma once
/// \file
/// The right-hand side of a formula as terms. Internal to formula.cpp.

#include <statistics/model/formula.hpp>

namespace tcert::statistics {

/// Sets the terms of `formula`, in R's order; what is no term (offset(), strata(), cluster(), the
/// intercept, random terms) goes where it belongs. \throws FormulaError, which names formula.text.
void expand_right_side(const Expression& side, Formula& formula);

}  // namespace tcert::statistics
