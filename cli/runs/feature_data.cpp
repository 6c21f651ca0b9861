#include "cli/runs/feature_data.hpp"

#include <stdexcept>
#include <table/bytes.hpp>
#include <table/read_data_table.hpp>

#include "reports/features_table.hpp"

namespace tcert::cli {

FeatureData::FeatureData(const Bundle& bundle) : features_(features_table(bundle)) {}

void FeatureData::add(const study::TrialRecord& trial) { features_.add_row(features_row(trial)); }

table::DataTable FeatureData::table() const {
  table::CsvOptions csv;
  csv.file = "features.csv";
  table::DataTableResult read =
      table::read_data_table(table::Bytes::copy_of(render(features_, TableFormat::csv)), {}, csv);
  if (!read.table) {
    throw std::logic_error("the features cannot be read back: " +
                           table::to_string(read.diagnostics.front()));
  }
  return std::move(*read.table);
}

}  // namespace tcert::cli
