// What a cell says. Numbers against R 4.2.2: read.csv(text = "v\n<cell>\n1")$v.

#include <table/cell_reading.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <table/mixed_cells.hpp>
#include <table/outcome_word.hpp>
#include <utility>

namespace tcert::table {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(CellReading, TakesRsNumbers) {
  for (const auto& [cell, value] : {std::pair{"1", 1.0},
                                    {"-1.5e3", -1500.0},
                                    {"+.5", 0.5},
                                    {"1.", 1.0},
                                    {" 2\t", 2.0},
                                    {"0x1F", 31.0},
                                    {"-0x1.8p3", -12.0},
                                    {"1e-400", 0.0},
                                    {"-1e-400", 0.0},
                                    {"1e400", kInfinity},
                                    {"-1e400", -kInfinity},
                                    {"inf", kInfinity},
                                    {"+Inf", kInfinity},
                                    {"-INF", -kInfinity},
                                    {"infinity", kInfinity},
                                    {"-Infinity", -kInfinity}}) {
    const CellReading reading = read_cell(cell);
    EXPECT_EQ(reading.meaning, CellMeaning::number) << cell;
    EXPECT_EQ(reading.value, value) << cell;
  }
}

TEST(CellReading, TakesWhatPrintfWritesForNotANumberAsMissing) {
  for (const char* cell : {"",
                           "  ",
                           "NA",
                           "nan",
                           "NaN",
                           "NAN",
                           "-nan",
                           "+nan",
                           "-NaN",
                           "nan(ind)",
                           "-nan(ind)",
                           "nan(snan)",
                           "nan()"}) {
    EXPECT_EQ(read_cell(cell).meaning, CellMeaning::missing) << cell;
    EXPECT_TRUE(is_missing_cell(cell)) << cell;
    EXPECT_TRUE(std::isnan(read_cell(cell).value)) << cell;
  }
}

TEST(CellReading, KnowsWordsForMissingCellsButDoesNotTakeThem) {
  for (const char* cell : {"na",
                           "Na",
                           "N/A",
                           "n/a",
                           "null",
                           "NULL",
                           "None",
                           "none",
                           "<NA>",
                           "#N/A",
                           "-",
                           "--",
                           ".",
                           "?",
                           "NaT",
                           "\\N",
                           "\xE2\x80\x93",
                           "1.#IND"}) {
    EXPECT_EQ(read_cell(cell).meaning, CellMeaning::missing_word) << cell;
    EXPECT_FALSE(is_missing_cell(cell)) << cell;
  }
}

TEST(CellReading, TakesTruthValuesInTheirFourSpellings) {
  for (const char* cell : {"TRUE", "True", "true", "T"}) {
    EXPECT_EQ(read_cell(cell).meaning, CellMeaning::truth) << cell;
    EXPECT_EQ(read_cell(cell).value, 1.0) << cell;
  }
  for (const char* cell : {"FALSE", "False", "false", "F"}) {
    EXPECT_EQ(read_cell(cell).meaning, CellMeaning::truth) << cell;
    EXPECT_EQ(read_cell(cell).value, 0.0) << cell;
  }
}

TEST(CellReading, TakesEverythingElseAsText) {
  for (const char* cell : {"abc",
                           "1d2",
                           "1L",
                           "1e",
                           "1_000",
                           "-NA",
                           "infin",
                           "nanometre",
                           "nan(",
                           "t",
                           "tRUE",
                           "0x",
                           "0xg",
                           "0xinf",
                           "+-1",
                           "1 2",
                           "1,5",
                           "1.2.3"}) {
    EXPECT_EQ(read_cell(cell).meaning, CellMeaning::text) << cell;
    EXPECT_TRUE(std::isnan(read_cell(cell).value)) << cell;
  }
}

TEST(CellReading, FollowsTheDecimalPoint) {
  EXPECT_EQ(read_cell("-1,5", ',').value, -1.5);
  EXPECT_EQ(read_cell("1.5", ',').meaning, CellMeaning::text);
  EXPECT_EQ(read_cell("-inf", ',').value, -kInfinity);
}

TEST(OutcomeWord, MeansWhatItSays) {
  for (const char* cell : {"1",
                           "1.0",
                           "True",
                           "TRUE",
                           "t",
                           "T",
                           "yes",
                           "Success",
                           "s",
                           "S",
                           "OK",
                           "ok",
                           "pass",
                           "succeeded"}) {
    EXPECT_EQ(outcome_of_cell(cell), OutcomeWord::success) << cell;
  }
  for (const char* cell : {"0", "0.0", "False", "f", "no", "Failure", "failed", "fail", "F"}) {
    EXPECT_EQ(outcome_of_cell(cell), OutcomeWord::failure) << cell;
  }
  for (const char* cell : {"", "NA", "nan", "-nan"}) {
    EXPECT_EQ(outcome_of_cell(cell), OutcomeWord::missing) << cell;
  }
  for (const char* cell : {"2", "-1", "inf", "goal", "None", "N/A", "0.5"}) {
    EXPECT_EQ(outcome_of_cell(cell), OutcomeWord::unknown) << cell;
  }
}

MixedCells mixed(std::size_t numbers,
                 std::size_t distinct_numbers,
                 std::size_t texts,
                 std::size_t distinct_texts,
                 std::size_t missing_words = 0) {
  MixedCells cells;
  cells.numbers = numbers;
  cells.distinct_numbers = distinct_numbers;
  cells.texts = texts;
  cells.distinct_texts = distinct_texts;
  cells.missing_words = missing_words;
  return cells;
}

TEST(MixedCells, TellASpoiledColumnFromNames) {
  EXPECT_FALSE(mixed(30, 30, 0, 0).is_spoiled());
  // Words for missing cells, however many, and whatever the numbers.
  EXPECT_TRUE(mixed(24, 24, 0, 0, 6).is_spoiled());
  EXPECT_TRUE(mixed(1, 1, 0, 0, 99).is_spoiled());
  EXPECT_TRUE(mixed(60, 2, 0, 0, 40).is_spoiled());
  // Typing errors in a measured column: few, and many of the same.
  EXPECT_TRUE(mixed(29, 29, 1, 1).is_spoiled());
  EXPECT_TRUE(mixed(40, 35, 60, 1).is_spoiled());
  EXPECT_TRUE(mixed(700, 15, 300, 2).is_spoiled());
  // Levels '1', '2', 'a'; rooms '101', '102', 'B1', 'B2'; ids that are mostly names.
  EXPECT_FALSE(mixed(60, 2, 30, 1).is_spoiled());
  EXPECT_FALSE(mixed(50, 5, 30, 3).is_spoiled());
  EXPECT_FALSE(mixed(2, 2, 2, 2).is_spoiled());
  EXPECT_FALSE(mixed(40, 40, 60, 60).is_spoiled());
  EXPECT_FALSE(mixed(0, 0, 60, 3, 5).is_spoiled());
  // 'F' and 'M': that F alone would be a truth value does not count.
  MixedCells sexes = mixed(0, 0, 20, 1);
  sexes.truths = 80;
  EXPECT_FALSE(sexes.is_spoiled());
  MixedCells flags = mixed(0, 0, 0, 0, 1);
  flags.truths = 9;
  EXPECT_TRUE(flags.is_spoiled());
}

}  // namespace
}  // namespace tcert::table
