#include "datasets/import/decoder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/cdr_bytes.hpp"

namespace tcert::recording {
namespace {

using test_support::CdrBytes;

constexpr std::uint8_t kBig = 0;
constexpr std::uint8_t kLittle = 1;
constexpr std::uint8_t kSecondBig = 6;
constexpr std::uint8_t kSecondLittle = 7;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

MessageType type_of(const std::string& definition) {
  std::string problem;
  auto type = message_type("pkg/msg/Root", definition, problem);
  EXPECT_TRUE(type.has_value()) << problem;
  return type.value_or(MessageType{});
}

Value decoded(const std::string& definition, const std::string& bytes) {
  Value value;
  std::string problem;
  EXPECT_TRUE(decode(type_of(definition), bytes_of(bytes), value, problem)) << problem;
  return value;
}

std::string refused(const std::string& definition, const std::string& bytes) {
  Value value;
  std::string problem;
  EXPECT_FALSE(decode(type_of(definition), bytes_of(bytes), value, problem));
  EXPECT_NE(problem, "");
  return problem;
}

TEST(Cdr, IsAlignedFromBehindTheHeader) {
  // By hand: header, a at 0, 7 bytes of padding, b at 8, c at 16, 3 of padding, d at 20.
  const std::string bytes{
      "\0\1\0\0"
      "\x05"
      "\0\0\0\0\0\0\0"
      "\0\0\0\0\0\0\xF8\x3F"
      "\x01"
      "\0\0\0"
      "\xFE\xFF\xFF\xFF",
      28};
  const Value value = decoded("uint8 a\nfloat64 b\nbool c\nint32 d", bytes);
  EXPECT_EQ(number_at(value, "a"), 5.0);
  EXPECT_EQ(number_at(value, "b"), 1.5);
  EXPECT_EQ(find(value, "c")->data, Value{true}.data);
  EXPECT_EQ(integer(*find(value, "d")), -2);
}

TEST(Cdr, OfBothByteOrdersAndVersionsSaysTheSame) {
  for (const std::uint8_t kind : {kBig, kLittle, kSecondBig, kSecondLittle}) {
    SCOPED_TRACE(int{kind});
    CdrBytes cdr(kind);
    cdr.put(std::uint8_t{1})
        .put(std::numeric_limits<std::int64_t>::min())
        .put(std::uint16_t{65535});
    cdr.put(3U).put(1.5F).put(-0.25F).put(std::numeric_limits<float>::infinity()).text("a b");
    cdr.put(std::uint8_t{1}).put(std::uint64_t{1} << 63U);
    const Value value = decoded(
        "int8 a\nint64 b\nuint16 c\nfloat32[] d\nstring e\nbool f\nuint64[1] g", cdr.bytes());
    EXPECT_EQ(integer(*find(value, "b")), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(number_at(value, "c"), 65535.0);
    EXPECT_EQ(find(value, "d")->data,
              Value::Data(Doubles{1.5, -0.25, std::numeric_limits<double>::infinity()}));
    EXPECT_EQ(*text(*find(value, "e")), "a b");
    EXPECT_EQ(find(value, "g")->data, Value::Data(Unsigned{std::uint64_t{1} << 63U}));
  }
}

TEST(Cdr, AnEmptySequenceIsNotAlignedForItsElements) {
  CdrBytes cdr;
  cdr.put(0U).put(std::uint8_t{9});
  EXPECT_EQ(number_at(decoded("float64[] a\nuint8 b", cdr.bytes()), "b"), 9.0);
}

TEST(Cdr, AnEmptyStructureTakesAByte) {
  CdrBytes cdr;
  cdr.put(std::uint8_t{0}).put(std::uint8_t{7});
  const std::string definition = "Empty e\nuint8 a\n=====\nMSG: pkg/Empty\n# nothing\nint8 A=1";
  EXPECT_EQ(number_at(decoded(definition, cdr.bytes()), "a"), 7.0);
}

TEST(Cdr, ArraysOfStructuresAreArraysOfObjects) {
  CdrBytes cdr;
  cdr.put(2U).put(1.0).text("x").put(2.0).text("");
  const Value value =
      decoded("Part[] parts\n=====\nMSG: pkg/Part\nfloat64 a\nstring b", cdr.bytes());
  EXPECT_EQ(size(*find(value, "parts")), 2U);
  EXPECT_EQ(number_at(value, "parts[1].a"), 2.0);
  EXPECT_EQ(*text(*find(value, "parts[0].b")), "x");
}

TEST(Cdr, WideTextsOfEitherMiddlewareAreRead) {
  // U+0041 U+20AC U+1F600: as characters of four bytes, and as UTF-16.
  CdrBytes four;
  four.put(3U).put(0x41U).put(0x20ACU).put(0x1F600U).put(std::uint8_t{5});
  CdrBytes two;
  two.put(4U).put(std::uint16_t{0x41}).put(std::uint16_t{0x20AC}).put(std::uint16_t{0xD83D});
  two.put(std::uint16_t{0xDE00}).put(std::uint8_t{5});
  for (const CdrBytes& cdr : {four, two}) {
    const Value value = decoded("wstring w\nuint8 a", cdr.bytes());
    EXPECT_EQ(*text(*find(value, "w")), "A€😀");
    EXPECT_EQ(number_at(value, "a"), 5.0);
  }
}

TEST(Cdr, MemoryThatIsUsedAgainChangesNothing) {
  const MessageType type = type_of("string[] s\nfloat32[] f\nuint8 a");
  Value reused;
  std::string problem;
  for (const std::size_t length : {3U, 0U, 5U, 1U}) {
    CdrBytes cdr;
    cdr.put(static_cast<std::uint32_t>(length));
    for (std::size_t i = 0; i < length; ++i) {
      cdr.text(std::string(i * 9, 'x'));
    }
    cdr.put(static_cast<std::uint32_t>(length));
    for (std::size_t i = 0; i < length; ++i) {
      cdr.put(static_cast<float>(i));
    }
    cdr.put(std::uint8_t{1});
    Value fresh;
    ASSERT_TRUE(decode(type, bytes_of(cdr.bytes()), fresh, problem)) << problem;
    ASSERT_TRUE(decode(type, bytes_of(cdr.bytes()), reused, problem)) << problem;
    EXPECT_EQ(fresh, reused);
  }
}

TEST(Cdr, PaddingOfTheLastWordIsNoFault) {
  for (const std::size_t padding : {0U, 1U, 2U, 3U}) {
    CdrBytes cdr;
    cdr.put(std::uint8_t{4});
    EXPECT_EQ(number_at(decoded("uint8 a", cdr.bytes() + std::string(padding, '\0')), "a"), 4.0);
  }
  CdrBytes cdr;
  cdr.put(std::uint8_t{4}).put(1.0F);
  EXPECT_NE(refused("uint8 a", cdr.bytes()).find("left behind the last field"), std::string::npos)
      << "a float behind the last field is another type";
}

TEST(Cdr, ThatDoesNotFitNamesTheField) {
  CdrBytes cdr;
  cdr.put(1.0).put(2.0F);
  EXPECT_NE(
      refused("Part p\n=====\nMSG: pkg/Part\nfloat64 a\nfloat64 b", cdr.bytes()).find("'p.b'"),
      std::string::npos);
  EXPECT_NE(refused("uint8 a", std::string("\0\1", 2)).find("fewer than the header"),
            std::string::npos);
  EXPECT_NE(refused("uint8 a", std::string("\0\3\0\0a", 5)).find("0x0003"), std::string::npos);
  EXPECT_NE(refused("uint8 a", std::string("\0\x9\0\0a", 5)).find("not plain CDR"),
            std::string::npos);
}

TEST(Cdr, EveryMessageThatIsCutOffIsRefused) {
  CdrBytes cdr;
  cdr.put(2U).text("ab").text("c").put(1.0).put(3U).put(1.0F).put(1.0F).put(1.0F).put(1.0);
  const std::string definition = "string[] s\nfloat64 a\nfloat32[] f\nfloat64 b";
  ASSERT_EQ(number_at(decoded(definition, cdr.bytes()), "b"), 1.0);
  for (std::size_t length = 0; length < cdr.bytes().size(); ++length) {
    refused(definition, cdr.bytes().substr(0, length));
  }
}

TEST(Cdr, LengthsAreBoundedByTheBytesThatAreLeft) {
  CdrBytes cdr;
  cdr.put(0xFFFFFFFFU).put(1.0);
  for (const char* definition : {"float64[] a",
                                 "uint8[] a",
                                 "string[] a",
                                 "string a",
                                 "wstring a",
                                 "float64[4000000000] a",
                                 "E[] e\n=====\nMSG: pkg/E\n",
                                 "E[4000000000] e\n=====\nMSG: pkg/E\nstring s"}) {
    SCOPED_TRACE(definition);
    refused(definition, cdr.bytes());
  }
  CdrBytes bounded;
  bounded.put(4U).put(0U);
  EXPECT_NE(refused("uint8[<=3] a", bounded.bytes()).find("above its bound"), std::string::npos);
}

TEST(Cdr, TreesOfTooManyValuesAreRefused) {
  CdrBytes cdr;
  cdr.put(3'000'000U);
  const std::string bytes = cdr.bytes() + std::string(3'000'000, '\1');
  EXPECT_NE(refused("Part[] a\n=====\nMSG: pkg/Part\nuint8 a", bytes).find("2000000 values"),
            std::string::npos);
  EXPECT_EQ(size(*find(decoded("uint8[] a", bytes), "a")), 3'000'000U) << "packed numbers are none";
}

TEST(Ros1, ElementsWithoutBytesAreBoundedByTheMessage) {
  std::string problem;
  const auto type =
      message_type("a/B", "P[] p\n=====\nMSG: a/P\nE[1000000] e\n=====\nMSG: a/E\n", problem, true);
  ASSERT_TRUE(type) << problem;
  Value value;
  const std::string bytes = std::string("\xFF\0\0\0", 4) + std::string(1000, '\0');
  EXPECT_FALSE(decode_ros1(*type, bytes_of(bytes), value, problem));
  EXPECT_NE(problem.find("values"), std::string::npos);
}

TEST(Ros1, IsNeitherAlignedNorEndedByZeros) {
  std::string problem;
  const auto type =
      message_type("a/B", "uint8 a\nfloat64 b\nstring s\nE e\n=====\nMSG: a/E\n", problem, true);
  ASSERT_TRUE(type) << problem;
  const std::string bytes{
      "\x05"
      "\0\0\0\0\0\0\xF8\x3F"
      "\2\0\0\0ab",
      15};
  Value value;
  ASSERT_TRUE(decode_ros1(*type, bytes_of(bytes), value, problem)) << problem;
  EXPECT_EQ(number_at(value, "b"), 1.5);
  EXPECT_EQ(*text(*find(value, "s")), "ab");
  EXPECT_FALSE(decode_ros1(*type, bytes_of(bytes + "x"), value, problem));
}

TEST(Json, BecomesTheSameTree) {
  const std::string text =
      R"({"x": 1.5, "n": -3, "big": 18446744073709551615, "r": [1, 2], "d": [1, null, 2.5], "m": [1, "a"], "o": [{"y": true}], "z": null, "e": []})";
  Value value;
  std::string problem;
  ASSERT_TRUE(decode_json(bytes_of(text), value, problem)) << problem;
  EXPECT_EQ(number_at(value, "x"), 1.5);
  EXPECT_EQ(integer(*find(value, "n")), -3);
  EXPECT_EQ(find(value, "big")->data, Value::Data(std::numeric_limits<std::uint64_t>::max()));
  EXPECT_EQ(find(value, "r")->data, Value::Data(Signed{1, 2}));
  EXPECT_TRUE(std::isnan(*number_at(value, "d[1]")));
  EXPECT_EQ(number_at(value, "d[2]"), 2.5);
  EXPECT_EQ(size(*find(value, "m")), 2U);
  EXPECT_EQ(number_at(value, "o[0].y"), 1.0);
  EXPECT_TRUE(std::isnan(*number_at(value, "z")));
}

TEST(Json, IsBounded) {
  Value value;
  std::string problem;
  for (const std::string& bad : {std::string("{"),
                                 std::string(),
                                 std::string(100'000, '['),
                                 std::string("[1,]"),
                                 std::string((16U << 20U) + 1, ' ')}) {
    problem.clear();
    EXPECT_FALSE(decode_json(bytes_of(bad), value, problem));
    EXPECT_NE(problem, "");
  }
}

TEST(Decoder, TakesWhatItReadsAndNamesWhatNot) {
  std::string problem;
  Topic topic{"/a", "std_msgs/msg/Float64", "cdr", "", "", 0};
  ASSERT_TRUE(Decoder::of(topic, problem)) << problem;
  topic.encoding = "protobuf";
  EXPECT_FALSE(Decoder::of(topic, problem));
  EXPECT_NE(problem.find("'protobuf'"), std::string::npos);
  topic = {"/a", "a/msg/B", "cdr", "module a {};", "ros2idl", 0};
  EXPECT_FALSE(Decoder::of(topic, problem));
  EXPECT_NE(problem.find("'ros2idl'"), std::string::npos);
  topic = {"/a", "a/msg/Nothing", "cdr", "", "ros2msg", 0};
  problem.clear();
  EXPECT_TRUE(Decoder::of(topic, problem)) << "a type without fields has an empty definition";
  topic = {"/a", "", "json", "", "", 0};
  const auto json = Decoder::of(topic, problem);
  ASSERT_TRUE(json);
  EXPECT_EQ(json->type(), nullptr);
}

}  // namespace
}  // namespace tcert::recording
