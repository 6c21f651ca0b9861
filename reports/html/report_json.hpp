#pragma once
/// \file
/// What the page shows beside trials, as the JSON that its scripts read.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/figure/figure.hpp"
#include "reports/html/findings_json.hpp"
#include "reports/results/results.hpp"
#include "reports/table.hpp"

namespace tcert {

struct PageTable {
  std::string source;    ///< The result that holds it.
  bool is_main = false;  ///< To be read first; else shown on demand.
  Table table;
  std::string group = {};  ///< result_title() of the result that holds it.
};

/// Pictures that a result holds step by step; `frames` of PageData has their bytes.
struct PageFrames {
  struct Frame {
    std::string name;
    std::string type;      ///< image/svg+xml or image/png.
    std::size_t line = 0;  ///< Of PageData::frames.
  };
  std::string title;
  std::vector<Frame> frames;
};

struct PageContents {
  std::string title;
  std::string lead;  ///< One sentence below it.
  std::optional<SyntheticLabel> synthetic;
  std::vector<PageFindings> findings;
  std::vector<PageTable> tables;
  std::vector<Figure> figures;
  std::vector<Result> results;
  std::vector<PageFrames> frames;
  std::vector<std::string> left_out;  ///< Sentences: what is not on the page, and why.
  std::vector<std::string> packages;
};

/// One line of JSON.
[[nodiscard]] std::string report_json(const PageContents& contents);

}  // namespace tcert
