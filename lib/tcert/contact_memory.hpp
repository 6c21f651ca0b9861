#pragma once
/// \file
/// The decaying contact memory M_t of the traversal policy: a risk prior in [0, 1]
/// (paper 3.1, 3.3).

#include <array>
#include <cstddef>
#include <cstdint>
#include <tcert/geometry.hpp>
#include <tcert/parameters.hpp>
#include <vector>

namespace tcert {

/// Values on a hash grid; each contact raises the cells near it, all halve every half-life.
///
/// Cells are kept in blocks of 4 x 4, so that a neighbourhood is few look-ups. The constructor
/// takes all memory. Where the table is full, the faintest block nearby gives way; evicted() says
/// so if that still held anything.
class ContactMemory {
 public:
  static constexpr std::int32_t kSide = 4;  ///< Cells along a side of a block.

  explicit ContactMemory(const CertificateParameters& parameters);

  void clear() noexcept;

  /// A contact of `force_n` (NaN: no force sensor, taken as the cap) at `point`:
  /// M <- M + (1 - M) a exp(-d^2 / 2 sigma^2), a = gain min(F, cap)/cap, cut at 3 sigma.
  /// \pre `time_s` never falls between two clears.
  void add(Point point, double force_n, double time_s) noexcept;

  /// Largest memory at the cell centres within `radius_m` of `centre`; 0 if there are none.
  [[nodiscard]] double largest_within(Point centre, double radius_m, double time_s) const noexcept;

  /// Mean memory along the straight line of `length_m` from `from`: (1/d) int_0^d M(x + s u) ds,
  /// M constant on cells, exact but for rounding. On a line that runs along the border of two rows
  /// of cells M is the mean of both, so that a mirrored line through a mirrored memory gives the
  /// same bits. 0 from further off than 10^8 cells. O(cells along the line).
  /// \pre finite numbers, a unit vector, length_m > 0.
  [[nodiscard]] double mean_along(Point from,
                                  Point unit_direction,
                                  double length_m,
                                  double time_s) const noexcept;

  /// True once memory above 10^-6 was forgotten for want of room, until the next clear.
  [[nodiscard]] bool evicted() const noexcept { return evicted_; }

 private:
  struct Block {
    std::int32_t bx = 0;
    std::int32_t by = 0;
    double halvings = -1.0;  // time of the values in half-lives; negative: not used
    std::array<double, std::size_t{kSide} * kSide> values{};  // row by row
  };
  [[nodiscard]] std::size_t slot_of(std::int32_t bx, std::int32_t by) const noexcept;
  [[nodiscard]] const Block* find(std::int32_t bx, std::int32_t by) const noexcept;
  [[nodiscard]] double integral_along(Point from,
                                      Point unit_direction,
                                      double length_m,
                                      double halvings,
                                      std::int32_t shift_x,
                                      std::int32_t shift_y) const noexcept;
  [[nodiscard]] Block& claim(std::int32_t bx, std::int32_t by, double halvings) noexcept;

  CertificateParameters parameters_;
  std::vector<Block> blocks_;        // a power of two
  std::vector<std::uint32_t> used_;  // slots of those that are
  // Scratch of add(): exp(-d^2 / 2 sigma^2) by column and by row of the cells near a contact.
  std::vector<double> column_weights_;
  std::vector<double> row_weights_;
  double ratio_fall_ = 0.0;   // exp(-cell^2 / sigma^2)
  double faded_since_ = 0.0;  // in half-lives; fading_ is 2 to this
  double fading_ = 1.0;
  bool evicted_ = false;
};

}  // namespace tcert
