#pragma once
/// \file
/// Margins of passes by the swept area. A place is known only once the front has moved on, so the
/// margin of a pass is looked at again, and rises, while the robot is near.

#include <cstdint>
#include <tcert/corridor_graph.hpp>
#include <tcert/pending_pass.hpp>
#include <tcert/swept_area.hpp>
#include <vector>

namespace tcert {

/// The path as steps: straight pieces from tick to tick, and from a crossing to the node that the
/// path closes at. A pass is a run of steps; its margin is the smallest of theirs. A step counts
/// for nothing until it is looked at, at the latest when it is older than the lag: then its margin
/// is settled. The constructor takes all memory; when there is no room the oldest are settled
/// early.
class SweptMargins {
 public:
  SweptMargins(const Robot& robot, const Course& course, const CertificateParameters& parameters);

  /// The first tick of a trial, whose area has been begun with `area()`.
  void begin(const Evidence& first) noexcept;
  /// The first tick after a break of the path.
  void break_path(const Evidence& now) noexcept;
  /// The step from the last tick to this one.
  void add(const Evidence& now) noexcept;
  /// The step between where the path crosses a node's line and the node.
  void add_join(Point crossing, const Evidence& now, const Node& node) noexcept;

  /// The next pass begins with the tick's step and its joins.
  void start_pass() noexcept;

  /// Ends the pass: it is followed until its steps are settled. Its margin as known so far.
  Certified finish_pass(EdgeEnd from, EdgeEnd to) noexcept;

  /// Looks at all open steps as things stand now. O(open steps).
  void look_at_open_steps() noexcept;

  /// Calls raise(from, to, certified) for each finished pass whose margin has risen.
  template <typename Raise>
  void hand_out(Raise raise) noexcept {
    for (std::size_t i = 0; i < pass_count_; ++i) {
      FollowedPass& pass = followed(i);
      const Certified now = margin_of(pass);
      if (now.margin_m > pass.margin_m) {
        pass.margin_m = now.margin_m;
        raise(pass.from, pass.to, now);
      }
    }
    forget_settled_passes();
  }

  [[nodiscard]] SweptArea& area() noexcept { return area_; }
  [[nodiscard]] const SweptArea& area() const noexcept { return area_; }

 private:
  struct Step {
    Point from;
    Point to;
    double spread_m = 0.0;  // the path stays this near to from-to
    double travel_m = 0.0;
    double turn_slack_m = 0.0;
    SweptClearance clearance;
    bool seen = false;
    bool open = true;  // its nearest cell may yet be swept
    Certified certified;
  };
  struct FollowedPass {
    EdgeEnd from;
    EdgeEnd to;
    std::uint64_t first = 0;  // numbers of its steps
    std::uint64_t last = 0;
    double margin_m = 0.0;  // as last handed out
    Certified settled;      // of its steps that are settled
  };
  [[nodiscard]] Step& step(std::uint64_t number) noexcept { return steps_[number % steps_.size()]; }
  [[nodiscard]] FollowedPass& followed(std::size_t i) noexcept {
    return passes_[(first_pass_ + i) % passes_.size()];
  }
  void push(const Step& next) noexcept;
  void settle_oldest() noexcept;
  void look_at(Step& step) noexcept;
  void forget_settled_passes() noexcept;
  [[nodiscard]] Certified margin_of(const FollowedPass& pass) noexcept;

  SweptArea area_;
  double needed_width_m_;
  double lag_m_;
  double least_step_m_;
  std::vector<Step> steps_;  // rings
  std::uint64_t first_step_ = 0;
  std::uint64_t next_step_ = 0;
  std::uint64_t tick_step_ = 0;  // the newest step that leads to a tick
  std::vector<FollowedPass> passes_;
  std::size_t first_pass_ = 0;
  std::size_t pass_count_ = 0;
  FollowedPass current_;
  Point last_;
};

}  // namespace tcert
