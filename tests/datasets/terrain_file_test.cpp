#include "datasets/terrain_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "datasets/terrain/measurement_line.hpp"
#include "datasets/terrain/raster_text.hpp"
#include "support/expect_part.hpp"

namespace tcert {
namespace {

using test_support::expect_part;

TerrainFileResult read(std::string_view text, TerrainHeader header = TerrainHeader::detect) {
  return read_terrain(table::Bytes::copy_of(text), {"t.csv", header});
}

std::string problems(const TerrainFileResult& result) {
  std::string text;
  for (const table::Diagnostic& diagnostic : result.diagnostics) {
    text += table::to_string(diagnostic) + '\n';
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
  // Rows that end early, under what would be a header.
  expect("1,2,3,4,5\n9,7,9,7,9\n1\n2\n", "t.csv:3: error: found '1 cells'");
  expect("n1,2,3,4\n1,2,3,4\n5\n6\n", "t.csv:3: error: found '1 cells'");
  expect("1,2\n3,x\n", "t.csv:2: error: column '2': found 'x'");
  // Many bad columns are three by number, and the others together.
  const auto many = read("1,2,3,4,5,6\na,b,c,d,e,f\na,b,c,d,e,f\n");
  EXPECT_EQ(4U, many.diagnostics.size()) << problems(many);
  EXPECT_EQ(6U, many.diagnostics.back().count);
  expect("1,2,3\n", "found '1 x 3', expected at least two rows");
  expect("1\n2\n", "found '2 x 1', expected at least two rows");
  expect("", "found '0 x 0'");
  expect("nan,nan\nnan,nan\n", "a cell with a value, but all are gaps");
  std::string wide;
  for (int i = 0; i < 8193; ++i) {
    wide += "1 ";
  }
  expect(wide + '\n' + wide + '\n', "at most 8192 rows and columns");
  EXPECT_NE(std::string::npos,
            problems(read_terrain(std::filesystem::path("/no/such.csv"))).find("readable file"));
}

std::string notes(const TerrainFileResult& result) {
  std::string text = problems(result);
  for (const std::string& note : result.notes) {
    text += note + '\n';
  }
  return text;
}

std::size_t gaps(const TerrainFileResult& result) {
  const auto& values = result.terrain->values;
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }));
}

TEST(TerrainFile, TakesWhatIsNoNumberForAGap) {
  for (const char* text : {"1,2\nnan,4\n5,6\n",
                           "1,2\n,4\n5,6\n",
                           "1;2\nNA;4\n5;6\n",
                           "1,2\n-inf,4\n5,6\n",
                           "1,2\n1e31,4\n5,6\n",
                           "1,2\n-3.4028234663852886e+38,4\n5,6\n"}) {
    const auto result = read(text);
    ASSERT_TRUE(result.terrain) << problems(result);
    EXPECT_EQ(1U, gaps(result)) << text;
    EXPECT_TRUE(std::isnan(result.terrain->values[2])) << text;
    expect_part(notes(result), "1 of 6 cells are gaps");
  }
  const auto trailing = read("1,2,3,\n4,5,6,\n");
  ASSERT_TRUE(trailing.terrain) << problems(trailing);
  EXPECT_EQ(3, trailing.terrain->columns);
  EXPECT_EQ(0U, gaps(trailing));
}

TEST(TerrainFile, RecognisesNodataFarOutsideTheOtherValues) {
  const auto with = [](const std::string& nodata, NodataRule rule = {}) {
    const std::string text = "1200,1210,1190\n1205," + nodata + ",1195\n1201,1202," + nodata + "\n";
    return read_terrain(table::Bytes::copy_of(text), {"t.csv", TerrainHeader::detect, {}, rule});
  };
  for (const char* nodata : {"-9999",
                             "-32768",
                             "-9999.0",
                             "3.4028235e38",
                             "-3.4e38",
                             "65535",
                             "32767",
                             "-99999",
                             "1e31"}) {
    const auto result = with(nodata);
    ASSERT_TRUE(result.terrain) << nodata;
    EXPECT_EQ(2U, gaps(result)) << nodata << notes(result);
    expect_part(notes(result), "2 of 9 cells are gaps (2 of ");
  }
  // A value like others is none, whatever it is elsewhere.
  EXPECT_EQ(0U, gaps(read("-9999,-9998\n-9980,-9999\n-9985,-9991\n")));
  // A depth that is no sentinel is asked about, not guessed.
  const auto odd = with("-500");
  EXPECT_EQ(0U, gaps(odd));
  expect_part(notes(odd), "warning: 2 cells hold -500");
  EXPECT_EQ(2U, gaps(with("-500", {true, -500.0})));
  EXPECT_EQ(0U, gaps(with("-9999", {true, -500.0})));
  EXPECT_EQ(0U, gaps(with("-9999", {false, {}})));
  EXPECT_FALSE(with("1e31", {false, {}}).terrain);
  // A sentinel that is not far enough outside is asked about, even one cell of it.
  const auto near = read("8000,9999,7000\n3000,1000,2000\n4000,0,500\n");
  EXPECT_EQ(0U, gaps(near));
  expect_part(notes(near), "warning: 1 cell holds 9999");
  // One at each end: the higher stands in the way of the lower until it is gone.
  const auto both = read("1200,32767,1190\n1205,-9999,1195\n1201,1202,1203\n");
  EXPECT_EQ(2U, gaps(both)) << notes(both);
  // Two plateaus are two plateaus.
  EXPECT_EQ(0U, gaps(read("50,50,50\n-50,-50,-50\n50,50,50\n")));
}

TEST(TerrainFile, KnowsALineThatNumbersTheColumns) {
  const std::string rows = "1200,1210,1190,1180\n1205,1201,1195,1199\n1207,1209,1200,1190\n";
  for (const char* header :
       {"0,1,2,3\n", "1,2,3,4\n", "500000,500000.5,500001,500001.5\n", "# a,b\n0,1,2,3\n"}) {
    const auto result = read(header + rows);
    ASSERT_TRUE(result.terrain) << problems(result);
    EXPECT_EQ(3, result.terrain->rows) << header;
    EXPECT_EQ(1200.0, result.terrain->values.front()) << header;
    expect_part(notes(result), "--header no reads it as data");
  }
  EXPECT_EQ(4, read("0,1,2,3\n" + rows, TerrainHeader::no).terrain->rows);
  // A plane is evenly spaced in every line.
  EXPECT_EQ(3, read("0,1,2,3\n1,2,3,4\n2,3,4,5\n").terrain->rows);
  EXPECT_EQ(3, read("1,2,3,4\n2,4,6,8\n3,6,9,12\n").terrain->rows);
  EXPECT_EQ(3, read("50,50,50,50\n0,1,2,3\n50,50,50,50\n").terrain->rows);
  // Evenly spaced by chance: data, with a word.
  const auto chance = read("1200,1201,1202,1203\n" + rows);
  EXPECT_EQ(4, chance.terrain->rows);
  expect_part(notes(chance), "give --header yes");
  // As data frames are written: the rows are numbered too.
  const auto frame = read(",0,1,2\n0,1200,1210,1190\n1,1205,1201,1195\n2,1207,1209,1200\n");
  ASSERT_TRUE(frame.terrain) << problems(frame);
  EXPECT_EQ(3, frame.terrain->rows);
  EXPECT_EQ(3, frame.terrain->columns);
  EXPECT_EQ(1200.0, frame.terrain->values.front());
  // As R writes them, in quotes.
  const auto quoted = read("\"\",\"V1\",\"V2\"\n\"1\",1200,1210\n\"2\",1205,1201\n");
  ASSERT_TRUE(quoted.terrain) << problems(quoted);
  EXPECT_EQ((std::vector<double>{1200, 1210, 1205, 1201}), quoted.terrain->values);
}

/// z = 100 x + y on 4 x 5 nodes half a unit apart, far from the origin.
std::string points(char separator, bool backwards, const std::string& header, int left_out = -1) {
  std::vector<std::string> lines;
  for (int i = 0; i < 20; ++i) {
    const int x = i / 5;
    const int y = i % 5;
    if (i == left_out) {
      continue;
    }
    std::string line = std::to_string(500000 + x / 2) + (x % 2 == 0 ? ".0" : ".5");
    line += separator + std::to_string(4000000 + y / 2) + (y % 2 == 0 ? ".0" : ".5");
    lines.push_back(line + separator + std::to_string(100 * x + y) + '\n');
  }
  if (backwards) {
    std::reverse(lines.begin(), lines.end());
    std::swap(lines[3], lines[11]);
  }
  std::string text = header;
  for (const std::string& line : lines) {
    text += line;
  }
  return text;
}

TEST(TerrainFile, ReadsPointsOnALattice) {
  for (const bool backwards : {false, true}) {
    for (const auto& [separator, header] : {std::pair{',', "x,y,z\n"},
                                            {',', ""},
                                            {' ', ""},
                                            {';', "easting;northing;h\n"},
                                            {'\t', "# points\n"}}) {
      const auto result = read(points(separator, backwards, header));
      ASSERT_TRUE(result.terrain) << problems(result);
      ASSERT_EQ(4, result.terrain->rows);
      ASSERT_EQ(5, result.terrain->columns);
      for (int x = 0; x < 4; ++x) {
        for (int y = 0; y < 5; ++y) {
          EXPECT_EQ(100.0 * x + y, result.terrain->values[static_cast<std::size_t>(5 * x + y)]);
        }
      }
      expect_part(notes(result), "cell x is (x - 500000) / 0.5, cell y is (y - 4000000) / 0.5");
    }
  }
  const auto twice = read(points(',', true, "") + "500000.0,4000000.0,0\n");
  ASSERT_TRUE(twice.terrain) << "the same said twice: " << problems(twice);
  EXPECT_EQ(20U, twice.terrain->values.size());
  const auto hole = read(points(',', true, "", 7));
  ASSERT_TRUE(hole.terrain) << problems(hole);
  EXPECT_EQ(20U, hole.terrain->values.size());
  EXPECT_TRUE(std::isnan(hole.terrain->values[7]));
  // Rows numbered, as data frames are written; more values than one.
  const auto frame = read(",x,y,z\n0,5,7,1\n1,5,8,2\n2,6,7,3\n3,6,8,4\n");
  ASSERT_TRUE(frame.terrain) << problems(frame);
  EXPECT_EQ((std::vector<double>{1, 2, 3, 4}), frame.terrain->values);
  const auto two = read("5,7,1,9\n5,8,2,9\n6,7,3,9\n6,8,4,9\n7,7,4,9\n7,8,4,9\n");
  EXPECT_FALSE(two.terrain);
  expect_part(problems(two), "keep x, y and one value");
  // Degrees that were rounded: no step is quite the mean one.
  std::string seconds;
  for (int x = 0; x < 1500; ++x) {
    for (int y = 0; y < 3; ++y) {
      char line[64];
      std::snprintf(line, sizeof line, "%.6f,%.6f,%d\n", 11.5 + x / 3600.0, 48.1 + y / 3600.0, x);
      seconds += line;
    }
  }
  const auto degrees = read(seconds);
  ASSERT_TRUE(degrees.terrain) << problems(degrees);
  EXPECT_EQ(1500, degrees.terrain->rows);
  EXPECT_EQ(3, degrees.terrain->columns);
  EXPECT_EQ(0U, gaps(degrees));
  // 0, 1, 2 is the first point here, not a header.
  EXPECT_EQ(3, read("0,1,2\n0,2,5\n1,1,9\n1,2,4\n2,1,7\n2,2,1\n").terrain->rows);
}

TEST(TerrainFile, RefusesPointsThatFormNoLattice) {
  const auto refused = [](const std::string& text) {
    const auto result = read(text);
    EXPECT_FALSE(result.terrain) << text;
    expect_part(problems(result), "--terrain-format grid");
  };
  refused(points(',', false, "") + "500000.0,4000000.0,7\n");
  // Scattered ones, too many for a terrain three cells wide.
  std::string scattered;
  for (int i = 0; i < 20; ++i) {
    scattered += std::to_string(37 * i % 101) + ".3," + std::to_string(53 * i % 97) + ".7," +
                 std::to_string(i % 7) + '\n';
  }
  refused(scattered);
  refused(
      "500000.13,4000000.71,1200\n500001.92,4000003.14,1201\n500007.5,4000001.1,1199\n"
      "500003.3,4000009.2,1210\n");
  refused("x,y,z\n1,7,3\n2,9.5,4\n3.7,1,5\n8,8,6\n");
  // A terrain three cells wide stays one.
  const auto strip = read("1200,1210,1190\n1205,1201,1195\n1207,1209,1200\n1203,1206,1201\n");
  ASSERT_TRUE(strip.terrain) << problems(strip);
  EXPECT_EQ(3, strip.terrain->columns);
  expect_part(notes(strip), "read as a terrain three cells wide");
  TerrainFileOptions grid{"t.csv", TerrainHeader::detect, TerrainFormat::grid, {}};
  EXPECT_EQ(20, read_terrain(table::Bytes::copy_of(points(',', false, "")), grid).terrain->rows);
}

TEST(TerrainFile, ReadsEsriGrids) {
  const std::string values = "1 2 3\n4 -1 6\n";
  for (const std::string& header :
       {std::string("ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4000000\ncellsize 0.5\n"
                    "NODATA_value -1\n"),
        std::string("NCOLS         3\r\nNROWS\t2\r\nXLLCENTER 0\r\nYLLCENTER 0\r\n"
                    "NODATA_VALUE -1.0\r\nCELLSIZE 0.5\r\n")}) {
    const auto result = read(header + values);
    ASSERT_TRUE(result.terrain) << problems(result);
    EXPECT_EQ(2, result.terrain->rows);
    EXPECT_EQ(3, result.terrain->columns);
    EXPECT_EQ(1.0, result.terrain->values[0]) << "the northernmost row is x = 0";
    EXPECT_EQ(1U, gaps(result));
    expect_part(notes(result), "x counts its rows from north to south");
    expect_part(notes(result), "a slope of s per unit is L = 0.5 s");
  }
  expect_part(notes(read("ncols 3\nnrows 2\nxllcorner 5\nyllcorner 7\ncellsize 1\n" + values)),
              "its south-west corner lies at 5, 7");
  expect_part(notes(read("ncols 3\nnrows 2\nxllcenter 5\nyllcenter 7\ncellsize 1\n" + values)),
              "the centre of its south-west cell lies at 5, 7");
  // Five lines; values broken anywhere.
  const std::string five = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  EXPECT_EQ(1U, gaps(read(five + "1 2\n3 4 -9999\n6\n")));
  expect_part(problems(read(five + "1 2 3 4 5\n")), "found '5 values', expected nrows x ncols");
  expect_part(problems(read(five + "1 2 3 4 5 6 7\n")), "found '7 values'");
  expect_part(problems(read(five + "1 2 3 4 x 6\n")), "t.csv:6: error: column '5': found 'x'");
  expect_part(problems(read("ncols 3\nnrows 99999999\n1 2 3\n")), "from 2 to 8192");
}

TEST(TerrainFile, NamesDecimalCommasDegreesAndSidesThatAreTooFew) {
  expect_part(problems(read("x;y;z\n1,0;2,0;3,5\n1,0;3,0;3,5\n")),
              "t.csv:2: error: column '1': found '1,0', expected numbers with a decimal point");
  EXPECT_EQ("", problems(read("a, b;c\n1;2\n3;4\n")));
  expect_part(problems(read("ncols 1\nnrows 2\ncellsize 1\n1\n2\n")),
              "found 'ncols 1, nrows 2', expected both in the header");
  const std::string degrees =
      "ncols 2\nnrows 2\nxllcorner 7.5\nyllcorner 46\ncellsize 0.000277\n1 2\n3 4\n";
  expect_part(notes(read(degrees)), "if the map is in degrees");
  for (const char* const cell : {"0.05", "30"}) {
    std::string metres = degrees;
    metres.replace(metres.find("0.000277"), 8, cell);
    EXPECT_EQ(std::string::npos, notes(read(metres)).find("degrees")) << cell;
  }
}

TEST(TerrainFile, NamesBinaryFilesAndTheWayOut) {
  const auto refused = [](std::string_view bytes) {
    const auto result = read(bytes);
    EXPECT_FALSE(result.terrain);
    const std::string text = problems(result);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) {
      return c == '\n' || (c >= ' ' && c < 127);
    })) << text;
    return text;
  };
  using namespace std::string_view_literals;
  expect_part(refused("II*\0\x08\0\0\0\x10\0"sv), "GeoTIFF");
  expect_part(refused("II*\0\x08\0\0\0\x10\0"sv), "gdal_translate -of AAIGrid t.csv out.asc");
  expect_part(refused("\x89PNG\r\n\x1a\n\0\0"sv), "a PNG image");
  expect_part(refused("\x93NUMPY\x01\0v\0{'descr'"sv), "numpy.savetxt");
  expect_part(refused("\x01\x02\x03\x80\xff,\0"sv), "a binary file");
  expect_part(refused("\xff\xfe"
                      "1\0,\0"sv),
              "iconv");
  // Bytes that are no text within what is: escaped.
  expect_part(refused("1,2\n3,\x9b\xff\n"sv), "found '\\x9b\\xff'");
}

TEST(MeasurementLines, NeedFieldsOfJsonByName) {
  MeasurementLines lines;
  const MeasurementReading good = lines.read(R"({"x": 3, "y": 4, "value": 5.5, "plan": false})");
  ASSERT_TRUE(good.measurement) << good.problem;
  EXPECT_EQ(3, good.measurement->x);
  EXPECT_FALSE(good.measurement->plan);
  for (const char* const line : {R"({"y": 3, "value": 4, "plan": true})",
                                 R"({"x": 3, "y": 4, "plan": true})",
                                 R"({"x": 3, "value": 4, "plan": false})",
                                 R"({"x": 3, "y": 4, "value": 5, "plan": 1})",
                                 R"({"x": 3, "y": 4, "value": 5, "z": 1})",
                                 R"([3, 4, 5])",
                                 R"({"x": 3)"}) {
    const MeasurementReading bad = lines.read(line);
    EXPECT_FALSE(bad.measurement) << line;
    EXPECT_FALSE(bad.problem.empty()) << line;
  }
}

TEST(MeasurementLines, FindColumnsByNameIfAHeaderNamesThem) {
  MeasurementLines lines;
  EXPECT_TRUE(lines.read("time,\"plan\",y,x,value,synthetic_seed\r").problem.empty());
  const MeasurementReading row = lines.read("17.5,0,4,3,5.5,12\r");
  ASSERT_TRUE(row.measurement) << row.problem;
  EXPECT_EQ(3, row.measurement->x);
  EXPECT_EQ(4, row.measurement->y);
  EXPECT_EQ(5.5, row.measurement->value);
  EXPECT_FALSE(row.measurement->plan);
  EXPECT_EQ(12U, lines.synthetic_seed());
  EXPECT_FALSE(lines.read("0,4,3,5.5,12").measurement) << "a cell is missing";
  EXPECT_FALSE(lines.read("x,y,value").problem.empty()) << "a header in the midst";
  // Other names, and none, leave the order as it is; the plan is 1 then.
  for (const char* const header : {"X,Y,firmness", "# a robot", ""}) {
    MeasurementLines plain;
    EXPECT_TRUE(plain.read(header).problem.empty());
    const MeasurementReading three = plain.read(" 3, 4 ,5.5");
    ASSERT_TRUE(three.measurement) << three.problem;
    EXPECT_TRUE(three.measurement->plan);
    EXPECT_FALSE(plain.read("3,4,5.5,0,12").measurement) << "five cells without names";
    EXPECT_FALSE(plain.synthetic_seed());
  }
}

TEST(RasterText, NoValueIsRoundedToThatOfGaps) {
  const TerrainGrid layer{1, 3, {-9998.9996, 0.25, std::nan("")}, {}};
  const std::string text = esri_raster(layer, RasterRounding::down);
  expect_part(text, "NODATA_value -99999\n");
  expect_part(text, "-9999.000 0.250 -99999");
}

TEST(TerrainFile, WritesWhatReadsBack) {
  const TerrainGrid grid{2, 2, {1.0 / 3.0, -1e-300, 1365.6, 0.0}, {}};
  EXPECT_EQ(grid.values, read(terrain_text(grid)).terrain->values);
}

}  // namespace
}  // namespace tcert
