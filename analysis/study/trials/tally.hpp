#pragma once
/// \file
/// Exact medians of any number of samples.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tcert::study {

/// How often each value occurs: a table of the distinct values, found by their bits. What is
/// commanded and measured at steps of a clock repeats, so that a tally is far smaller than its
/// samples.
class Tally {
 public:
  Tally() = default;
  explicit Tally(std::span<const double> samples) { add(samples); }

  /// NaN is left out; -0 counts as 0. O(1) a sample.
  void add(std::span<const double> samples);
  void add(const Tally& other);

  /// Type-7 median; empty without a sample. O(n log n) in distinct values.
  [[nodiscard]] std::optional<double> median() const;

 private:
  struct Entry {
    double value = 0.0;
    std::uint64_t count = 0;  ///< 0: the place is free.
  };

  void add(double value, std::uint64_t count);
  void grow();
  [[nodiscard]] Entry& place_of(double value) noexcept;

  std::vector<Entry> entries_;  // a power of two of them, at most a quarter in use
  std::size_t distinct_ = 0;
  std::uint64_t total_ = 0;
};

/// Median of the samples that are known; empty if none is.
[[nodiscard]] inline std::optional<double> known_median(std::span<const double> samples) {
  return Tally(samples).median();
}

}  // namespace tcert::study
