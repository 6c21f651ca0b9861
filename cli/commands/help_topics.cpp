#include "cli/commands/help_topics.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tcert/rule_formula.hpp>
#include <tcert/tick_signals.hpp>
#include <vector>

#include "analysis/study/trials/parameters.hpp"
#include "cli/commands/field_listing.hpp"
#include "datasets/driven/driven_trial.hpp"
#include "reports/columns_of.hpp"
#include "reports/edges_table.hpp"
#include "reports/features_table.hpp"
#include "reports/series.hpp"

namespace tcert::cli {
namespace {

Table parameter_listing() {
  using Parameter = study::ParameterInfo;
  Table table =
      ColumnsOf<Parameter>()
          .text("key", "key", [](auto& one) { return std::string(one.key); })
          .text("default", "default", [](auto& one) { return one.get(study::ParameterSet()); })
          .text("unit", "unit", [](auto& one) { return std::string(one.unit); })
          .text("stage",
                "changes from",
                [](auto& one) { return std::string(study::to_string(one.stage)); })
          .text("accepts", "accepts", &Parameter::accepts)
          .text(
              "doc", "what, and when to change it", [](auto& one) { return std::string(one.doc); })
          .table("parameters",
                 "Parameters: in config files, as flags (--KEY VALUE) and with --set KEY=VALUE",
                 study::parameter_table());
  table.footnotes = {
      "Precedence: these defaults, then the bundle's own parameters, then --config, then flags."};
  return table;
}

Table column_listing() {
  struct ListedColumn : RowOf<ColumnDoc> {
    const char* file;
  };
  const auto columns = ColumnsOf<ListedColumn>()
                           .text("file", "file", [](auto& row) { return std::string(row.file); })
                           .text("column", "column", &ColumnDoc::name)
                           .text("unit", "unit", &ColumnDoc::unit)
                           .text("doc", "what", &ColumnDoc::doc);
  Table table =
      columns.table("columns", "Columns of the files that 'tcert certify' and 'tcert drive' write");
  const auto append = [&](const char* file, const std::vector<ColumnDoc>& docs) {
    for (const ColumnDoc& doc : docs) {
      table.add_row(columns.row({{doc}, file}));
    }
  };
  append("series/<trial_id>.csv", series_columns());
  append("edges/<trial_id>.csv", edge_column_docs());
  append("features.csv", feature_column_docs());
  append("certificates.csv", certificate_column_docs());
  std::vector<ColumnDoc> driven;
  for (const DrivenColumn& column : driven_columns()) {
    driven.push_back({column.name, column.unit, column.doc});
  }
  append("trials.csv (drive)", driven);
  table.footnotes = {"An empty cell is a value that is not known."};
  return table;
}

Table rule_listing() {
  using Signal = SignalDoc;
  Table table =
      ColumnsOf<Signal>()
          .text("signal", "signal", [](auto& one) { return std::string(one.name); })
          .text("unit", "unit", [](auto& one) { return std::string(one.unit); })
          .text("doc", "what it is at a tick", [](auto& one) { return std::string(one.doc); })
          .table("rules", "Rules: what they may speak of", tick_signals());
  table.footnotes = {
      "A file of rules has one a line, 'name: formula'; what follows # is left out. With 'watch' "
      "before its name a rule is stated and backs nothing out ('watch name: formula'). A formula "
      "is a "
      "comparison of sums (force_n > force_limit_n; 2*width_m - 0.1 < margin_m), missing(SIGNAL), "
      "not "
      "F, F and G, F or G, F since G (F has held ever since G did), once[a,b] F (at some time from "
      "b "
      "to a seconds ago), historically[a,b] F (at all of them; b may be inf, and without [a,b] it "
      "is "
      "always), in parentheses where need be. 'not' and the two windows bind more strongly than "
      "'and', "
      "that more than 'or', that more than 'since'.",
      "At most 32 rules, windows of at most 600 s and 6000 s together. A factor stands before its "
      "signal "
      "(2*width_m); '<' and '<=' are the same. A certificate before there is one is -inf, which is "
      "known. "
      "unchanged_s is for sensors with noise: in a simulation without it rays read the same for "
      "long.",
      "A rule alarms at the ticks at which it surely holds: a missing signal may be anything. A "
      "window that reaches back beyond the first tick looks at what there is: 'time_s >= 2 and "
      "historically[0,2] F' waits for two seconds.",
      "The default rules are:"};
  std::string_view rules = default_rules();
  while (!rules.empty()) {
    const std::size_t end = std::min(rules.find('\n'), rules.size());
    if (rules.front() != '#') {
      table.footnotes.emplace_back(rules.substr(0, end));
    }
    rules.remove_prefix(std::min(end + 1, rules.size()));
  }
  return table;
}

constexpr std::array kTopics{
    HelpTopic{"parameters", "every parameter of certificate, study and control", parameter_listing},
    HelpTopic{"columns", "every column of the results of each tick and trial", column_listing},
    HelpTopic{"bundle", "the files of a log bundle and their columns", bundle_listing},
    HelpTopic{"map", "the keys of the map by which foreign logs are imported", map_listing},
    HelpTopic{"rules", "what rules of a monitor may say, and the default ones", rule_listing}};

}  // namespace

std::span<const HelpTopic> help_topics() { return kTopics; }

}  // namespace tcert::cli
