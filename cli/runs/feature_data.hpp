#pragma once
/// \file
/// Features of certified trials as the table that a hypothesis is tested on: what features.csv
/// would read back as.

#include <table/data_table.hpp>

#include "analysis/study/trials/study_tables.hpp"
#include "datasets/bundle.hpp"
#include "reports/table.hpp"

namespace tcert::cli {

class FeatureData {
 public:
  explicit FeatureData(const Bundle& bundle);

  void add(const study::TrialRecord& trial);

  /// Written as CSV and read again, so that a bundle and its features.csv give the same numbers.
  [[nodiscard]] table::DataTable table() const;

 private:
  Table features_;
};

}  // namespace tcert::cli
