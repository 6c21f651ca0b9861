#include "datasets/import/message_type.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcert::recording {
namespace {

const std::string kRule = "\n" + std::string(80, '=') + "\n";

/// "path kind" a line.
std::string flattened(const std::optional<MessageType>& type) {
  std::string out;
  for (const FieldName& name : type ? field_names(*type) : std::vector<FieldName>{}) {
    out += name.path + " " + name.kind + "\n";
  }
  return out;
}

std::string fields_of(const std::string& definition, bool ros1 = false) {
  std::string problem;
  const std::string out = flattened(message_type("pkg/msg/Root", definition, problem, ros1));
  EXPECT_EQ(problem, "");
  return out;
}

std::string problem_of(const std::string& definition) {
  std::string problem;
  EXPECT_FALSE(message_type("pkg/msg/Root", definition, problem).has_value());
  EXPECT_NE(problem, "");
  return problem;
}

TEST(MessageType, HasTheFieldsOfItsDefinitionWithoutConstantsAndDefaults) {
  EXPECT_EQ(
      fields_of("# float64 no\n\n  int32 A=1\nint32 B = 2  # two\nstring C=\"#\"\n"
                "float64 x  # the x\nint8 y -3\nstring s \"a = b\"\nuint8[<=3] z [1, 2]\r\n"
                "string<=5[] t\nfloat32[36] c\nwstring w\nbyte b\nchar d\n"),
      "x float64\ny int8\ns string\nz[] uint8[<=3]\nt[] string[]\nc[] float32[36]\nw wstring\n"
      "b uint8\nd uint8\n");
}

TEST(MessageType, FindsNestedTypesByFullAndShortNames) {
  EXPECT_EQ(fields_of("Part[] parts\nother/Part q\nHeader header" + kRule +
                      "MSG: pkg/Part\nint8 a" + kRule + "MSG: other/msg/Part\nint16 b" + kRule +
                      "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id"),
            "parts[].a int8\nq.b int16\nheader.stamp.sec int32\nheader.stamp.nanosec uint32\n"
            "header.frame_id string\n");
}

TEST(MessageType, OfRos1HasTimesAndSignedBytes) {
  EXPECT_EQ(fields_of("Header header\ntime t\nduration d\nbyte b\nchar c" + kRule +
                          "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id",
                      true),
            "header.seq uint32\nheader.stamp.sec uint32\nheader.stamp.nanosec uint32\n"
            "header.frame_id string\nt.sec uint32\nt.nanosec uint32\nd.sec int32\nd.nanosec int32\n"
            "b int8\nc uint8\n");
}

TEST(MessageType, IsBuiltInUnderBothNames) {
  std::string problem;
  const std::string odometry = flattened(message_type("nav_msgs/Odometry", "", problem));
  EXPECT_EQ(odometry, flattened(message_type("nav_msgs/msg/Odometry", "", problem)));
  EXPECT_NE(odometry.find("pose.covariance[] float64[36]\n"), std::string::npos);
  EXPECT_NE(odometry.find("twist.twist.angular.z float64\n"), std::string::npos);
  EXPECT_EQ(canonical_type("nav_msgs/Odometry"), "nav_msgs/msg/Odometry");
  EXPECT_EQ(canonical_type("a/srv/B"), "a/srv/B");
  EXPECT_EQ(canonical_type("foxglove.Log"), "foxglove.Log");
  EXPECT_FALSE(message_type("a/msg/Unknown", "", problem).has_value());
  EXPECT_NE(problem.find("none is built in"), std::string::npos);
}

TEST(MessageType, TheTextOfTheFileGoesBeforeTheBuiltInOne) {
  std::string problem;
  EXPECT_EQ(flattened(message_type("std_msgs/msg/Float64", "float64 data\nint8 more", problem)),
            "data float64\nmore int8\n");
}

TEST(MessageType, IsRefusedWithAReason) {
  EXPECT_NE(problem_of("Root again").find("not in the file"), std::string::npos);
  EXPECT_NE(problem_of("A a" + kRule + "MSG: pkg/A\nB[] b" + kRule + "MSG: pkg/B\nA[] a")
                .find("contains itself"),
            std::string::npos);
  EXPECT_NE(
      problem_of("pkg/Root[] r" + kRule + "MSG: pkg/Root\npkg/Root[] r").find("contains itself"),
      std::string::npos);
  EXPECT_NE(problem_of("Gone g").find("'Gone'"), std::string::npos);
  EXPECT_NE(problem_of("int8 a\n---\nint8 b").find("a service or an action"), std::string::npos);
  EXPECT_NE(problem_of("float64").find("no field"), std::string::npos);
  EXPECT_NE(problem_of("float64[0] x").find("no field"), std::string::npos);
  EXPECT_NE(problem_of("float64[x] x").find("no field"), std::string::npos);
  EXPECT_NE(problem_of("float64<=3 x").find("no field"), std::string::npos);
  EXPECT_NE(problem_of("float64 a-b").find("no field"), std::string::npos);
  EXPECT_NE(problem_of("float64 x" + kRule + "IDL: pkg/A\n").find("IDL"), std::string::npos);
  EXPECT_NE(problem_of(std::string((1U << 20U) + 1, '#')).find("longer than 1 MiB"),
            std::string::npos);
}

TEST(MessageType, IsBoundedInDepthAndWidth) {
  std::string deep = "T0 t";
  std::string wide = "T0 a\nT0 b";
  for (int i = 0; i < 40; ++i) {
    const std::string next = "T" + std::to_string(i + 1);
    deep += kRule + "MSG: pkg/T" + std::to_string(i) + "\n" + next + " t";
    if (i < 25) {
      wide += kRule + "MSG: pkg/T" + std::to_string(i) + "\n" + next + " a\n" + next + " b";
    }
  }
  EXPECT_NE(problem_of(deep + kRule + "MSG: pkg/T40\nint8 x").find("32 types deep"),
            std::string::npos);
  EXPECT_NE(problem_of(wide + kRule + "MSG: pkg/T25\n").find("8192 fields"), std::string::npos)
      << "empty types count too: to walk them takes as long";
}

}  // namespace
}  // namespace tcert::recording
