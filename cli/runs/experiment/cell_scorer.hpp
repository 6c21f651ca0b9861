#pragma once
/// \file
/// H1 and H3 of the tables of cells, each distinct table scored once and kept in the cache.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <table/data_table.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"
#include "cli/runs/experiment/cache.hpp"
#include "cli/runs/experiment/cell_files.hpp"
#include "reports/experiment/cells_text.hpp"

namespace tcert::cli {

/// What an experiment needs to know of itself to score its tables.
struct Scoring {
  const CellFiles& files;
  study::H1Options h1;
  study::H3Options h3;
  Cache* store = nullptr;

  /// The rows kept under the digest of `key`, or those that `make` makes.
  [[nodiscard]] CellRows kept(const std::string& key, const std::function<CellRows()>& make) const;
};

/// H1 and issuance by table of features.
class FeatureScorer {
 public:
  explicit FeatureScorer(const Scoring& scoring)
      : scoring_(scoring), rows_(scoring.files.features.size()) {}

  /// Panels, then issuance as the last row. `full` and `cell` are indices of tables of features.
  const CellRows& rows(std::size_t cell, std::size_t full, double landmark_s);

 private:
  [[nodiscard]] CellRows scored(std::size_t cell, std::size_t full, double landmark_s);
  [[nodiscard]] std::string key_of(std::size_t cell, std::size_t full, double landmark_s) const;

  const Scoring& scoring_;
  std::vector<std::optional<CellRows>> rows_;
  std::optional<table::DataTable> full_;
};

/// H3 by table of replays.
class SpeedScorer {
 public:
  explicit SpeedScorer(const Scoring& scoring)
      : scoring_(scoring), rows_(scoring.files.replays.size()) {}

  const CellRows& rows(std::size_t cell);

 private:
  [[nodiscard]] CellRows scored(std::size_t cell) const;
  [[nodiscard]] std::string key_of(std::size_t cell) const;

  const Scoring& scoring_;
  std::vector<std::optional<CellRows>> rows_;
};

}  // namespace tcert::cli
