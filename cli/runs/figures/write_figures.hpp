#pragma once
/// \file
/// Writing the figures of a tree of results as files.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/runs/result_folder.hpp"
#include "reports/figure/figure.hpp"
#include "reports/figure/figures_of.hpp"

namespace tcert::cli {

struct FigureFiles {
  std::size_t figures = 0;
  bool drawn = false;  ///< gnuplot was there: SVG and PDF were written.
  std::vector<MissingFigure> missing;
};

/// <name>.vl.json, <name>.csv and <name>.gp of a figure, and where gnuplot is installed <name>.svg
/// and <name>.pdf, which are the same bytes for the same figure. \throws WriteError;
/// std::runtime_error with gnuplot's words if it fails.
void write_figure(const Figure& figure, const ResultFolder& folder, bool draw);

/// Every figure of the study and those of `trials` (series and map of each).
/// \throws MissingResult, WriteError.
[[nodiscard]] FigureFiles write_figures(const Results& results,
                                        const std::vector<std::string>& trials,
                                        const ResultFolder& folder);

}  // namespace tcert::cli
