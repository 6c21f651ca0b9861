#pragma once
/// \file
/// An interval as cells of a row.

#include <statistics/basics/interval.hpp>
#include <table/row_text.hpp>

namespace tcert::statistics {

void row_cells(auto& row, table::Is<Interval> auto& interval) {
  row(interval.low, interval.high, interval.level);
}

}  // namespace tcert::statistics
