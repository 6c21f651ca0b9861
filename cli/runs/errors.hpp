#pragma once
/// \file
/// Exit codes, and the errors that end a command with one of them.

#include <stdexcept>

namespace tcert::cli {

enum ExitCode : int {
  exit_done = 0,
  exit_differences = 1,  ///< A check found something.
  exit_usage = 2,
  exit_rejected = 3,  ///< Done, but some trials (or lines) were rejected.
  // `explore` ended, but not at its goal:
  exit_not_reachable = 4,  ///< The threshold forbids it, or with it obstacles and gaps.
  exit_only_rules = 5,     ///< The Lipschitz constant, or the rule set, alone forbids it.
  exit_at_edge = 6,        ///< The goal is certified, but less deep than the published rules want.
  exit_step_limit = 7,
  exit_stranded = 8,  ///< Nothing is safe, or not where the robot stands.
  exit_bad_data = 65,
  exit_no_input = 66,
  exit_internal = 70,
  exit_system = 71,  ///< Memory, descriptors or another thing that the system has too little of.
  exit_cannot_write = 73,
};

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What was asked for is not in the data: a column, a level, times.
class UnfitData : public UsageError {
 public:
  using UsageError::UsageError;
};

class BadData : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class NoInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whoever read our output has had enough: not an error.
class BrokenPipe : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tcert::cli
