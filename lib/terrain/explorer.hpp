#pragma once
/// \file
/// The decisions of an exploration, for a robot that is simulated and for one that is not.

#include <optional>
#include <terrain/explore.hpp>
#include <terrain/model_choices.hpp>
#include <terrain/planner.hpp>
#include <terrain/ways.hpp>

namespace tcert::terrain {

/// A robot that explores calls add() for what it measured, plan(), and goes by go(); until end()
/// says that it is over. explore() does nothing else, and knows the terrain besides.
class Explorer {
 public:
  /// Keeps a reference to `setup`, whose `known` it takes at once. \throws std::invalid_argument
  /// for a setup that is not within its limits.
  Explorer(const Grid& grid, const ExploreSetup& setup);

  /// \throws std::invalid_argument, std::domain_error: see Planner::add().
  void add(const Measurement& measurement) { planner_.add(measurement); }
  /// False for a cell whose value is known: measured again it would say nothing new. Always true
  /// under `thesis` and `published`.
  [[nodiscard]] bool asks_for(Cell c) const;
  /// The robot stands here, by its own account; the way there counts as straight.
  void place(const Position& robot);

  /// Plans with all that was measured. The row is what is known without the terrain itself.
  const ExploreStep& plan(int step, const Measurement& last);

  /// How it ended, if it did: `exhausted` stands for all that only the terrain itself can tell
  /// apart. \pre plan()
  [[nodiscard]] std::optional<End> end(int step) const;

  /// Goes to where the next measurement is to be taken. \pre end() is none
  Way go();
  /// Goes to the goal; a row that is planned after it is of the next one, if there is one.
  /// \pre end() is `reached`
  Way go_to_goal();
  /// True if there was another goal, which is now looked for from where the robot stands.
  bool take_next_goal();

  [[nodiscard]] Planner& planner() noexcept { return planner_; }
  [[nodiscard]] const Planner& planner() const noexcept { return planner_; }
  [[nodiscard]] const std::optional<Cell>& goal() const noexcept { return goal_; }
  /// The start, or the goal before this one.
  [[nodiscard]] Cell leg_start() const noexcept { return leg_start_; }
  [[nodiscard]] const Position& robot() const noexcept { return robot_; }
  [[nodiscard]] double travelled() const noexcept { return travelled_; }
  /// The cell within reach that is nearest to the goal; the robot's without a goal.
  [[nodiscard]] Position frontier() const;
  /// Of the last plan. O(cells log cells).
  [[nodiscard]] Layers layers() const;
  /// Where the robot will go to measure. \pre end() is none
  [[nodiscard]] Cell target() const;

 private:
  /// l_t, or the least of it under the body.
  [[nodiscard]] std::vector<double> proven_under_body() const;
  [[nodiscard]] bool is_joined_to_goal() const;
  [[nodiscard]] bool deep_enough(int step) const;
  Way follow(Cell to);

  const ExploreSetup& setup_;
  Planner planner_;
  ModelChoices choices_;
  std::optional<Cell> goal_;
  std::size_t goals_taken_ = 0;  // of more_goals
  Cell leg_start_;
  Position robot_;
  double travelled_ = 0.0;
  ExploreStep row_;
};

}  // namespace tcert::terrain
