#include "cli/commands/help_topics.hpp"

#include <array>
#include <string>
#include <vector>

#include "analysis/study/trials/parameters.hpp"
#include "cli/commands/field_listing.hpp"
#include "reports/edges_table.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

Table parameter_listing() {
  Table table;
  table.name = "parameters";
  table.title = "Parameters: in config files, as flags (--KEY VALUE) and with --set KEY=VALUE";
  table.columns = {{"key", "key", "", ColumnKind::text},
                   {"default", "default", "", ColumnKind::text},
                   {"unit", "unit", "", ColumnKind::text},
                   {"stage", "changes from", "", ColumnKind::text},
                   {"accepts", "accepts", "", ColumnKind::text},
                   {"doc", "what, and when to change it", "", ColumnKind::text}};
  const study::ParameterSet defaults;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    table.add_row({std::string(parameter.key),
                   parameter.get(defaults),
                   std::string(parameter.unit),
                   std::string(study::to_string(parameter.stage)),
                   parameter.accepts,
                   std::string(parameter.doc)});
  }
  table.footnotes = {
      "Precedence: these defaults, then the bundle's own parameters, then --config, then flags."};
  return table;
}

Table column_listing() {
  Table table;
  table.name = "columns";
  table.title = "Columns of the files that 'tcert certify' writes";
  table.columns = {{"file", "file", "", ColumnKind::text},
                   {"column", "column", "", ColumnKind::text},
                   {"unit", "unit", "", ColumnKind::text},
                   {"doc", "what", "", ColumnKind::text}};
  const auto append = [&](const char* file, const std::vector<ColumnDoc>& columns) {
    for (const ColumnDoc& column : columns) {
      table.add_row({std::string(file), column.name, column.unit, column.doc});
    }
  };
  append("series/<trial_id>.csv", series_columns());
  append("edges/<trial_id>.csv", edge_column_docs());
  append("features.csv", feature_column_docs());
  append("certificates.csv", certificate_column_docs());
  table.footnotes = {"An empty cell is a value that is not known."};
  return table;
}

constexpr std::array kTopics{
    HelpTopic{"parameters", "every parameter of certificate, study and control", parameter_listing},
    HelpTopic{"columns", "every column of the results of each tick and trial", column_listing},
    HelpTopic{"bundle", "the files of a log bundle and their columns", bundle_listing}};

}  // namespace

std::span<const HelpTopic> help_topics() { return kTopics; }

}  // namespace tcert::cli
