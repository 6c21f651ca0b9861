#pragma once
/// \file
/// Which cells of a square lattice are proven free: a bit a cell, rows of 64-bit words.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert::witness {

/// A box of cells of the lattice whose lines are the multiples of `cell_m` in the log's frame.
/// Cell (ix, iy), 0 <= ix < columns and 0 <= iy < rows, covers from corner(ix, iy) to
/// corner(ix + 1, iy + 1).
struct Lattice {
  double cell_m = 0.005;
  std::int64_t first_x = 0;  ///< The number of column 0: its left side lies at first_x * cell_m.
  std::int64_t first_y = 0;
  int columns = 0;
  int rows = 0;

  [[nodiscard]] Point corner(int ix, int iy) const noexcept {
    return {static_cast<double>(first_x + ix) * cell_m, static_cast<double>(first_y + iy) * cell_m};
  }
  /// Column in which a coordinate lies, clamped to -1 and `columns`.
  [[nodiscard]] int column_of(double x_m) const noexcept { return index_of(x_m, first_x, columns); }
  [[nodiscard]] int row_of(double y_m) const noexcept { return index_of(y_m, first_y, rows); }

 private:
  [[nodiscard]] int index_of(double at_m, std::int64_t first, int count) const noexcept {
    const double index = std::floor(at_m / cell_m) - static_cast<double>(first);
    return index < 0.0 ? -1 : index >= count ? count : static_cast<int>(index);
  }
};

/// Everything outside of the lattice is not free.
class FreeCells {
 public:
  FreeCells() = default;

  /// A lattice that covers the box from `low` to `high` and a cell more on every side; no cell is
  /// free. \throws std::length_error if that is more than `max_cells` cells.
  FreeCells(Point low, Point high, double cell_m, std::size_t max_cells);
  /// \pre columns and rows are not negative.
  explicit FreeCells(const Lattice& lattice);

  [[nodiscard]] const Lattice& lattice() const noexcept { return lattice_; }

  /// Marks the cells of a row from `first` to `last`, both included, as far as the lattice goes.
  void mark_run(int iy, int first, int last) noexcept;
  void mark(int ix, int iy) noexcept {
    words_[place_of(ix, iy)] |= std::uint64_t{1} << (static_cast<unsigned>(ix) % 64U);
  }
  [[nodiscard]] bool is_free(int ix, int iy) const noexcept {
    return ix >= 0 && iy >= 0 && ix < lattice_.columns && iy < lattice_.rows &&
           (words_[place_of(ix, iy)] >> (static_cast<unsigned>(ix) % 64U) & 1U) != 0;
  }
  /// Bit ix % 64 of word ix / 64 of a row; bits beyond the last column are 0. \pre 0 <= iy < rows.
  [[nodiscard]] std::span<const std::uint64_t> row(int iy) const noexcept {
    return std::span(words_).subspan(static_cast<std::size_t>(iy) * words_a_row_, words_a_row_);
  }
  [[nodiscard]] std::size_t count() const noexcept;

  friend bool operator==(const FreeCells& a, const FreeCells& b) noexcept {
    return a.lattice_.cell_m == b.lattice_.cell_m && a.lattice_.first_x == b.lattice_.first_x &&
           a.lattice_.first_y == b.lattice_.first_y && a.lattice_.columns == b.lattice_.columns &&
           a.lattice_.rows == b.lattice_.rows && a.words_ == b.words_;
  }

 private:
  [[nodiscard]] std::size_t place_of(int ix, int iy) const noexcept {
    return static_cast<std::size_t>(iy) * words_a_row_ + static_cast<std::size_t>(ix) / 64;
  }

  Lattice lattice_;
  std::size_t words_a_row_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace tcert::witness
