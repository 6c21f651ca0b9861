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
