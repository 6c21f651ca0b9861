#pragma once
/// \file
/// The decaying contact memory M_t of the traversal policy: a risk prior in [0, 1]
/// (paper 3.1, 3.3).

#include <cstdint>
#include <tcert/geometry.hpp>
#include <tcert/parameters.hpp>
#include <vector>

namespace tcert {

/// Values on a hash grid; each contact raises the cells near it, all halve every half-life.
///
/// The constructor takes all memory. If a neighbourhood of the hash table is full, the cell with
/// the least remaining memory gives way.
class ContactMemory {
 public:
  explicit ContactMemory(const CertificateParameters& parameters);

  void clear() noexcept;

  /// A contact of `force_n` (NaN: no force sensor, taken as the cap) at `point`:
  /// M <- M + (1 - M) a exp(-d^2 / 2 sigma^2), a = gain min(F, cap)/cap, cut at 3 sigma.
  /// \pre `time_s` never falls between two clears.
  void add(Point point, double force_n, double time_s) noexcept;

  /// Largest memory at the cell centres within `radius_m` of `centre`; 0 if there are none.
  [[nodiscard]] double largest_within(Point centre, double radius_m, double time_s) const noexcept;

 private:
  struct Cell {
    std::int32_t ix = 0;
    std::int32_t iy = 0;
    double value = 0.0;     // at age_halvings
    double halvings = 0.0;  // time of `value` in half-lives
    bool used = false;
  };
  [[nodiscard]] std::size_t slot_of(std::int32_t ix, std::int32_t iy) const noexcept;
  [[nodiscard]] const Cell* find(std::int32_t ix, std::int32_t iy) const noexcept;
  [[nodiscard]] Cell& claim(std::int32_t ix, std::int32_t iy, double halvings) noexcept;

  CertificateParameters parameters_;
  std::vector<Cell> cells_;      // a power of two
  std::vector<double> weights_;  // scratch: exp(-dx^2 / 2 sigma^2) of one row
  bool empty_ = true;
};

}  // namespace tcert
