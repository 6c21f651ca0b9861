#pragma once
/// \file
/// Sums up to any slot of an array that changes: what a rank statistic counts with.

#include <array>
#include <cstddef>
#include <vector>

namespace tcert::statistics {

/// Weights by slot. Each level holds, per slot, the sum of the slots before it in its block of
/// sixteen; the next level has a slot per block. A change is a short run of additions per level, a
/// sum one load per level: fewer and nearer memory accesses than a Fenwick tree's. Both O(log n).
/// Sums of whole numbers are exact in `T` double while below 2^53.
template <typename T>
class PrefixSums {
 public:
  PrefixSums() = default;
  explicit PrefixSums(std::size_t slots) { reset(slots); }

  /// All weights 0. Allocates only if it never had as many slots.
  void reset(std::size_t slots) {
    levels_ = 0;
    std::size_t size = 0;
    for (std::size_t count = slots; levels_ == 0 || count > 1;) {
      offset_[levels_++] = size;
      count = (count + kFan - 1) / kFan;
      size += count * kFan;
    }
    sums_.assign(size, T{0});
    total_ = T{0};
  }

  /// \pre slot < slots.
  void add(std::size_t slot, T weight) noexcept {
    total_ += weight;
    for (std::size_t level = 0; level < levels_; ++level, slot /= kFan) {
      T* const block = sums_.data() + offset_[level] + (slot / kFan) * kFan;
      for (std::size_t k = slot % kFan + 1; k < kFan; ++k) {
        block[k] += weight;
      }
    }
  }

  /// Sum of the weights of slots 0 .. slot - 1. \pre slot < slots.
  [[nodiscard]] T before(std::size_t slot) const noexcept {
    T sum{0};
    for (std::size_t level = 0; level < levels_; ++level, slot /= kFan) {
      sum += sums_[offset_[level] + slot];
    }
    return sum;
  }

  [[nodiscard]] T total() const noexcept { return total_; }

 private:
  static constexpr std::size_t kFan = 16;
  static constexpr std::size_t kMaxLevels = 16;  // 16^16 slots

  std::array<std::size_t, kMaxLevels> offset_{};
  std::size_t levels_ = 0;
  std::vector<T> sums_;
  T total_{0};
};

}  // namespace tcert::statistics
