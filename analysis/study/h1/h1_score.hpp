#pragma once
/// \file
/// How a bootstrapped value becomes a score of H1 or H2.

#include <cstddef>
#include <optional>
#include <statistics/resampling/bootstrap.hpp>
#include <string>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// Sets the intervals of `score` to those of value number `value`, and its value if it has none.
/// `units` is of how many clusters the value is made, where that is not all of them. What the
/// interval that is read met is added to `conditions`, `quantity` before its detail.
void take_score(const statistics::BootstrapResult& result,
                std::size_t value,
                const H1Options& options,
                const std::string& quantity,
                H1Score& score,
                statistics::Conditions& conditions,
                std::optional<std::size_t> units = {});

}  // namespace tcert::study
