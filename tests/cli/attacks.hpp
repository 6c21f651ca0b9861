#pragma once
/// \file
/// What a stranger may hand to the program, and a look at all that it must leave alone.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/shell.hpp"

namespace tcert {

/// Ids as a stranger would write them into a table.
[[nodiscard]] std::vector<std::string> hostile_ids();

/// As a cell of CSV.
[[nodiscard]] std::string csv_quoted(const std::string& text);

/// A corpus and its certificates in the folder `run`, and files of the user round it: in
/// `canary`, in `run/canary`, and behind the link `run/link`.
class Attacks : public ::testing::Test {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite() { shell.reset(); }

  /// Runs a line in the folder `run` and looks at all that lies outside of run/out.
  static test_support::ProcessResult attack(const std::string& line);

  /// A copy of the tree whose first trial is called `id`, with a manifest that fits: run/foreign.
  static void foreign_tree(const std::string& id);

  static std::unique_ptr<test_support::Shell> shell;
};

}  // namespace tcert
