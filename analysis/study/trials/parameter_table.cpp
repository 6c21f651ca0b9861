#include <algorithm>
#include <array>
#include <utility>

#include "analysis/study/trials/parameter_entry.hpp"

namespace tcert::study {
namespace {

/// The robot's numbers, each of which may take the place of the bundle's.
void add_robot(ParameterEntries& table) {
#define TCERT_NUMBER(type, member, key, value, unit, bounds, text)   \
  table.push_back(override_of(NumberField{#key, unit, bounds, text}, \
                              Stage::certify,                        \
                              &ParameterSet::robot,                  \
                              &RobotOverrides::member,               \
                              "bundle"));
#include <tcert/parameters/robot.def>
}

/// Of the policies' numbers, those which each policy has a fitted one of may be left at that.
void add_policy(ParameterEntries& table) {
  using Member = std::optional<double> PolicyOverrides::*;
  constexpr std::array<std::pair<std::string_view, Member>, 3> kFitted{
      {{"cruise_mps", &PolicyOverrides::cruise_mps},
       {"caution", &PolicyOverrides::caution},
       {"lookahead_m", &PolicyOverrides::lookahead_m}}};
  policies::visit_fields(policies::PolicyParameters{}, [&](const auto& field, auto member) {
    const auto* const fitted =
        std::ranges::find(kFitted, field.key, [](const auto& one) { return one.first; });
    table.push_back(
        fitted == kFitted.end()
            ? entry_of(field, Stage::drive, &ParameterSet::policy, member)
            : override_of(
                  field, Stage::drive, &ParameterSet::policy_overrides, fitted->second, "fitted"));
  });
}

ParameterEntries make_table() {
  ParameterEntries table;
  add_fields(table, Stage::resample, &ParameterSet::resample);
  add_robot(table);
  add_fields(table, Stage::certify, &ParameterSet::certificate);
  add_fields(table, Stage::witness, &ParameterSet::witness);
  add_fields(table, Stage::features, &ParameterSet::early_window);
  add_fields(table, Stage::control, &ParameterSet::speed_law);
  add_fields(table, Stage::control, &ParameterSet::guards);
  add_fields(table, Stage::control, &ParameterSet::risk);
  add_fields(table, Stage::control, &ParameterSet::fallback);
  add_fields(table, Stage::control, &ParameterSet::route);
  add_fields(table, Stage::control, &ParameterSet::replay);
  add_fields(table, Stage::control, &ParameterSet::unsafe);
  add_fields(table, Stage::drive, &ParameterSet::drive);
  add_policy(table);
  return table;
}

}  // namespace

std::span<const ParameterInfo> parameter_table() {
  static const ParameterEntries table = make_table();
  return table;
}

}  // namespace tcert::study
