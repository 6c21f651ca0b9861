#pragma once
/// \file
/// A bundle of one trial "t" on disk, of which a test writes the files.

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/trial_reader.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::test_support {

class TrialFolder : public ::testing::Test {
 protected:
  TrialFolder() {
    bundle_.path = folder_.path();
    trial_.trial_id = "t";
  }

  void write(const std::string& name, std::string_view text) {
    folder_.write("logs/t/" + name, text);
  }
  void remove(const std::string& name) {
    std::filesystem::remove(folder_.path() / "logs/t" / name);
  }

  /// Messages of the trial; `log_` is what was read.
  std::vector<std::string> read(bool repair = false) {
    TrialResult result = read_trial(bundle_, trial_, {repair});
    log_ = std::move(result.log);
    EXPECT_EQ(log_.has_value(), !table::has_error(result.diagnostics));
    std::vector<std::string> out;
    for (const table::Diagnostic& diagnostic : result.diagnostics) {
      out.push_back(table::to_string(diagnostic));
    }
    return out;
  }

  TemporaryFolder folder_;
  Bundle bundle_;
  TrialRow trial_;
  std::optional<TrialLog> log_;
};

}  // namespace tcert::test_support
