#pragma once
/// \file
/// Values of the options of `explore` that are more than a number or a word.

#include <string>
#include <terrain/body.hpp>
#include <terrain/field_scale.hpp>
#include <vector>

namespace tcert::cli {

/// "X,Y". \throws UsageError naming the option.
[[nodiscard]] terrain::Cell cell_of(const std::string& option, const std::string& text);

/// "X,Y;X,Y"; none of an empty text. \throws UsageError.
[[nodiscard]] std::vector<terrain::Cell> cells_of(const std::string& option,
                                                  const std::string& text);

/// "R", "LENGTH,WIDTH" or "LENGTH,WIDTH,YAW_DEG"; a point of an empty text. \throws UsageError.
[[nodiscard]] terrain::Body body_of(const std::string& text);

/// "SD,PLACES"; none of an empty text. \throws UsageError.
[[nodiscard]] terrain::GradientPrior gradient_prior_of(const std::string& text);

/// Measurements of a CSV with columns x, y and value, in its order; those of cells outside of
/// `grid` or blocked are errors. None of an empty path. \throws NoInput, BadData.
[[nodiscard]] std::vector<terrain::Measurement> known_of(const std::string& path,
                                                         const terrain::Grid& grid,
                                                         const terrain::CellSet& blocked);

}  // namespace tcert::cli
