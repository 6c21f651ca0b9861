#include "datasets/terrain_file.hpp"

#include <gtest/gtest.h>

namespace tcert {
namespace {

TerrainFileResult read(std::string_view text, TerrainHeader header = TerrainHeader::detect) {
  return read_terrain(Bytes::copy_of(text), {"t.csv", header});
}

std::string problems(const TerrainFileResult& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    text += to_string(diagnostic) + '\n';
  }
  return text;
}

TEST(TerrainFile, ReadsARectangle) {
  for (const char* text : {"1,2,3\n4,5,6e1\n",
                           "1;2;3\r\n4;5;60\r\n",
                           "1\t2\t3\n4\t5\t60",
                           " 1  2 3\n4 5 60 \n\n",
                           "\xEF\xBB\xBF"
                           "1,2,3\n4,5,60\n"}) {
    const auto result = read(text);
    ASSERT_TRUE(result.terrain) << problems(result);
    EXPECT_EQ(2, result.terrain->rows);
    EXPECT_EQ(3, result.terrain->columns);
    EXPECT_EQ((std::vector<double>{1, 2, 3, 4, 5, 60}), result.terrain->values);
  }
}

TEST(TerrainFile, KnowsAHeader) {
  EXPECT_EQ(2, read("a,b\n1,2\n3,4\n").terrain->rows);
  EXPECT_EQ(3, read("9,8\n1,2\n3,4\n").terrain->rows);
  EXPECT_EQ(2, read("9,8\n1,2\n3,4\n", TerrainHeader::yes).terrain->rows);
  EXPECT_NE(std::string::npos,
            problems(read("a,b\n1,2\n3,4\n", TerrainHeader::no)).find("t.csv:1: error"));
}

TEST(TerrainFile, SaysWhatIsWrongAndWhere) {
  const auto expect = [](std::string_view text, const std::string& part) {
    const auto result = read(text);
    EXPECT_FALSE(result.terrain);
    EXPECT_NE(std::string::npos, problems(result).find(part)) << problems(result);
  };
  expect("1,2\n3\n5,6\n", "t.csv:2: error: found '1 cells', expected as many cells");
  expect("1,2\n3,x\n", "t.csv:2: error: column '2': found 'x'");
  expect("1,2\nnan,4\n", "t.csv:2: error: column '1': found 'nan'");
  expect("nan,2\n3,4\n", "t.csv:1: error: column '1': found 'nan'");
  expect("1,2\n3,\n", "t.csv:2: error: column '2'");
  expect("1,2,3\n", "found '1 x 3', expected at least two rows");
  expect("1\n2\n", "found '2 x 1', expected at least two rows");
  expect("", "found '0 x 0'");
  EXPECT_NE(std::string::npos,
            problems(read_terrain(std::filesystem::path("/no/such.csv"))).find("readable file"));
}

TEST(TerrainFile, WritesWhatReadsBack) {
  const TerrainGrid grid{2, 2, {1.0 / 3.0, -1e-300, 1365.6, 0.0}, {}};
  EXPECT_EQ(grid.values, read(terrain_text(grid)).terrain->values);
}

}  // namespace
}  // namespace tcert
