#include "analysis/trials/parameter_entry.hpp"

namespace tcert {
namespace {

void add_speed_law(ParameterEntries& table) {
  const auto group = &ParameterSet::speed_law;
  constexpr Stage kStage = Stage::control;
  table.push_back(word({"speed_law",
                        "",
                        kStage,
                        "Law from margin to speed: squash halts without margin (paper 3.5), clip "
                        "goes by the robust margin and never halts (4.4, G1)."},
                       group,
                       &SpeedLaw::kind,
                       {"squash", "clip"}));
  table.push_back(
      number({"min_speed_mps",
              "m/s",
              kStage,
              "Speed of the speed law just above margin 0; set it to the robot's slowest "
              "steady speed."},
             group,
             &SpeedLaw::min_speed_mps,
             kAboveZero));
  table.push_back(number({"max_speed_mps",
                          "m/s",
                          kStage,
                          "Speed of the speed law in the open; set it to the robot's safe speed."},
                         group,
                         &SpeedLaw::max_speed_mps,
                         kAboveZero));
  table.push_back(
      number({"beta_per_m",
              "1/m",
              kStage,
              "How fast the speed law opens up with the margin; the paper has 5, 10 and "
              "20."},
             group,
             &SpeedLaw::beta_per_m,
             kAboveZero));
}

void add_guards(ParameterEntries& table) {
  const auto group = &ParameterSet::guards;
  constexpr Stage kStage = Stage::control;
  table.push_back(word({"guard_mode",
                        "",
                        kStage,
                        "What G2 and G3 do when they trip: act halts forward motion, watch only "
                        "states it; by_law acts under clip and watches under squash."},
                       group,
                       &GuardParameters::mode,
                       {"by_law", "act", "watch"}));
  table.push_back(number({"replan_margin_m",
                          "m",
                          kStage,
                          "Robust margin at which G3 halts and replans; raise it for a robot that "
                          "needs room to back out."},
                         group,
                         &GuardParameters::replan_margin_m,
                         kNotNegative));
  table.push_back(number({"guard_min_force_n",
                          "N",
                          kStage,
                          "Tip force that G2 allows without any margin; set it to what the skin "
                          "bears."},
                         group,
                         &GuardParameters::min_force_n,
                         kAboveZero));
  table.push_back(number({"guard_force_per_m",
                          "N/m",
                          kStage,
                          "Force that G2 allows more per metre of robust margin; 0 makes the limit "
                          "fixed."},
                         group,
                         &GuardParameters::force_per_m,
                         kNotNegative));
  table.push_back(number({"guard_disturbance",
                          "",
                          kStage,
                          "Level of disturbance in the tracking-error table; raise it in wind or "
                          "on a slope."},
                         group,
                         &GuardParameters::disturbance,
                         kNotNegative));
}

void add_route(ParameterEntries& table) {
  const auto group = &ParameterSet::route;
  constexpr Stage kStage = Stage::control;
  table.push_back(number({"route_inflation_m",
                          "m",
                          kStage,
                          "A metre of robust margin M costs 1 + this / M; raise it to go round "
                          "narrow places, 0 takes the shortest way."},
                         group,
                         &RouteParameters::inflation_m,
                         kNotNegative));
  table.push_back(number({"route_unknown_margin_m",
                          "m",
                          kStage,
                          "Margin that unexplored space is costed with; lower it to prefer what is "
                          "known."},
                         group,
                         &RouteParameters::unknown_margin_m,
                         kAboveZero));
  table.push_back(number({"route_block_s",
                          "s",
                          kStage,
                          "How long the way ahead stays blocked after a guard tripped; raise it "
                          "where nothing moves."},
                         group,
                         &RouteParameters::block_s,
                         {0.0, 1e9, false}));
}

void add_replay(ParameterEntries& table) {
  const auto group = &ParameterSet::replay;
  constexpr Stage kStage = Stage::control;
  table.push_back(number({"replay_slow_speed_mps",
                          "m/s",
                          kStage,
                          "Logged speed below which a replay keeps the time and counts no length; "
                          "set it above what pose noise alone shows."},
                         group,
                         &ReplayOptions::slow_speed_mps,
                         kAboveZero));
  table.push_back(number({"replay_slow_window_s",
                          "s",
                          kStage,
                          "Time over which that speed is taken; raise it for noisy poses."},
                         group,
                         &ReplayOptions::slow_window_s,
                         {0.001, 1e9, true}));
  table.push_back(number({"replay_stall_m",
                          "m",
                          kStage,
                          "Path without forward speed that counts as a stall; shorter stretches "
                          "are crept through."},
                         group,
                         &ReplayOptions::stall_m,
                         kAboveZero));
}

}  // namespace

void add_control_entries(ParameterEntries& table) {
  add_speed_law(table);
  add_guards(table);
  add_route(table);
  add_replay(table);
}

}  // namespace tcert
