#pragma once
/// \file
/// A column of names as codes: what a level of a factor, a stratum or a cluster is in memory.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tcert::table {

/// `levels` are sorted by byte (R's C locale) unless the maker says otherwise; a code indexes them.
struct Factor {
  static constexpr std::uint32_t kMissing = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> codes;  ///< One a row, below levels.size(), or kMissing.
  std::vector<std::string> levels;

  [[nodiscard]] std::size_t rows() const noexcept { return codes.size(); }
};

}  // namespace tcert::table
