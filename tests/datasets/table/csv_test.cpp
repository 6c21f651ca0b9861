#include <table/csv.hpp>

#include <gtest/gtest.h>
#include <zlib.h>
#include <zstd.h>

#include <cmath>
#include <random>
#include <string>
#include <table/csv_write.hpp>
#include <vector>

#include "support/temporary_folder.hpp"

namespace tcert::table {
namespace {

struct Read {
  std::optional<NumberTable> table;
  std::vector<std::string> messages;
};

Read read(std::string_view text, CsvOptions csv = {}, bool repair = false) {
  csv.file = "a.csv";
  NumberOptions options;
  options.columns = {{"x_m"}, {"fsr_n", false, true}};
  options.repair = repair;
  DiagnosticGroups problems;
  Read result;
  result.table = read_numbers(Bytes::copy_of(text), csv, options, problems);
  for (const Diagnostic& diagnostic : problems.take()) {
    result.messages.push_back(to_string(diagnostic));
  }
  return result;
}

using Messages = std::vector<std::string>;

void expect_two_rows(const Read& result) {
  ASSERT_TRUE(result.table) << ::testing::PrintToString(result.messages);
  ASSERT_EQ(result.table->rows(), 2U);
  EXPECT_EQ(result.table->time_ns, (std::vector<std::int64_t>{100'000'000, 200'000'000}));
  EXPECT_EQ(result.table->at(0, 0), 1.5);
  EXPECT_EQ(result.table->at(1, 0), -2.0);
}

TEST(ReadNumbers, ReadsEveryDialect) {
  for (const char* text : {"time_s,x_m\n0.1,1.5\n0.2,-2\n",
                           "time_s;x_m\n0.1;1.5\n0.2;-2\n",
                           "time_s\tx_m\n0.1\t1.5\n0.2\t-2\n",
                           "time_s x_m\n0.1 1.5\n0.2 -2\n",
                           "  time_s   x_m \n 0.1    1.5\n0.2 \t -2  \n",
                           "\xEF\xBB\xBFtime_s,x_m\n0.1,1.5\n0.2,-2\n",
                           "time_s,x_m\r\n0.1,1.5\r\n0.2,-2\r\n",
                           "time_s , x_m\n 0.1 , 1.5\n0.2,-2 \n",
                           "# logged by hand\n\ntime_s,x_m\n0.1,1.5\n# a pause\n\n0.2,-2\n",
                           "\"time_s\",\"x_m\"\n\"0.1\",\"1.5\"\n\"0.2\",\"-2\"\n",
                           "x_m,extra,time_s\n1.5,,0.1\n-2,\"a,\"\"b\"\"\n,c\",0.2\n",
                           "time_s,x_m\n0.1,1.5,\n0.2,-2,\n"}) {
    SCOPED_TRACE(text);
    const Read result = read(text);
    expect_two_rows(result);
    EXPECT_EQ(result.messages, Messages{});
  }
}

TEST(ReadNumbers, TakesADecimalCommaOnlyWithTheSemicolonAndWhenAskedFor) {
  CsvOptions comma;
  comma.decimal_comma = true;
  expect_two_rows(read("time_s;x_m\n0,1;1,5\n0,2;-2\n", comma));
  expect_two_rows(read("time_s,x_m\n0.1,1.5\n0.2,-2\n", comma));
  EXPECT_FALSE(read("time_s;x_m\n0,1;1,5\n0,2;-2\n").table);
}

TEST(ReadNumbers, RenamesForeignColumns) {
  CsvOptions csv;
  csv.rename = {{"t", "time_s"}, {"pos x", "x_m"}};
  expect_two_rows(read("pos x,t\n1.5,0.1\n-2,0.2\n", csv));
}

TEST(ReadNumbers, FindsTheHeaderBehindAPreamble) {
  const Read result = read("robot,7,left\nok\ntime_s,x_m\n0.1,1.5\n0.2,-2\n");
  expect_two_rows(result);
  EXPECT_EQ(result.messages,
            (Messages{"a.csv:3: note: found '2 lines before the header', expected the header "
                      "first; the lines before it are not used"}));
}

TEST(ReadNumbers, KnowsTheLineOfEachRow) {
  const Read result = read("time_s,x_m,note\n# one\n0.1,1.5,\"a\nb\"\n\n0.2,-2,\n");
  ASSERT_TRUE(result.table);
  EXPECT_EQ(result.table->lines, (std::vector<std::uint32_t>{3, 6}));
}

TEST(ReadNumbers, TakesAnEmptyCellForMissingOnlyWhereItMayBe) {
  const Read result = read("time_s,x_m,fsr_n\n0.1,1.5,\n0.2,-2,3\n");
  expect_two_rows(result);
  EXPECT_TRUE(std::isnan(result.table->at(0, 1)));
  EXPECT_EQ(result.table->at(1, 1), 3.0);
  EXPECT_EQ(read("time_s,x_m\n0.1,\n0.2,-2\n").messages,
            (Messages{"a.csv:2: error: column 'x_m': expected a finite number; --repair drops such "
                      "rows"}));
}

TEST(ReadNumbers, TakesWhatPrintfWritesForMissingOnlyWhereItMayBe) {
  const Read result = read("time_s,x_m,fsr_n\n0.1,1.5,-nan\n0.2,-2,NA\n0.3,4,nan(ind)\n");
  ASSERT_TRUE(result.table);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_TRUE(std::isnan(result.table->at(row, 1))) << row;
  }
  EXPECT_FALSE(read("time_s,x_m,fsr_n\n0.1,-nan,1\n0.2,-2,3\n").table);
  EXPECT_FALSE(read("time_s,x_m,fsr_n\n0.1,1,N/A\n0.2,-2,3\n").table);
  EXPECT_FALSE(read("time_s,x_m,fsr_n\n0.1,1,+inf\n0.2,-2,3\n").table);
}

TEST(ReadNumbers, LeavesAnAbsentOptionalColumnMissing) {
  const Read result = read("time_s,x_m\n0.1,1.5\n0.2,-2\n");
  ASSERT_TRUE(result.table);
  EXPECT_EQ(result.table->present, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_TRUE(std::isnan(result.table->at(1, 1)));
}

TEST(ReadNumbers, NamesAllProblemsAtOnceAndGroupsTheRepeatedOnes) {
  const Read result = read(
      "time_s,x_m,fsr_n\n0.1,abc,1\nsoon,1,inf\n0.3,1\n0.4,nan,1\n0.5,1e999,2\n0.6,1,2,3\n0.7,1,"
      "2\n");
  EXPECT_FALSE(result.table);
  EXPECT_EQ(
      result.messages,
      (Messages{
          "a.csv:2: error: column 'x_m': found 'abc', expected a finite number; --repair drops "
          "such rows (and 2 more)",
          "a.csv:3: error: column 'time_s': found 'soon', expected a time in seconds; --repair "
          "drops such rows",
          "a.csv:3: error: column 'fsr_n': found 'inf', expected a finite number (a missing cell "
          "is empty, NA or nan); --repair drops such rows",
          "a.csv:4: error: found '2 fields', expected 3 fields; --repair drops such rows (and "
          "1 more)"}));
}

TEST(ReadNumbers, RepairDropsBadRowsAndCountsThem) {
  const Read result = read("time_s,x_m\n0.1,1.5\n0.15,abc\n0.17\n0.2,-2\n0.3,\n", {}, true);
  expect_two_rows(result);
  EXPECT_EQ(
      result.messages,
      (Messages{"a.csv:3: warning: column 'x_m': found 'abc', expected a finite number; the "
                "row is dropped (and 1 more)",
                "a.csv:4: warning: found '1 fields', expected 2 fields; the row is dropped"}));
}

TEST(ReadNumbers, WarnsOfALastLineCutShortAndDoesNotUseIt) {
  const Messages warning{
      "a.csv:4: warning: found 'a line cut short', expected a whole last line with its line end; "
      "the row is not used"};
  for (const char* tail : {"0.3", "0.3,", "0.3,-", "0.3,\"1"}) {
    const Read result = read(std::string("time_s,x_m\n0.1,1.5\n0.2,-2\n") + tail);
    expect_two_rows(result);
    EXPECT_EQ(result.messages, warning) << tail;
  }
}

TEST(ReadNumbers, UsesAWholeLastRowWithoutLineEndAndSaysSo) {
  const Read result = read("time_s,x_m\n0.1,1.5\n0.2,-2");
  expect_two_rows(result);
  EXPECT_EQ(
      result.messages,
      (Messages{"a.csv: warning: found 'no line end after the last row', expected one; the row "
                "looks whole and is used"}));
}

TEST(ReadNumbers, RejectsAMissingColumnAndNamesTheNearest) {
  EXPECT_EQ(
      read("time_s,X_m\n0.1,1.5\n").messages,
      (Messages{"a.csv:1: error: column 'x_m': found 'X_m', expected a column of this name in "
                "the header; rename a foreign one under 'columns' in bundle.json"}));
}

TEST(ReadNumbers, RejectsNamesThatAreEqualWhenCaseIsFolded) {
  CsvOptions of_a_bundle;
  of_a_bundle.fold_names = true;
  of_a_bundle.file = "a.csv";
  EXPECT_EQ(
      read("time_s,x_m,T,t\n0.1,1.5,1,2\n", of_a_bundle).messages,
      (Messages{"a.csv:1: error: column 't': found 'T', expected column names that differ when "
                "case is folded"}));
  EXPECT_TRUE(read("time_s,x_m,T,t\n0.1,1.5,1,2\n").table);
}

TEST(ReadNumbers, RejectsAFileWithoutRowsOrWithoutAnything) {
  EXPECT_EQ(read("time_s,x_m\n").messages,
            (Messages{"a.csv: error: found 'no rows', expected at least one row"}));
  EXPECT_EQ(read("").messages, (Messages{"a.csv: error: expected a header line and rows"}));
  EXPECT_EQ(read("# only a comment\n").messages,
            (Messages{"a.csv: error: expected a header line and rows"}));
}

TEST(ReadNumbers, RejectsAQuoteThatIsNeverClosed) {
  EXPECT_EQ(read("time_s,x_m\n0.1,\"1.5\n0.2,-2\n").messages,
            (Messages{"a.csv:2: error: found 'a quote that is never closed', expected a closing "
                      "quote",
                      "a.csv:2: error: column 'x_m': found '1.5\\n0.2,-2\\n', expected a finite "
                      "number"}));
}

/// Writes random tables in random dialects and reads them back.
TEST(ReadNumbers, ReadsBackWhatWasWrittenInAnyDialect) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(round);
    const char separator = kCsvSeparators[random() % kCsvSeparators.size()];
    const std::string line_end = random() % 2 == 0 ? "\n" : "\r\n";
    const std::size_t rows = 1 + random() % 20;
    std::vector<double> x;
    std::string text = random() % 2 == 0 ? "\xEF\xBB\xBF" : "";
    text += std::string("noise") + separator + "time_s" + separator + "x_m" + line_end;
    for (std::size_t i = 0; i < rows; ++i) {
      x.push_back(std::ldexp(static_cast<double>(random()), -static_cast<int>(random() % 70)));
      text += random() % 5 == 0 ? "# comment" + line_end : "";
      text += random() % 3 == 0 ? "\"a" + std::string(1, separator) + " \"\"\n\"" : "text";
      text += separator;
      append_seconds(text, static_cast<std::int64_t>(i) * 12'345'678);
      text += separator;
      const bool quoted = random() % 4 == 0;
      text += quoted ? "\"" : "";
      append_number(text, x.back());
      text += quoted ? "\"" : "";
      text += line_end;
    }
    const Read result = read(text);
    ASSERT_TRUE(result.table) << text << ::testing::PrintToString(result.messages);
    ASSERT_EQ(result.table->rows(), rows) << text;
    for (std::size_t i = 0; i < rows; ++i) {
      ASSERT_EQ(result.table->at(i, 0), x[i]);
      ASSERT_EQ(result.table->time_ns[i], static_cast<std::int64_t>(i) * 12'345'678);
    }
  }
}

TEST(ReadTextTable, KeepsEveryCellAsText) {
  DiagnosticGroups problems;
  const auto table =
      read_text_table(Bytes::copy_of("id,note\n1,\"a, \"\"b\"\"\nc\"\n2,\n"), {}, {"id"}, problems);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->columns, (std::vector<std::string>{"id", "note"}));
  EXPECT_EQ(table->at(0, 1), "a, \"b\"\nc");
  EXPECT_EQ(table->at(1, 1), "");
  EXPECT_EQ(table->lines, (std::vector<std::size_t>{2, 4}));
}

TEST(ReadTextTable, SaysWhenAFileCannotBeRead) {
  const TextTableResult result = read_text_table("/no/such.csv");
  EXPECT_FALSE(result.table);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(to_string(result.diagnostics[0]),
            "/no/such.csv: error: found 'No such file or directory', expected a readable file");
}

std::string gzip(const std::string& text) {
  std::string packed(compressBound(text.size()) + 64, '\0');
  z_stream z{};
  deflateInit2(&z, 6, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
  std::string input = text;
  z.next_in = reinterpret_cast<Bytef*>(input.data());
  z.avail_in = static_cast<uInt>(input.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(packed.size());
  deflate(&z, Z_FINISH);
  packed.resize(packed.size() - z.avail_out);
  deflateEnd(&z);
  return packed;
}

std::string zstd(const std::string& text) {
  std::string packed(ZSTD_compressBound(text.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 3));
  return packed;
}

TEST(Decompress, ReadsSeveralMembersAndFrames) {
  const std::string long_text(1'000'000, 'x');
  for (const auto& [packed, compression] :
       {std::pair{gzip("one\n") + gzip(long_text), Compression::gzip},
        std::pair{zstd("one\n") + zstd(long_text), Compression::zstd}}) {
    const BytesResult result = decompress(Bytes::copy_of(packed), compression);
    ASSERT_TRUE(result.bytes) << result.problem;
    EXPECT_EQ(result.bytes->view(), "one\n" + long_text);
  }
}

TEST(Decompress, SaysWhenTheDataAreCutOrDamaged) {
  std::mt19937_64 random(4);
  std::string text(5000, '\0');
  for (char& c : text) {
    c = static_cast<char>(random());
  }
  for (const auto& [whole, compression] :
       {std::pair{gzip(text), Compression::gzip}, std::pair{zstd(text), Compression::zstd}}) {
    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, whole.size() - 3}) {
      const BytesResult result = decompress(Bytes::copy_of(whole.substr(0, length)), compression);
      EXPECT_FALSE(result.bytes) << length;
      EXPECT_NE(result.problem.find("cut short"), std::string::npos) << result.problem;
    }
    std::string damaged = whole;
    damaged[0] = 'X';
    EXPECT_FALSE(decompress(Bytes::copy_of(damaged), compression).bytes);
  }
}

}  // namespace
}  // namespace tcert::table
