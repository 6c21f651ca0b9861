#pragma once
/// \file
/// What a search hands back: a path and what the checker says of it.

#include <optional>
#include <string>
#include <witness/checker.hpp>
#include <witness/path.hpp>

namespace tcert::witness {

/// A path and what the checker says of it.
struct Witness {
  Path path;
  Checked checked;
};

struct Found {
  std::optional<Witness> witness;  ///< Not refused; its margin may be below 0.
  std::string reason;              ///< Why there is none.
};

}  // namespace tcert::witness
