#include "analysis/study/trials/parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tcert::study {
namespace {

std::string message_of(std::string_view key, std::string_view value) {
  ParameterSet set;
  try {
    set_parameter(set, key, value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterTable, ReadsBackWhatItWrites) {
  ParameterSet set;
  for (const ParameterInfo& parameter : parameter_table()) {
    SCOPED_TRACE(parameter.key);
    const std::string before = parameter.get(set);
    EXPECT_TRUE(parameter.set(set, before));
    EXPECT_EQ(parameter.get(set), before);
  }
}

TEST(ParameterTable, HasEachKeyOnceWithASentence) {
  std::set<std::string_view> keys;
  for (const ParameterInfo& parameter : parameter_table()) {
    SCOPED_TRACE(parameter.key);
    EXPECT_TRUE(keys.insert(parameter.key).second);
    EXPECT_GT(parameter.doc.size(), 20U);
    EXPECT_EQ(parameter.doc.back(), '.');
    EXPECT_FALSE(parameter.accepts.empty());
  }
}

TEST(ParameterTable, SetsItsOwnMemberOnly) {
  for (const ParameterInfo& parameter : parameter_table()) {
    SCOPED_TRACE(parameter.key);
    ParameterSet changed;
    const ParameterSet defaults;
    const bool one_of_many = parameter.accepts.find("number") == std::string::npos;
    std::vector<std::string> values{
        "5", "0.0625", "77", "0.025", "0.5"};  // one of them is within the bounds, and another
    if (one_of_many) {
      std::istringstream words(parameter.accepts);  // "path, contact or none"
      values.clear();
      for (std::string word; words >> word;) {
        values.push_back(word.back() == ',' ? word.substr(0, word.size() - 1) : word);
      }
    }
    const auto usable = std::ranges::find_if(values, [&](const std::string& value) {
      ParameterSet tried;
      return parameter.set(tried, value) && parameter.get(tried) != parameter.get(defaults);
    });
    ASSERT_NE(usable, values.end());
    const std::string value = *usable;
    ASSERT_TRUE(parameter.set(changed, value)) << value;
    for (const ParameterInfo& other : parameter_table()) {
      if (other.key == parameter.key) {
        EXPECT_EQ(other.get(changed), value);
      } else {
        EXPECT_EQ(other.get(changed), other.get(defaults)) << other.key;
      }
    }
  }
}

TEST(SetParameter, SuggestsTheNearestKey) {
  EXPECT_EQ(message_of("edge_lenght_m", "1"),
            "unknown parameter 'edge_lenght_m'; did you mean 'edge_length_m'?");
  EXPECT_EQ(message_of("zzzzzzzz", "1"), "unknown parameter 'zzzzzzzz'");
}

TEST(SetParameter, SaysWhatIsAccepted) {
  EXPECT_EQ(message_of("edge_length_m", "-1"),
            "edge_length_m: found '-1', expected a number from 0.0001 to 100000");
  EXPECT_EQ(message_of("memory_gain", "1.5"),
            "memory_gain: found '1.5', expected a number from 0 to 1");
  EXPECT_EQ(message_of("curvature", "paht"),
            "curvature: found 'paht', expected path, contact, contact_literal or none");
  EXPECT_EQ(message_of("max_nodes", "64.5"),
            "max_nodes: found '64.5', expected a whole number from 2 to 4194304");
  EXPECT_NE(message_of("edge_length_m", "nan"), "");
  EXPECT_NE(message_of("edge_length_m", "inf"), "");
  EXPECT_NE(message_of("edge_length_m", "1 "), "");
  EXPECT_NE(message_of("max_nodes", "-1"), "");
}

TEST(SetParameter, LeavesTheSetAloneOnAnError) {
  ParameterSet set;
  EXPECT_THROW(set_parameter(set, "edge_length_m", "x"), std::invalid_argument);
  EXPECT_EQ(set.certificate.edge_length_m, CertificateParameters{}.edge_length_m);
}

TEST(Validate, AcceptsTheDefaultsAndRefusesAnEvenMedian) {
  ParameterSet set;
  EXPECT_NO_THROW(validate(set));
  set_parameter(set, "median_samples", "4");
  EXPECT_THROW(validate(set), std::invalid_argument);
}

TEST(WithOverrides, ReplacesOnlyWhatIsSet) {
  Robot robot;
  robot.body_width_m = 0.6;
  robot.min_turn_radius_m = 0.2;
  ParameterSet set;
  set_parameter(set, "body_width_m", "0.5");
  const Robot other = with_overrides(robot, set.robot);
  EXPECT_EQ(other.body_width_m, 0.5);
  EXPECT_EQ(other.min_turn_radius_m, 0.2);
  set_parameter(set, "body_width_m", "bundle");
  EXPECT_EQ(with_overrides(robot, set.robot).body_width_m, 0.6);
}

}  // namespace
}  // namespace tcert::study
