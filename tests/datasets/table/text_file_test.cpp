#include <table/text_file.hpp>

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

#include "support/temporary_folder.hpp"

namespace tcert::table {
namespace {

using namespace std::string_view_literals;

std::string text_of(std::string_view bytes) {
  return std::string(as_text(Bytes::copy_of(bytes)).view());
}

TEST(AsText, ReadsUtf16OfBothOrders) {
  EXPECT_EQ(text_of("\xFF\xFEt\0,\0\xB5\0\n\0"sv), "t,\u00b5\n");
  EXPECT_EQ(text_of("\xFE\xFF\0t\0,\0\xB5\0\n"sv), "t,\u00b5\n");
  EXPECT_EQ(text_of("\xFF\xFE\x3D\xD8\x00\xDE\n\0"sv), "\U0001F600\n");
}

TEST(AsText, ReplacesHalfAPair) {
  EXPECT_EQ(text_of("\xFF\xFE\x3D\xD8\n\0"sv), "\uFFFD\n");
  EXPECT_EQ(text_of("\xFF\xFE\x00\xDE\n\0"sv), "\uFFFD\n");
  EXPECT_EQ(text_of("\xFF\xFE"
                    "t\0,"sv),
            "t");
}

TEST(AsText, EndsLinesWhereOnlyCarriageReturnsDo) {
  EXPECT_EQ(text_of("a,b\r1,2\r"), "a,b\n1,2\n");
  EXPECT_EQ(text_of("a,b\r\n1,2\r\n"), "a,b\r\n1,2\r\n");
}

TEST(ReadTextFile, ExpandsByContentWhateverTheName) {
  const test_support::TemporaryFolder folder;
  const auto path = folder.write("plain.csv", "");
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  gzputs(file, "a,b\n1,2\n");
  gzclose(file);
  EXPECT_EQ(read_text_file(path).bytes->view(), "a,b\n1,2\n");
  EXPECT_EQ(read_text_file(folder.write("named.csv.gz", "a,b\n")).bytes->view(), "a,b\n");
}

}  // namespace
}  // namespace tcert::table
