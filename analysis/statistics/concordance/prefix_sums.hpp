#pragma once
/// \file
/// Sums up to any slot of an array that changes: what a rank statistic counts with.

#include <array>
#include <cstddef>
#include <type_traits>
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
      // All slots of the block, those not behind with nothing: a loop of known length, in vectors.
      T* __restrict const block = sums_.data() + offset_[level] + (slot / kFan) * kFan;
      const T* __restrict const behind = kBehind[slot % kFan].data();
      for (std::size_t k = 0; k < kFan; ++k) {
        block[k] += masked(weight, behind[k]);
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

  static constexpr T masked(T weight, T mask) noexcept {
    if constexpr (std::is_floating_point_v<T>) {
      return weight * mask;
    } else {
      return weight & mask;
    }
  }
  static constexpr T masked_all() noexcept {
    if constexpr (std::is_floating_point_v<T>) {
      return T{1};
    } else {
      return static_cast<T>(~T{0});
    }
  }
  /// By slot: which slots of its block lie behind it, as 1 or as all bits.
  static constexpr auto kBehind = [] {
    std::array<std::array<T, kFan>, kFan> behind{};
    for (std::size_t slot = 0; slot < kFan; ++slot) {
      for (std::size_t k = slot + 1; k < kFan; ++k) {
        behind[slot][k] = masked_all();
      }
    }
    return behind;
  }();

  std::array<std::size_t, kMaxLevels> offset_{};
  std::size_t levels_ = 0;
  std::vector<T> sums_;
  T total_{0};
};

}  // namespace tcert::statistics
