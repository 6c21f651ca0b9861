#pragma once
/// \file
/// An exploration by a robot that is not simulated: measurements in, the next place and the way
/// out.

#include <map>
#include <memory>
#include <optional>
#include <terrain/explorer.hpp>
#include <terrain/settle.hpp>
#include <vector>

namespace tcert::terrain {

/// What the robot is to do.
struct Decision {
  ExploreStep row;            ///< unsafe_certified and unsafe_visits are not known, and 0.
  std::vector<Position> way;  ///< From where the robot stands, without that, to next or the goal.
  std::optional<End> end;     ///< None: go to the end of the way, measure there, and plan again.
  std::size_t goals_reached = 0;
};

/// Before the first plan the robot measures round its start, and last of all where it stands: what
/// the setup leaves open is settled by that. Then explore() on a terrain with the same values gives
/// the same rows, bit for bit, if the robot goes where it is told to, with the setup's max_steps
/// the limit of all measurements after the first plan. A cell measured again says nothing new.
class Session {
 public:
  /// `setup.first_cells` are not looked at. \throws std::invalid_argument for a setup that is not
  /// within its limits, and for rules other than `certified` and `band`.
  Session(const Grid& grid, ExploreSetup setup, const Told& told);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// A measurement beside the way. What throws changes nothing. \throws std::invalid_argument for
  /// one that cannot be: outside of the grid, on a blocked cell, not within +-1e30, farther from an
  /// earlier one of that cell than twice the noise bound (`band`: 10 sd), or beyond the limit of
  /// measurements, which is 100,000 before the first plan.
  void take(Cell c, double value);

  /// The robot stands at `c` and measured it. \throws std::invalid_argument as take() does, after
  /// `step_limit`, and at the first plan for a start that is not safe or too few measurements round
  /// it; that changes nothing either, so that more may be measured and the plan asked for again.
  const Decision& plan(Cell c, double value);

  /// Cells that the robot is to measure before the first plan, the start last.
  [[nodiscard]] std::vector<Cell> first_cells(int radius) const;

  /// Null before the first plan.
  [[nodiscard]] const Explorer* explorer() const noexcept { return explorer_.get(); }
  [[nodiscard]] const Grid& grid() const noexcept { return grid_; }
  /// Settled once there was a plan.
  [[nodiscard]] const ExploreSetup& setup() const noexcept { return settled_ ? *settled_ : setup_; }

 private:
  void require(Cell c, double value) const;
  void require_same(const ExploreSetup& setup, Cell c, double value) const;
  void begin(const Measurement& at_start);
  void decide();

  Grid grid_;
  ExploreSetup setup_;
  Told told_;
  std::vector<Measurement> first_;         // before the first plan
  std::map<std::size_t, double> values_;   // of cells that were measured
  std::unique_ptr<ExploreSetup> settled_;  // to which the explorer refers
  std::unique_ptr<Explorer> explorer_;
  int step_ = 0;
  int beside_ = 0;  // measurements after the first plan that were no plans
  Measurement last_;
  Decision decision_;
};

/// The cells within `radius` of `start` that are not blocked, row by row, the start not among them.
[[nodiscard]] std::vector<Cell> cells_round(const Grid& grid,
                                            const CellSet& blocked,
                                            Cell start,
                                            int radius);

}  // namespace tcert::terrain
