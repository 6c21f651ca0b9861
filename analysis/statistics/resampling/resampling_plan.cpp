#include <statistics/resampling/resampling_plan.hpp>

#include <Random123/philox.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <statistics/basics/compact_codes.hpp>
#include <stdexcept>
#include <string>

namespace tcert::statistics {
namespace {

constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();

/// RandomStream's words and bounded draws, inlined: a replicate of a small table takes as long as
/// its random numbers do.
class BoundedDraws {
 public:
  BoundedDraws(std::uint64_t seed, std::uint32_t analysis, std::uint64_t replicate) noexcept
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)}},
        counter_{{0U,
                  analysis,
                  static_cast<std::uint32_t>(replicate),
                  static_cast<std::uint32_t>(replicate >> 32U)}} {}

  std::uint32_t below(std::uint32_t n, std::uint32_t rejected_below) noexcept {
    std::uint64_t product = std::uint64_t{word()} * n;
    while (static_cast<std::uint32_t>(product) < rejected_below) {
      product = std::uint64_t{word()} * n;
    }
    return static_cast<std::uint32_t>(product >> 32U);
  }

 private:
  std::uint32_t word() noexcept {
    if (used_ == 4) {
      block_ = r123::Philox4x32{}(counter_, key_);
      ++counter_[0];
      used_ = 0;
    }
    return block_[used_++];
  }

  r123::Philox4x32::ukey_type key_;
  r123::Philox4x32::ctr_type counter_;
  r123::Philox4x32::ctr_type block_{};
  std::size_t used_ = 4;
};

}  // namespace

ResamplingPlan ResamplingPlan::of_rows(std::size_t rows, std::span<const std::uint32_t> strata) {
  std::vector<std::uint32_t> unit_of_row(rows);
  std::iota(unit_of_row.begin(), unit_of_row.end(), 0U);
  ResamplingPlan plan(std::move(unit_of_row), rows, strata);
  plan.units_are_rows_ = true;
  return plan;
}

ResamplingPlan ResamplingPlan::of_clusters(std::span<const std::uint32_t> cluster,
                                           std::span<const std::uint32_t> strata) {
  CompactCodes codes = compact_codes(cluster);
  return {std::move(codes.codes), codes.count, strata};
}

ResamplingPlan::ResamplingPlan(std::vector<std::uint32_t> unit_of_row,
                               std::size_t units,
                               std::span<const std::uint32_t> strata)
    : unit_of_row_(std::move(unit_of_row)), stratum_of_unit_(units, kUnset) {
  if (unit_of_row_.empty() || unit_of_row_.size() >= kUnset) {
    throw std::invalid_argument("bootstrap: no rows, or more than 2^32");
  }
  if (!strata.empty() && strata.size() != unit_of_row_.size()) {
    throw std::invalid_argument("bootstrap: as many strata codes as rows are needed");
  }
  const CompactCodes strata_codes =
      strata.empty() ? CompactCodes{std::vector<std::uint32_t>(unit_of_row_.size(), 0), 1}
                     : compact_codes(strata);
  for (std::size_t row = 0; row < unit_of_row_.size(); ++row) {
    std::uint32_t& stratum = stratum_of_unit_[unit_of_row_[row]];
    if (stratum != kUnset && stratum != strata_codes.codes[row]) {
      throw std::invalid_argument("bootstrap: the cluster of row " + std::to_string(row + 1) +
                                  " lies in two strata");
    }
    stratum = strata_codes.codes[row];
  }
  stratum_start_.assign(strata_codes.count + 1, 0);
  for (const std::uint32_t stratum : stratum_of_unit_) {
    ++stratum_start_[stratum + 1];
  }
  std::partial_sum(stratum_start_.begin(), stratum_start_.end(), stratum_start_.begin());
  stratum_units_.resize(units);
  std::vector<std::size_t> next(stratum_start_.begin(), stratum_start_.end() - 1);
  for (std::uint32_t unit = 0; unit < units; ++unit) {
    stratum_units_[next[stratum_of_unit_[unit]]++] = unit;
  }
}

void ResamplingPlan::draw(std::uint64_t seed,
                          std::uint32_t analysis,
                          std::uint64_t replicate,
                          std::span<std::uint32_t> unit_scratch,
                          std::span<std::uint32_t> multiplicity) const noexcept {
  const std::span<std::uint32_t> count = units_are_rows_ ? multiplicity : unit_scratch;
  std::fill(count.begin(), count.end(), 0U);
  BoundedDraws random(seed, analysis, replicate);
  for (std::size_t s = 0; s + 1 < stratum_start_.size(); ++s) {
    const std::uint32_t* const members = stratum_units_.data() + stratum_start_[s];
    const auto n = static_cast<std::uint32_t>(stratum_start_[s + 1] - stratum_start_[s]);
    const std::uint32_t rejected_below = (0U - n) % n;
    for (std::uint32_t k = 0; k < n; ++k) {
      ++count[members[random.below(n, rejected_below)]];
    }
  }
  if (!units_are_rows_) {
    for (std::size_t row = 0; row < multiplicity.size(); ++row) {
      multiplicity[row] = count[unit_of_row_[row]];
    }
  }
}

}  // namespace tcert::statistics
