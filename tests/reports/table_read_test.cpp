#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "reports/table.hpp"

namespace tcert {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Table every_kind() {
  Table table;
  table.name = "every_kind";
  table.title = "Every kind of column & cell";
  table.columns = {{"who", "who", "", ColumnKind::text},
                   {"n", "n", "", ColumnKind::integer},
                   {"speed_mps", "speed", "m/s", ColumnKind::number, 2},
                   {"sd", "SD", "", ColumnKind::number, 3, 4},
                   {"auc", "AUC", "", ColumnKind::estimate, 3},
                   {"p", "p", "", ColumnKind::p_value}};
  table.add_row({std::string("a, \"b\" | _c"),
                 std::int64_t{-3},
                 Number{1.0 / 3.0},
                 Number{1.23456e-9},
                 Estimate{0.1, -0.2, 0.4},
                 PValue{1e-7}});
  table.add_row({std::monostate{},
                 std::monostate{},
                 std::monostate{},
                 Number{-12.0, 0},
                 Estimate{0.5, kNaN, kNaN, 1},
                 std::monostate{}});
  table.add_row({std::string(),
                 std::int64_t{0},
                 Number{-0.0001},
                 Number{kNaN},
                 std::monostate{},
                 PValue{0.05}});
  table.footnotes = {"One.", "Two \u03b2."};
  table.synthetic = SyntheticLabel{18446744073709551615ULL};
  table.n = 660;
  return table;
}

TEST(TableFromJson, GivesEveryFormatTheSameAgain) {
  for (const bool labelled : {true, false}) {
    Table table = every_kind();
    if (!labelled) {
      table.synthetic.reset();
      table.n.reset();
    }
    const Table again = table_from_json(render(table, TableFormat::json));
    for (const TableFormat format : {TableFormat::text,
                                     TableFormat::markdown,
                                     TableFormat::csv,
                                     TableFormat::json,
                                     TableFormat::jsonl,
                                     TableFormat::latex}) {
      EXPECT_EQ(render(again, format), render(table, format)) << to_string(format);
    }
  }
}

TEST(TableFromJson, RefusesWhatIsNoTable) {
  EXPECT_THROW((void)table_from_json("{"), std::invalid_argument);
  EXPECT_THROW((void)table_from_json("{}"), std::invalid_argument);
  std::string text = render(every_kind(), TableFormat::json);
  text.replace(text.find("\"estimate\""), 10, "\"estimat3\"");
  EXPECT_THROW((void)table_from_json(text), std::invalid_argument);
}

TEST(Table, AlignsNumbersInLatexAndKeepsWordsInBraces) {
  const std::string tex = render(every_kind(), TableFormat::latex);
  EXPECT_NE(
      tex.find("\\begin{tabular}{lS[table-format=-1]S[table-format=1.2]rS[table-format=1.3]@{\\ "
               "}rS[table-format=<1.3]}"),
      std::string::npos)
      << tex;
  EXPECT_NE(tex.find("\\multicolumn{2}{c}{AUC}"), std::string::npos) << tex;
  EXPECT_NE(tex.find("0.100 & {[}$-$0.200, 0.400] & <0.001"), std::string::npos) << tex;
  EXPECT_NE(tex.find("{NA} & {NA}"), std::string::npos) << tex;
}

}  // namespace
}  // namespace tcert
