#include "analysis/trials/parameter_entry.hpp"

namespace tcert {
namespace {

void add_clearance(ParameterEntries& table) {
  using P = CertificateParameters;
  const auto group = &ParameterSet::certificate;
  constexpr Stage kStage = Stage::certify;
  table.push_back(word({"clearance",
                        "",
                        kStage,
                        "How the two sides make a free width; radial is for a body that turns on "
                        "the spot, swept takes T_t from the area really swept."},
                       group,
                       &P::clearance,
                       {"width", "radial", "swept"}));
  table.push_back(
      word({"curvature",
            "",
            kStage,
            "How the turn radius is read; contact needs walls that are felt often, none "
            "is the ablation without curvature."},
           group,
           &P::curvature,
           {"path", "contact", "contact_literal", "none"}));
  table.push_back(word({"unknown",
                        "",
                        kStage,
                        "What unprobed space is taken for; free is the optimistic ablation and not "
                        "sound."},
                       group,
                       &P::unknown,
                       {"occupied", "free"}));
  table.push_back(number({"side_angle_rad",
                          "rad",
                          kStage,
                          "How far from square to the heading a ray may point and still feel a "
                          "side; raise it for a robot with few rays."},
                         group,
                         &P::side_angle_rad,
                         kNotNegative));
  table.push_back(number({"side_window_m",
                          "m",
                          kStage,
                          "Travel over which a side keeps its smallest reading; 0 stands for the "
                          "body width, shorter misses gates."},
                         group,
                         &P::side_window_m,
                         kNotNegative));
  table.push_back(number({"travel_deadband_m",
                          "m",
                          kStage,
                          "Displacement below which travel does not count; raise it to 5 sigma of "
                          "the pose noise."},
                         group,
                         &P::travel_deadband_m,
                         kAboveZero));
}

void add_swept_area(ParameterEntries& table) {
  using P = CertificateParameters;
  const auto group = &ParameterSet::certificate;
  constexpr Stage kStage = Stage::certify;
  table.push_back(
      number({"swept_cell_m",
              "m",
              kStage,
              "Cell of the swept area (clearance=swept); smaller credits more and costs "
              "more."},
             group,
             &P::swept_cell_m,
             kAboveZero));
  table.push_back(number({"least_obstacle_m",
                          "m",
                          kStage,
                          "No obstacle is narrower: two readings of a ray further apart sweep "
                          "nothing; lower it where there are posts or cables."},
                         group,
                         &P::least_obstacle_m,
                         kNotNegative));
  table.push_back(
      number({"sharpest_corner_rad",
              "rad",
              kStage,
              "At depth h behind its tip every obstacle is at least 2 h tan(half of "
              "this) wide, up to least_obstacle_m: what reaches in between two readings; "
              "lower it where there are wedges, rounded or not."},
             group,
             &P::sharpest_corner_rad,
             {0.0, 1.5707963267948966, false}));
  table.push_back(number({"swept_lag_m",
                          "m",
                          kStage,
                          "Travel after which the clearance of a place is settled; at least body "
                          "and reach."},
                         group,
                         &P::swept_lag_m,
                         kAboveZero));
  table.push_back(number({"max_swept_cells",
                          "",
                          kStage,
                          "Cells that the swept area has room for; raise it when the capacity flag "
                          "appears."},
                         group,
                         &P::max_swept_cells,
                         {2, double{1U << 28U}, true}));
}

void add_curvature(ParameterEntries& table) {
  using P = CertificateParameters;
  const auto group = &ParameterSet::certificate;
  constexpr Stage kStage = Stage::certify;
  table.push_back(number({"curvature_window_m",
                          "m",
                          kStage,
                          "Path over which the heading change is taken; raise it when the yaw is "
                          "noisy, but long windows hide alternating arcs."},
                         group,
                         &P::curvature_window_m,
                         kAboveZero));
  table.push_back(number({"curvature_min_travel_m",
                          "m",
                          kStage,
                          "Path below which nothing is said about the radius; keep it above a few "
                          "dead bands."},
                         group,
                         &P::curvature_min_travel_m,
                         kAboveZero));
  table.push_back(number({"min_curvature_per_m",
                          "1/m",
                          kStage,
                          "Curvature that counts as straight; scale it when lengths are not in "
                          "metres."},
                         group,
                         &P::min_curvature_per_m,
                         kAboveZero));
  table.push_back(number({"contact_spacing_m",
                          "m",
                          kStage,
                          "Distance between the contacts of a triple; raise it when contact points "
                          "are noisy."},
                         group,
                         &P::contact_spacing_m,
                         kAboveZero));
  table.push_back(number({"contact_literal_spacing_m",
                          "m",
                          kStage,
                          "The same for curvature=contact_literal, as the paper prints it."},
                         group,
                         &P::contact_literal_spacing_m,
                         kAboveZero));
  table.push_back(number({"contact_window_m",
                          "m",
                          kStage,
                          "Travel within which a triple of contacts lies; raise it when walls are "
                          "touched seldom."},
                         group,
                         &P::contact_window_m,
                         kAboveZero));
  table.push_back(number({"contact_flatness",
                          "",
                          kStage,
                          "Least height of a triangle of contacts relative to its longest side; "
                          "raise it when straight walls read as bends."},
                         group,
                         &P::contact_flatness,
                         kNotNegative));
  table.push_back(number(
      {"sigma_contact_m", "m", kStage, "Noise of a contact point; set it to what the sensor has."},
      group,
      &P::sigma_contact_m,
      kNotNegative));
  table.push_back(number({"contact_on_n",
                          "N",
                          kStage,
                          "Tip force from which a ray is in contact; set it above the noise of the "
                          "force sensor."},
                         group,
                         &P::contact_on_n,
                         kAboveZero));
  table.push_back(number(
      {"contact_off_n", "N", kStage, "Tip force below which a contact ends; at most contact_on_n."},
      group,
      &P::contact_off_n,
      kAboveZero));
  table.push_back(number({"contact_slack_m",
                          "m",
                          kStage,
                          "Without a force sensor, clearance short of the reach that counts as "
                          "contact; raise it for noisy rays."},
                         group,
                         &P::contact_slack_m,
                         kNotNegative));
}

void add_graph(ParameterEntries& table) {
  using P = CertificateParameters;
  const auto group = &ParameterSet::certificate;
  constexpr Stage kStage = Stage::certify;
  table.push_back(number({"edge_length_m",
                          "m",
                          kStage,
                          "Path between two nodes of the corridor graph; raise it for large places "
                          "or sparse logs."},
                         group,
                         &P::edge_length_m,
                         kAboveZero));
  table.push_back(number({"merge_radius_m",
                          "m",
                          kStage,
                          "How near to a known node the path must cross its line to close there; "
                          "raise it for odometry that drifts."},
                         group,
                         &P::merge_radius_m,
                         kAboveZero));
  table.push_back(number({"merge_angle_rad",
                          "rad",
                          kStage,
                          "By how much headings may differ at a closing; raise it for a yaw that "
                          "drifts."},
                         group,
                         &P::merge_angle_rad,
                         kAboveZero));
  table.push_back(number({"reversal_m",
                          "m",
                          kStage,
                          "Way back from the furthest point that counts as a reversal; keep it "
                          "above the pose noise."},
                         group,
                         &P::reversal_m,
                         kAboveZero));
  table.push_back(
      number({"max_step_m",
              "m",
              kStage,
              "Distance between two ticks that breaks the path; raise it for fast robots "
              "or sparse logs."},
             group,
             &P::max_step_m,
             kAboveZero));
  constexpr Range kCapacity{2, double{1U << 28U}, true};
  table.push_back(number({"max_nodes",
                          "",
                          kStage,
                          "Nodes that the graph has room for; raise it when the capacity flag "
                          "appears."},
                         group,
                         &P::max_nodes,
                         kCapacity));
  table.push_back(number({"max_edges",
                          "",
                          kStage,
                          "Edges that the graph has room for; raise it when the capacity flag "
                          "appears."},
                         group,
                         &P::max_edges,
                         kCapacity));
}

void add_memory(ParameterEntries& table) {
  using P = CertificateParameters;
  const auto group = &ParameterSet::certificate;
  constexpr Stage kStage = Stage::certify;
  table.push_back(number({"memory_weight_m",
                          "m",
                          kStage,
                          "Weight lambda_M of the contact memory in the corridor value; 0 is the "
                          "ablation without memory."},
                         group,
                         &P::memory_weight_m,
                         kNotNegative));
  table.push_back(number({"memory_cell_m",
                          "m",
                          kStage,
                          "Cell of the memory field; a third of the body width or less."},
                         group,
                         &P::memory_cell_m,
                         kAboveZero));
  table.push_back(
      number({"memory_gain",
              "",
              kStage,
              "What one tick of contact at the force cap adds; lower it for sensors that "
              "touch all the time."},
             group,
             &P::memory_gain,
             {0.0, 1.0, true}));
  table.push_back(
      number({"force_cap_n",
              "N",
              kStage,
              "Force from which a contact counts in full; set it to the sensor's range."},
             group,
             &P::force_cap_n,
             kAboveZero));
  table.push_back(number({"memory_sigma_m",
                          "m",
                          kStage,
                          "Reach of a contact in the memory field; raise it for uncertain contact "
                          "points."},
                         group,
                         &P::memory_sigma_m,
                         kAboveZero));
  table.push_back(number({"memory_half_life_s",
                          "s",
                          kStage,
                          "Time in which a memory halves; raise it for places that do not change."},
                         group,
                         &P::memory_half_life_s,
                         kAboveZero));
  table.push_back(number({"max_memory_cells",
                          "",
                          kStage,
                          "Cells that the memory has room for; raise it for runs over hundreds of "
                          "metres: when they are used up the faintest give way."},
                         group,
                         &P::max_memory_cells,
                         {2, double{1U << 28U}, true}));
}

}  // namespace

void add_certificate_entries(ParameterEntries& table) {
  add_clearance(table);
  add_swept_area(table);
  add_curvature(table);
  add_graph(table);
  add_memory(table);
}

}  // namespace tcert
