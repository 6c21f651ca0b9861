#include <statistics/basics/compact_codes.hpp>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <table/factor.hpp>

namespace tcert::statistics {

namespace {

constexpr std::uint32_t kMissing = table::Factor::kMissing;

/// By code: 1 if a row has it. The last one is of the rows without a code.
std::vector<std::uint32_t> present_codes(std::span<const std::uint32_t> codes) {
  std::uint32_t end = 0;
  for (const std::uint32_t code : codes) {
    end = code == kMissing ? end : std::max(end, code + 1);
  }
  std::vector<std::uint32_t> present(std::size_t{end} + 1, 0);
  for (const std::uint32_t code : codes) {
    present[std::min(code, end)] = 1;
  }
  return present;
}

}  // namespace

CompactCodes compact_codes(std::span<const std::uint32_t> codes) {
  std::vector<std::uint32_t> number = present_codes(codes);
  if (number.back() != 0) {
    throw std::invalid_argument("a row without its group");
  }
  std::exclusive_scan(number.begin(), number.end(), number.begin(), std::uint32_t{0});
  CompactCodes result;
  result.count = number.back();
  result.codes.reserve(codes.size());
  for (const std::uint32_t code : codes) {
    result.codes.push_back(number[code]);
  }
  return result;
}

std::size_t count_codes(std::span<const std::uint32_t> codes) {
  const std::vector<std::uint32_t> present = present_codes(codes);
  return std::accumulate(present.begin(), present.end(), std::size_t{0});
}

}  // namespace tcert::statistics
