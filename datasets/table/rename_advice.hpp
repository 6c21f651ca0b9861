#pragma once
/// \file
/// The way out of a missing column that only a table of a bundle has.

#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

inline constexpr std::string_view kRenameAdvice =
    "; rename a foreign one under 'columns' in bundle.json";

/// For a table that stands alone: there is no bundle.json to rename columns in.
inline void drop_rename_advice(std::vector<Diagnostic>& diagnostics) {
  for (Diagnostic& one : diagnostics) {
    if (const auto at = one.expectation.find(kRenameAdvice); at != std::string::npos) {
      one.expectation.erase(at);
    }
  }
}

}  // namespace tcert::table
