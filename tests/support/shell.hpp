#pragma once
/// \file
/// The program as a shell starts it: with closed descriptors, limits and an environment of its own.

#include <map>
#include <string>

#include "support/workdir.hpp"

namespace tcert::test_support {

/// A work folder whose lines are run by /bin/sh; in them $T is the program.
class Shell {
 public:
  Shell() : work_("/bin/sh") {}

  ProcessResult run(const std::string& line) {
    return work_.run({"-c", "T='" TCERT_BINARY "'; export T; " + line});
  }

  [[nodiscard]] Workdir& work() noexcept { return work_; }

  /// Every entry below the folder `name`, with the bytes of files and the targets of links, but for
  /// what lies below `except`: to see whether anything has changed.
  [[nodiscard]] std::map<std::string, std::string> contents(const std::string& name,
                                                            const std::string& except = {}) const;

 private:
  Workdir work_;
};

}  // namespace tcert::test_support
