#pragma once
// Lines of CARMEN logs, for tests.

#include <cstdio>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::test_support {

using Messages = std::vector<std::string>;

inline Messages messages(const std::vector<table::Diagnostic>& diagnostics) {
  Messages out;
  for (const table::Diagnostic& diagnostic : diagnostics) {
    out.push_back(table::to_string(diagnostic));
  }
  return out;
}

/// Two scans of four beams; corrected poses beside other odometry.
inline constexpr std::string_view kCarmenLog =
    "# written by hand\n"
    "PARAM robot_width 0.5 0 host 0\n"
    "ODOM 9 9 9 0 0 0 0.5 host 0.5\n"
    "FLASER 4 1 2 3 81.83 0.5 0 0 9 9 9 1.5 host 1.6\n"
    "FLASER 4 1 2 3 8 1.5 0.25 0.125 9 9 9 3.25 host 3.3\n"
    "ODOM 9 9 9 0 0 0 4 host 4\n";

/// A scan at (x, 0, 0); the logger's stamp is `second`.
inline std::string flaser(const std::string& readings,
                          double x,
                          const std::string& stamp,
                          std::size_t second) {
  const std::string pose = std::to_string(x) + " 0 0 ";
  return "FLASER " + readings + " " + pose + pose + stamp + " host " + std::to_string(second) +
         "\n";
}

}  // namespace tcert::test_support
