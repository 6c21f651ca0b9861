#include <table/read_data_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <table/check_csv.hpp>
#include <vector>

#include "support/temporary_folder.hpp"

namespace tcert::table {
namespace {

using Names = std::vector<std::string>;

DataTableResult read(const std::string& csv) {
  CsvOptions options;
  options.file = "t.csv";
  return read_data_table(Bytes::copy_of(csv), {}, options);
}

TEST(DataTable, ReadsTheCellsOfRobotsAndOfPandas) {
  const DataTableResult result =
      read("x,range,ok\n-nan,+inf,True\n0.5,infinity,False\nnan(ind),-Infinity,NA\nNA,0x10,True\n");
  ASSERT_TRUE(result.table);
  EXPECT_TRUE(result.diagnostics.empty());
  const auto& columns = result.table->columns;
  EXPECT_FALSE(columns[0].is_text);
  EXPECT_TRUE(std::isnan(columns[0].numbers[0]));
  EXPECT_EQ(columns[0].numbers[1], 0.5);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(columns[1].numbers, (std::vector<double>{inf, inf, -inf, 16.0}));
  EXPECT_TRUE(columns[2].is_truth);
  EXPECT_EQ(columns[2].numbers[1], 0.0);
}

TEST(DataTable, TruthValuesStandBesideZeroAndOneOnly) {
  const auto table = read("a,b,c\n1,1.5,F\nTRUE,TRUE,M\n0,2.5,F\n").table.value();
  EXPECT_FALSE(table.columns[0].is_text);
  EXPECT_FALSE(table.columns[0].is_truth);
  EXPECT_TRUE(table.columns[1].is_text);  // R reads it so too
  EXPECT_EQ(table.columns[2].text.levels, (Names{"F", "M"}));
}

TEST(DataTable, AWordForAMissingCellMakesNoNumber) {
  const DataTableResult result = read("x,y\n1,1\nN/A,2\n3,N/A\nN/A,4\nN/A,5\n");
  ASSERT_TRUE(result.table);
  const MixedCells& mixed = result.table->columns[0].mixed;
  EXPECT_EQ(mixed.numbers, 2U);
  EXPECT_EQ(mixed.missing_words, 3U);
  EXPECT_EQ(mixed.first_row, 1U);
  EXPECT_TRUE(mixed.is_spoiled());
  EXPECT_EQ(to_string(result.diagnostics.at(0)),
            "t.csv:3: warning: column 'x': found 'N/A', expected a number, as in its 2 other cells "
            "(a missing cell is empty, NA or nan); the column is taken as text");
}

TEST(DataTable, NamesThatDifferInCaseAreTwoColumns) {
  const DataTableResult two = read("Success,success\n1,2\n3,4\n");
  ASSERT_TRUE(two.table);
  EXPECT_EQ(two.table->find("success")->numbers, (std::vector<double>{2, 4}));
  EXPECT_EQ(two.table->find("Success")->numbers, (std::vector<double>{1, 3}));
  const DataTableResult same = read("x,y,x\n1,2,3\n");
  EXPECT_FALSE(same.table);
  EXPECT_EQ(to_string(same.diagnostics.at(0)),
            "t.csv:1: error: column 'x': found 'x', expected column names that differ");
}

TEST(DataTable, ARowOfMissingCellsIsNoHeader) {
  const auto table = read("1,nan\n2,-inf\n").table.value();
  EXPECT_EQ(table.header, (Names{"c1", "c2"}));
  EXPECT_EQ(table.rows, 2U);
}

// `check` and the tables that fits read go by one rule: what one calls an error the other refuses.
TEST(DataTable, AgreesWithCheck) {
  const test_support::TemporaryFolder folder;
  const Names words{"-nan",
                    "+inf",
                    "infinity",
                    "nan(ind)",
                    "NA",
                    "nan",
                    "True",
                    "null",
                    "None",
                    "na",
                    "N/A",
                    "-",
                    "wide",
                    "0x1",
                    "1e",
                    "T",
                    "1e400"};
  for (const std::string& word : words) {
    std::string csv = "y,x\n";
    for (int row = 0; row < 20; ++row) {
      csv += std::to_string(row % 2) + ',';
      csv += row % 3 == 1 ? word : "0." + std::to_string(10 + row);
      csv += '\n';
    }
    const CsvCheckResult check = check_csv_file(folder.write("x.csv", csv));
    const auto table = read(csv).table.value();
    const DataColumn& column = table.columns[1];
    ASSERT_TRUE(check.check) << word;
    EXPECT_EQ(has_error(check.diagnostics), column.is_text) << word;
    EXPECT_EQ(column.is_text, column.mixed.is_spoiled()) << word;
    const ColumnCheck& seen = check.check->columns[1];
    EXPECT_EQ(seen.numbers + seen.missing + seen.texts + seen.truths, 20U) << word;
    if (!column.is_text) {
      std::size_t missing = 0;
      for (const double x : column.numbers) {
        missing += std::isnan(x) ? 1U : 0U;
      }
      EXPECT_EQ(seen.missing, missing) << word;
    }
  }
}

}  // namespace
}  // namespace tcert::table
