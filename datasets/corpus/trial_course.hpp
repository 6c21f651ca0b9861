#pragma once
/// \file
/// The course of one trial: how tight its gates are, given the outcome, and which way is driven.

#include <cstddef>
#include <optional>
#include <table/random.hpp>
#include <vector>

#include "datasets/corpus/design.hpp"
#include "datasets/corpus/figure_eight.hpp"

namespace tcert {

/// One lane of each lobe.
struct LanePair {
  Lane first;
  Lane second;
};

struct TrialCourse {
  FigureEight course;
  std::vector<Gate> gates;  ///< 4 to 8: one or two in each lane, the tightest on its way in first.
  LanePair route;
  std::optional<std::size_t> wedge;  ///< Index of the gate that a failure never passes.
  double true_margin_m = 0.0;        ///< Least gate width on the route, less the body width.
};

/// A course of 0.6 to 1.0 m of radius, its lanes `shift_m` wider than 1.2 m.
[[nodiscard]] FigureEight draw_lanes(double shift_m, table::RandomStream& random);

/// The gates of a lane, first to last, that have no width yet: one or two, the first 0.68 to 0.90 m
/// from the lane's outer end, none beyond 1.5 m, within 2 cm of the centre line.
[[nodiscard]] std::vector<Gate> place_gates(const FigureEight& course,
                                            Lane lane,
                                            table::RandomStream& random);

/// Draws the course of a trial from (seed, k) and its design.
///
/// A trial's *tightness* is one level of margin, shared by its gates, plus noise per gate. The
/// level is 0.090 m on average for a success and 0.047 m * effect less for a failure; the day
/// shifts the lanes' width and with it every gate's. Each gate but one has a positive margin; a
/// failure's wedging gate, in the second lobe at more than 5.6 m of the way, has a negative one
/// that its level says nothing about, so nothing before it depends on the outcome but through
/// `effect`.
[[nodiscard]] TrialCourse draw_course(const TrialDesign& design);

}  // namespace tcert
