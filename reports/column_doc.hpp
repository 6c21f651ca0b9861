#pragma once
/// \file
/// What a column of a result file means.

#include <string>

namespace tcert {

struct ColumnDoc {
  std::string name;
  std::string unit;  ///< Empty for a pure number or a word.
  std::string doc;   ///< One line, no full stop.
};

/// Of the last column of every synthetic table.
[[nodiscard]] inline ColumnDoc synthetic_seed_doc() {
  return {"synthetic_seed", "", "seed of synthetic data; not in real data"};
}

}  // namespace tcert
