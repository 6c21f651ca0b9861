#pragma once
/// \file
/// Result text of the BARN challenge: what its run.py appends to out.txt, a line a trial.

#include <string>
#include <string_view>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>

namespace tcert {

/// True if the first line that is neither blank nor a comment holds five or six numbers (or words
/// for truth) with blanks between, and so no names of columns.
[[nodiscard]] bool is_barn_results(std::string_view text);

/// The name that a file gives to its planner: that of the file up to its first dot, without a last
/// "_out" or "-out": dwa of dwa_out.txt. Empty if nothing is left, as of out.txt.
[[nodiscard]] std::string planner_of_file(std::string_view path);

/// A line a trial: world success collided timeout time nav_metric, blanks between, the last one or
/// not. As a table with the columns planner (the same for all), world, success, collided, timeout,
/// time_s. A line with another number of words is an error and left out; a last line that is cut
/// short a warning. O(size).
[[nodiscard]] table::TextTable read_barn_results(const table::Bytes& bytes,
                                                 const std::string& file,
                                                 const std::string& planner,
                                                 table::DiagnosticGroups& problems);

}  // namespace tcert
