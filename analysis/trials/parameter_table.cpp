#include "analysis/trials/parameter_entry.hpp"

namespace tcert {
namespace {

void add_resample(ParameterEntries& table) {
  const auto group = &ParameterSet::resample;
  constexpr Stage kStage = Stage::resample;
  table.push_back(number({"tick_s",
                          "s",
                          kStage,
                          "Period of the tick grid; change it for a robot that is not slow enough "
                          "for 10 Hz."},
                         group,
                         &ResampleOptions::tick_s,
                         kAboveZero));
  table.push_back(
      number({"max_hold_s",
              "s",
              kStage,
              "Age of the newest sample beyond which a tick is stale; raise it for logs "
              "with slow streams."},
             group,
             &ResampleOptions::max_hold_s,
             kAboveZero));
  table.push_back(number({"median_samples",
                          "",
                          kStage,
                          "Raw samples under the causal median, odd; raise it against glitches, 1 "
                          "takes the samples as they are."},
                         group,
                         &ResampleOptions::median_samples,
                         {1, 9, true}));
}

void add_robot(ParameterEntries& table) {
  constexpr Stage kStage = Stage::certify;
  table.push_back(override_of({"body_width_m",
                               "m",
                               kStage,
                               "Body width w_B; set it to ask whether a robot of another width "
                               "could have passed."},
                              &RobotOverrides::body_width_m,
                              kAboveZero));
  table.push_back(override_of({"min_turn_radius_m",
                               "m",
                               kStage,
                               "Smallest radius R_min that the robot can drive; set it when the "
                               "bundle's is wrong."},
                              &RobotOverrides::min_turn_radius_m,
                              kNotNegative));
  table.push_back(override_of({"tracking_buffer_m",
                               "m",
                               kStage,
                               "Half-width of the tube in which the robot keeps its path; raise it "
                               "for a robot that tracks badly."},
                              &RobotOverrides::tracking_buffer_m,
                              kNotNegative));
  table.push_back(override_of({"curvature_buffer_per_m",
                               "1/m",
                               kStage,
                               "Curvature by which the driven path may exceed the planned one; "
                               "raise it for a robot that tracks badly."},
                              &RobotOverrides::curvature_buffer_per_m,
                              kNotNegative));
}

void add_early_window(ParameterEntries& table) {
  using E = EarlyWindowOptions;
  const auto group = &ParameterSet::early_window;
  constexpr Stage kStage = Stage::features;
  table.push_back(word({"early_window",
                        "",
                        kStage,
                        "Which window TC_early is taken from; landmark cannot hold the outcome, "
                        "fraction needs the final time and leaks it."},
                       group,
                       &E::kind,
                       {"both", "landmark", "fraction"}));
  table.push_back(number({"early_time_s",
                          "s",
                          kStage,
                          "Length of the time window and the landmark; change it for trials much "
                          "shorter or longer than a minute."},
                         group,
                         &E::time_s,
                         kAboveZero));
  table.push_back(number({"early_distance_m",
                          "m",
                          kStage,
                          "Length of the distance window; change it with the size of the course."},
                         group,
                         &E::distance_m,
                         kAboveZero));
  table.push_back(
      number({"early_distance_cap_s",
              "s",
              kStage,
              "Time at which the distance window ends anyway; without it a stuck robot's "
              "window is its whole trial."},
             group,
             &E::distance_cap_s,
             kAboveZero));
  table.push_back(
      number({"early_min_ticks",
              "",
              kStage,
              "Fresh ticks that a window needs to count; lower it for a longer tick_s."},
             group,
             &E::min_ticks,
             {1, 1e9, true}));
  table.push_back(number({"early_quantile",
                          "",
                          kStage,
                          "Quantile that summarises a window; 0 is its minimum, 0.5 its median."},
                         group,
                         &E::quantile,
                         {0.0, 1.0, true}));
  table.push_back(
      number({"early_fraction", "", kStage, "Share of the trial under early_window=fraction."},
             group,
             &E::fraction,
             {0.0, 1.0, false}));
  table.push_back(
      number({"early_dwell_speed_mps",
              "m/s",
              kStage,
              "Speed below which the robot dwells; set it above the speed that pose noise "
              "alone shows."},
             group,
             &E::dwell_speed_mps,
             kAboveZero));
  table.push_back(number({"early_dwell_window_s",
                          "s",
                          kStage,
                          "Time over which that speed is taken; raise it for noisy poses."},
                         group,
                         &E::dwell_window_s,
                         kAboveZero));
}

ParameterEntries make_table() {
  ParameterEntries table;
  add_resample(table);
  add_robot(table);
  add_certificate_entries(table);
  add_early_window(table);
  add_control_entries(table);
  return table;
}

}  // namespace

std::span<const ParameterInfo> parameter_table() {
  static const ParameterEntries table = make_table();
  return table;
}

}  // namespace tcert
