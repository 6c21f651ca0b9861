#pragma once
/// \file
/// A tracking-error grid from a table of its knots.

#include <table/data_table.hpp>
#include <tcert/tracking_error.hpp>

namespace tcert::study {

/// One row a knot, in any order: speed_mps, acceleration_mps2, disturbance, radius_m; or in the
/// place of the acceleration speed_left_mps with hold_s, which is the same in all rows of one.
/// \throws std::invalid_argument if a column is not there, a cell is missing, or the rows are not
/// every knot of a full grid once.
[[nodiscard]] TrackingErrorGrid tracking_error_grid(const table::DataTable& table);

}  // namespace tcert::study
