#include "reports/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tcert {
namespace {

Table small_table() {
  Table table;
  table.name = "auc";
  table.title = "AUC by predictor";
  table.columns = {{"predictor", "predictor", "", ColumnKind::text},
                   {"trials", "trials", "", ColumnKind::integer},
                   {"speed_mps", "speed", "m/s", ColumnKind::number, 2},
                   {"auc", "AUC", "", ColumnKind::estimate, 3},
                   {"p", "p", "", ColumnKind::p_value}};
  table.add_row({std::string("TC_early"),
                 std::int64_t{660},
                 Number{0.1},
                 Estimate{0.78125, 0.7, 0.85},
                 PValue{0.0001}});
  table.add_row({std::string("dwell, \"slow\" | x"),
                 std::monostate{},
                 Number{-0.001},
                 std::monostate{},
                 PValue{0.04567}});
  table.footnotes = {"Intervals by DeLong."};
  table.n = 660;
  return table;
}

TEST(Table, PrintsAlignedText) {
  EXPECT_EQ(render(small_table(), TableFormat::text),
            "AUC by predictor (n = 660)\n"
            "\n"
            "predictor          trials  speed [m/s]                   AUC       p\n"
            "-----------------  ------  -----------  --------------------  ------\n"
            "TC_early              660         0.10  0.781 [0.700, 0.850]  <0.001\n"
            "dwell, \"slow\" | x      NA         0.00                    NA   0.046\n"
            "\n"
            "Intervals by DeLong.\n");
}

TEST(Table, PrintsMarkdownWithEscapes) {
  Table table = small_table();
  table.synthetic = SyntheticLabel{7};
  EXPECT_EQ(render(table, TableFormat::markdown),
            "**SYNTHETIC data, seed 7: made by a program, not measured on a robot.**\n"
            "\n"
            "### AUC by predictor (n = 660)\n"
            "\n"
            "| predictor          | trials | speed [m/s] |                  AUC |       p |\n"
            "|--------------------|-------:|------------:|---------------------:|--------:|\n"
            "| TC\\_early          |    660 |        0.10 | 0.781 [0.700, 0.850] | \\<0.001 |\n"
            "| dwell, \"slow\" \\| x |     NA |        0.00 |                   NA |   0.046 |\n"
            "\n"
            "Intervals by DeLong.\n");
}

TEST(Table, WritesCsvAtFullPrecisionWithIntervalColumns) {
  Table table = small_table();
  table.synthetic = SyntheticLabel{7};
  EXPECT_EQ(render(table, TableFormat::csv),
            "predictor,trials,speed_mps,auc,auc_low,auc_high,p,synthetic_seed\n"
            "TC_early,660,0.1,0.78125,0.7,0.85,1e-04,7\n"
            "\"dwell, \"\"slow\"\" | x\",,-0.001,,,,0.04567,7\n");
}

TEST(Table, WritesJsonWithNullForMissing) {
  const auto json = nlohmann::json::parse(render(small_table(), TableFormat::json));
  EXPECT_EQ(json["synthetic"], false);
  EXPECT_EQ(json["n"], 660);
  EXPECT_EQ(json["rows"][0]["auc"], 0.78125);
  EXPECT_EQ(json["rows"][0]["auc_low"], 0.7);
  EXPECT_TRUE(json["rows"][1]["auc"].is_null());
  EXPECT_TRUE(json["rows"][1]["auc_high"].is_null());
  EXPECT_TRUE(json["rows"][1]["trials"].is_null());
  EXPECT_EQ(json["columns"][3]["kind"], "estimate");
}

TEST(Table, WritesOneJsonObjectALine) {
  Table table = small_table();
  table.synthetic = SyntheticLabel{7};
  const std::string lines = render(table, TableFormat::jsonl);
  EXPECT_EQ(lines.substr(0, lines.find('\n')),
            R"({"predictor":"TC_early","trials":660,"speed_mps":0.1,"auc":0.78125,"auc_low":0.7,)"
            R"("auc_high":0.85,"p":0.0001,"synthetic_seed":7})");
}

TEST(Table, NamesSyntheticDataAndSeedInTheFirstLineOfEveryFormat) {
  Table table = small_table();
  table.synthetic = SyntheticLabel{41};
  for (const TableFormat format : {TableFormat::text, TableFormat::markdown}) {
    const std::string text = render(table, format);
    EXPECT_NE(text.substr(0, text.find('\n')).find("SYNTHETIC data, seed 41"), std::string::npos);
  }
  const std::string csv = render(table, TableFormat::csv);
  EXPECT_NE(csv.substr(0, csv.find('\n')).find("synthetic"), std::string::npos);
  const auto json = nlohmann::json::parse(render(table, TableFormat::json));
  EXPECT_EQ(json["synthetic"], true);
  EXPECT_EQ(json["seed"], 41);
}

TEST(Table, TakesWhatIsNotFiniteForMissing) {
  Table table;
  table.name = "t";
  table.columns = {{"x", "x", "", ColumnKind::number}, {"e", "e", "", ColumnKind::estimate}};
  const double infinity = std::numeric_limits<double>::infinity();
  table.add_row({Number{-infinity}, Estimate{0.5, -infinity, 0.7}});
  EXPECT_EQ(render(table, TableFormat::csv), "x,e,e_low,e_high\n,0.5,,0.7\n");
  EXPECT_EQ(printed(table.rows[0][0], table.columns[0]), "NA");
  EXPECT_EQ(printed(table.rows[0][1], table.columns[1]), "0.500 [NA, 0.700]");
  const auto json = nlohmann::json::parse(render(table, TableFormat::json));
  EXPECT_TRUE(json["rows"][0]["x"].is_null());
}

TEST(Table, RefusesARowOfAnotherShape) {
  Table table = small_table();
  EXPECT_THROW(table.add_row({std::string("alone")}), std::invalid_argument);
  EXPECT_THROW(
      table.add_row(
          {std::string("a"), Number{1.0}, Number{0.1}, std::monostate{}, std::monostate{}}),
      std::invalid_argument);
}

TEST(Table, AlignsCharactersNotBytes) {
  Table table;
  table.name = "t";
  table.title = "t";
  table.columns = {{"a", "β", "", ColumnKind::text}, {"b", "b", "", ColumnKind::integer}};
  table.add_row({std::string("ααα"), std::int64_t{1}});
  table.add_row({std::string("abc"), std::int64_t{2}});
  EXPECT_EQ(render(table, TableFormat::text), "t\n\nβ      b\n---  ---\nααα    1\nabc    2\n");
}

TEST(Table, PrintsLatexWithItsCharactersEscaped) {
  const std::string tex = render(small_table(), TableFormat::latex);
  EXPECT_NE(tex.find("TC\\_early & 660 & 0.10 & 0.781 & {[}0.700, 0.850] & <0.001 \\\\\n"),
            std::string::npos)
      << tex;
}

TEST(Table, PrintsSignificantDigitsWhereTheColumnSaysSo) {
  EXPECT_EQ(significant(0.00012345678, 4), "0.0001235");
  EXPECT_EQ(significant(1234567.0, 4), "1.235e+06");
  EXPECT_EQ(significant(std::nan(""), 4), "NA");
}

TEST(TableFormatWords, ReadBack) {
  for (const TableFormat format : {TableFormat::text,
                                   TableFormat::markdown,
                                   TableFormat::csv,
                                   TableFormat::json,
                                   TableFormat::jsonl,
                                   TableFormat::latex}) {
    EXPECT_EQ(table_format_from(to_string(format)), format);
  }
  EXPECT_FALSE(table_format_from("latex").has_value());
}

TEST(Fixed, HasNoNegativeZero) {
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(-0.4, 0), "0");
}

}  // namespace
}  // namespace tcert
