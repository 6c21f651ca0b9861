#pragma once
/// \file
/// Counter-based random streams: the same draws for any number of threads and any standard library.

#include <array>
#include <cstdint>

namespace tcert::table {

/// Philox4x32-10 keyed by (seed, purpose, index): draw k of stream (a, b, c) is always the same.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint32_t purpose, std::uint64_t index) noexcept;

  [[nodiscard]] std::uint32_t bits() noexcept;
  [[nodiscard]] double uniform() noexcept;  ///< In (0, 1), 53 bits, never an end.
  [[nodiscard]] double uniform(double low, double high) noexcept;
  [[nodiscard]] double normal() noexcept;  ///< Standard normal.
  [[nodiscard]] std::uint32_t below(
      std::uint32_t n) noexcept;  ///< In [0, n), unbiased. \pre n > 0.

 private:
  void refill() noexcept;

  std::array<std::uint32_t, 2> key_{};
  std::array<std::uint32_t, 4> counter_{};
  std::array<std::uint32_t, 4> block_{};
  int used_ = 4;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace tcert::table
