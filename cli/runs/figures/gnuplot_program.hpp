#pragma once
/// \file
/// Running gnuplot, where it is installed.

#include <filesystem>
#include <string>

namespace tcert::cli {

/// True if there is a gnuplot in PATH.
[[nodiscard]] bool has_gnuplot();

/// `gnuplot -c SCRIPT FORM` in `folder`. \throws std::runtime_error with what it says on stderr if
/// it does not end well.
void run_gnuplot(const std::filesystem::path& folder,
                 const std::string& script,
                 const std::string& form);

}  // namespace tcert::cli
