#pragma once
/// \file
/// One planning step: measurements in, safe set and next sample out.

#include <cstdint>
#include <memory>
#include <optional>
#include <terrain/body.hpp>
#include <terrain/confidence.hpp>
#include <terrain/grid.hpp>
#include <terrain/rules.hpp>
#include <terrain/selection.hpp>
#include <terrain/separable_gp.hpp>
#include <vector>

namespace tcert::terrain {

/// What a planning step found.
struct Plan {
  std::size_t safe = 0;        ///< |S_t|, blocked cells not counted.
  std::size_t expanders = 0;   ///< |G_t| before the n nearest are taken.
  std::size_t maximisers = 0;  ///< `published`: |M|.
  std::size_t candidates = 0;  ///< `published`: cells that may be tested as expanders.
  std::optional<Cell> next;    ///< x_t; none if S_t is empty or no cell can make it grow.
  double lower = 0.0;          ///< l_t and u_t there.
  double upper = 0.0;
  /// `certified`: the model rules every expander out, the Lipschitz bound does not; G_t is by the
  /// latter.
  bool against_the_model = false;
};

class Planner {
 public:
  /// `seeds` is S_0: ground that is known to be safe without a measurement (`thesis` needs it).
  /// \throws std::invalid_argument for rules, a prior or seeds that cannot be.
  Planner(const Grid& grid,
          const Rules& rules,
          const GpPrior& prior,
          const std::vector<Cell>& seeds = {});

  /// Takes a measurement. Under `certified` it must be at a cell's centre; if it contradicts the
  /// Lipschitz constant, that is raised to the slope that was measured and everything certified is
  /// derived anew. \throws std::invalid_argument for a value or position that cannot be.
  void add(const Measurement& measurement);

  /// Replaces the Lipschitz constant, never by less than what was measured; what is certified is
  /// derived anew. `certified` only. \pre lipschitz > 0
  void set_lipschitz(double lipschitz);

  /// `band`: an upper bound of the field's variance, of which the prior's is a share; infinite
  /// until it is set, and then nothing is certified. With noise the model begins again with its
  /// share: O(n) additions. \pre variance > 0
  void set_field_variance(double variance);

  /// What has to be certified for the robot to stand; a point unless set.
  void set_body(const Body& body);

  /// Cells that are physically blocked: safe or not, nothing is chosen or reached there.
  void set_blocked(CellSet blocked);

  /// Updates the sets and chooses. Without a goal: the widest expander anywhere. Under `certified`
  /// and `band`, and under all rules once there are blocked cells or a body, only cells that
  /// `robot` can reach over cells where it can stand are chosen.
  const Plan& plan(std::optional<Cell> goal, std::optional<Cell> robot = std::nullopt);

  /// Begins with another prior and the same measurements: O(n) additions.
  void change_prior(const GpPrior& prior);

  [[nodiscard]] const Grid& grid() const noexcept { return grid_; }
  [[nodiscard]] const Rules& rules() const noexcept { return rules_; }
  [[nodiscard]] const SeparableGp& model() const noexcept { return *model_; }
  [[nodiscard]] const std::vector<Measurement>& measurements() const noexcept {
    return measurements_;
  }
  [[nodiscard]] const Plan& last_plan() const noexcept { return plan_; }
  [[nodiscard]] const CellSet& safe() const noexcept { return safe_; }
  /// Safe and not blocked.
  [[nodiscard]] CellSet ground() const;
  /// Where the body stands on ground alone, as of the last plan.
  [[nodiscard]] const CellSet& standing() const noexcept { return standing_; }
  [[nodiscard]] const Footprint& footprint() const noexcept { return footprint_; }
  /// `band`: see set_field_variance().
  [[nodiscard]] double field_variance() const noexcept { return field_variance_; }
  [[nodiscard]] const CellSet& expander_set() const noexcept { return expanders_; }
  /// The members of G_t that were considered: the n nearest to the goal, or the n widest without
  /// one.
  [[nodiscard]] const CellSet& considered() const noexcept { return considered_; }
  /// C_t: what the choice of samples goes by.
  [[nodiscard]] const Intervals& intervals() const noexcept { return intervals_; }
  /// l_t as the certificate takes it: under `certified` what is proven of each cell.
  [[nodiscard]] const std::vector<double>& proven() const noexcept {
    return rules_.kind == RuleSet::certified ? cone_.lower : intervals_.lower;
  }
  /// u_t in the same sense.
  [[nodiscard]] const std::vector<double>& possible() const noexcept {
    return rules_.kind == RuleSet::certified ? cone_.upper : intervals_.upper;
  }
  /// Times a measurement raised the Lipschitz constant.
  [[nodiscard]] int contradictions() const noexcept { return contradictions_; }
  /// Cells where the model's band and the Lipschitz bound exclude one another at the last step.
  [[nodiscard]] std::size_t model_contradictions() const noexcept { return empty_; }

 private:
  void plan_thesis(std::optional<Cell> goal, std::optional<Cell> robot);
  void plan_published(std::optional<Cell> goal, std::optional<Cell> robot);
  /// All of it without a robot.
  [[nodiscard]] CellSet reachable_ground(std::optional<Cell> robot);
  /// Takes from the expanders what is blocked, or behind what is blocked.
  void leave_out_blocked(std::optional<Cell> robot);
  void plan_certified(std::optional<Cell> goal, std::optional<Cell> robot);
  void plan_band(std::optional<Cell> goal, std::optional<Cell> robot);
  /// Members of S_t that border a cell outside that may be safe.
  [[nodiscard]] CellSet borders(const CellSet& reachable) const;
  /// By rules.selection.
  void select(const Intervals& by,
              std::optional<Cell> goal,
              std::optional<Cell> robot,
              const std::vector<std::int64_t>& depth2);
  /// Members of G_t that are reachable and not measured yet, by the upper bounds given. The disc of
  /// a measurement is part of S_t: to measure there again makes it grow by the noise at most.
  [[nodiscard]] CellSet unmeasured_expanders(const Intervals& by,
                                             const CellSet& reachable,
                                             const std::vector<std::int64_t>& depth2) const;
  void consider(const std::vector<std::size_t>& cells);
  void choose(std::vector<std::size_t> candidates,
              const Intervals& by,
              std::optional<Cell> goal,
              Ties ties);
  void derive_anew();
  [[nodiscard]] double steepest_to(const Measurement& measurement) const;

  Grid grid_;
  Rules rules_;
  std::unique_ptr<SeparableGp> model_;
  std::vector<Measurement> measurements_;
  CellSet seeds_;
  CellSet blocked_;  // empty: none
  CellSet safe_;
  Footprint footprint_{Body{}};
  CellSet standing_;
  double field_variance_ = kUnbounded;
  CellSet expanders_;
  CellSet considered_;
  CellSet measured_;  // `certified` and `band`
  Intervals intervals_;
  Intervals cone_;  // `certified`: of measurements and the Lipschitz constant alone
  std::size_t empty_ = 0;
  int contradictions_ = 0;
  Plan plan_;
};

}  // namespace tcert::terrain
