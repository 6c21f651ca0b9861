#pragma once
/// \file
/// The inner free space F_t of the paper (2.2), from what one run felt.

#include <cstddef>
#include <tcert/robot.hpp>
#include <witness/free_cells.hpp>
#include <witness/ray_strips.hpp>
#include <witness/samples.hpp>

namespace tcert::witness {

struct FreeSpaceOptions {
  double cell_m = 0.005;
  StripRule strips;
  std::size_t max_cells = std::size_t{1} << 24U;  ///< Of the box of the run, free or not.
};

/// S as it is given, or else the disc of half the body width round the first sample.
/// \pre a start, or a sample.
[[nodiscard]] Region start_of(const Robot& robot, const Course& course, const Samples& samples);

/// The cells that lie wholly within
/// - S or G, which are free by assumption,
/// - the body's disc at a sample, or
/// - what a ray has passed (RayStrips).
///
/// What it rests on: readings that are true or, less `reading_bound_m`, too small; poses that are
/// true, between two pose samples too; the rule for obstacles of RayStrips; S and G free.
/// What it loses against what was felt: half a step of the ray's tip (lost_share), and the cells
/// that a border cuts, 1.7 cells a side on average (3.4 of width).
///
/// O(samples x (cells of a strip and of the body)).
/// \throws std::length_error if the box of the run holds more than `max_cells` cells.
[[nodiscard]] FreeCells free_space(const Robot& robot,
                                   const Course& course,
                                   const Samples& samples,
                                   const FreeSpaceOptions& options);

}  // namespace tcert::witness
