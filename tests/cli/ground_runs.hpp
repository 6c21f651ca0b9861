#pragma once
/// \file
/// `tcert explore` of a small random terrain: terrain.csv, 90 x 70 cells.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/workdir.hpp"

namespace tcert::test_support {

class GroundRuns : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::vector<std::string> words{"simulate",
                                         "terrain",
                                         "--output",
                                         "terrain.csv",
                                         "--rows",
                                         "90",
                                         "--columns",
                                         "70",
                                         "--length-scale",
                                         "20",
                                         "--seed",
                                         "4"};
    const ProcessResult made = work.run(words);
    ASSERT_EQ(0, made.exit_code) << to_string(made);
  }

  /// What `explore` and `live terrain` are told of it: most of it is safe.
  static std::vector<std::string> about_ground(std::vector<std::string> more) {
    more.insert(more.end(), {"--threshold", "940", "--kernel-length-scale", "20"});
    return more;
  }

  ProcessResult explore(std::vector<std::string> more) {
    more.insert(more.begin(), {"explore", "terrain.csv"});
    return work.run(about_ground(std::move(more)));
  }

  ProcessResult live(std::vector<std::string> more, const std::string& lines) {
    more.insert(more.begin(), {"live", "terrain", "--rows", "90", "--columns", "70"});
    return work.run(about_ground(std::move(more)), lines);
  }

  Workdir work{TCERT_BINARY};
};

}  // namespace tcert::test_support
