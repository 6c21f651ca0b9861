#include <statistics/basics/compact_codes.hpp>

#include <algorithm>
#include <stdexcept>
#include <table/factor.hpp>

namespace tcert::statistics {

namespace {

std::vector<std::uint32_t> distinct_codes(std::span<const std::uint32_t> codes) {
  std::vector<std::uint32_t> distinct(codes.begin(), codes.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  return distinct;
}

}  // namespace

CompactCodes compact_codes(std::span<const std::uint32_t> codes) {
  const std::vector<std::uint32_t> distinct = distinct_codes(codes);
  if (!distinct.empty() && distinct.back() == table::Factor::kMissing) {
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

std::size_t count_codes(std::span<const std::uint32_t> codes) {
  return distinct_codes(codes).size();
}

}  // namespace tcert::statistics
