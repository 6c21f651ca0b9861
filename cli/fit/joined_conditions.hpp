#pragma once
/// \file
/// What is said of many levels of one factor, in one line.

#include "analysis/basics/condition.hpp"
#include "analysis/model/model_frame.hpp"

namespace tcert::cli {

/// Conditions of one kind, severity and advice about more than three columns of one term become
/// one, where the first of them stood. Its column is the term; its detail counts and names them, up
/// to eight, and gives the detail of the first.
[[nodiscard]] Conditions joined(const ModelFrame& frame, const Conditions& conditions);

}  // namespace tcert::cli
