#include "analysis/basics/compact_codes.hpp"

#include <algorithm>
#include <stdexcept>

#include "datasets/factor.hpp"

namespace tcert {

CompactCodes compact_codes(std::span<const std::uint32_t> codes) {
  std::vector<std::uint32_t> distinct(codes.begin(), codes.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (!distinct.empty() && distinct.back() == Factor::kMissing) {
    throw std::invalid_argument("a row without its group");
  }
  CompactCodes result;
  result.count = distinct.size();
  result.codes.reserve(codes.size());
  for (const std::uint32_t code : codes) {
    result.codes.push_back(static_cast<std::uint32_t>(
        std::lower_bound(distinct.begin(), distinct.end(), code) - distinct.begin()));
  }
  return result;
}

}  // namespace tcert
