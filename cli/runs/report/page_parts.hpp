#pragma once
/// \file
/// Tables and step-by-step pictures of a tree of results, for the page.

#include <string>
#include <vector>

#include "reports/html/page.hpp"
#include "reports/html/report_json.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {

/// What each result found: its table `findings`. Results of older versions have none.
[[nodiscard]] std::vector<PageFindings> page_findings(const Results& results);

/// Every other table that a result holds as <name>.json, by result: those that a paper prints
/// first. Tables of more than 200 rows are named in `left_out` and stay in their files.
[[nodiscard]] std::vector<PageTable> page_tables(const Results& results,
                                                 std::vector<std::string>& left_out);

/// The pictures of each folder <result>/frames (*.svg, *.png), by name; their bytes go into
/// `page.frames`. \throws BadData if one cannot be read.
[[nodiscard]] std::vector<PageFrames> page_frames(const Results& results, PageData& page);

}  // namespace tcert::cli
