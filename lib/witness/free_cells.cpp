#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string>
#include <witness/free_cells.hpp>

namespace tcert::witness {
namespace {

/// A count, of which nobody wants a fraction.
std::string printed(double count) {
  std::string text = std::to_string(count);
  return text.substr(0, text.find('.'));
}

Lattice lattice_over(Point low, Point high, double cell_m, std::size_t max_cells) {
  const double left = std::floor(low.x_m / cell_m) - 1.0;
  const double bottom = std::floor(low.y_m / cell_m) - 1.0;
  const double columns = std::ceil(high.x_m / cell_m) + 1.0 - left;
  const double rows = std::ceil(high.y_m / cell_m) + 1.0 - bottom;
  if (!(columns * rows <= static_cast<double>(max_cells))) {
    throw std::length_error("the box of the run holds " + printed(columns * rows) +
                            " cells; max_witness_cells is " + std::to_string(max_cells));
  }
  return {cell_m,
          static_cast<std::int64_t>(left),
          static_cast<std::int64_t>(bottom),
          static_cast<int>(columns),
          static_cast<int>(rows)};
}

}  // namespace

FreeCells::FreeCells(Point low, Point high, double cell_m, std::size_t max_cells)
    : FreeCells(lattice_over(low, high, cell_m, max_cells)) {}

FreeCells::FreeCells(const Lattice& lattice)
    : lattice_(lattice),
      words_a_row_((static_cast<std::size_t>(lattice.columns) + 63) / 64),
      words_(words_a_row_ * static_cast<std::size_t>(lattice.rows)) {}

void FreeCells::mark_run(int iy, int first, int last) noexcept {
  first = std::max(first, 0);
  last = std::min(last, lattice_.columns - 1);
  if (iy < 0 || iy >= lattice_.rows || first > last) {
    return;
  }
  const std::size_t from = place_of(first, iy);
  const std::size_t to = place_of(last, iy);
  const std::uint64_t head = ~std::uint64_t{0} << (static_cast<unsigned>(first) % 64U);
  const std::uint64_t tail = ~std::uint64_t{0} >> (63U - static_cast<unsigned>(last) % 64U);
  if (from == to) {
    words_[from] |= head & tail;
    return;
  }
  words_[from] |= head;
  std::fill(words_.begin() + static_cast<std::ptrdiff_t>(from) + 1,
            words_.begin() + static_cast<std::ptrdiff_t>(to),
            ~std::uint64_t{0});
  words_[to] |= tail;
}

std::size_t FreeCells::count() const noexcept {
  std::size_t count = 0;
  for (const std::uint64_t word : words_) {
    count += static_cast<std::size_t>(std::popcount(word));
  }
  return count;
}

}  // namespace tcert::witness
