#include "analysis/study/trials/parameter_entry.hpp"

namespace tcert::study {
namespace {

/// The robot's numbers, each of which may take the place of the bundle's.
void add_robot(ParameterEntries& table) {
#define TCERT_NUMBER(type, member, key, value, unit, bounds, text) \
  table.push_back(override_of(                                     \
      NumberField{#key, unit, bounds, text}, Stage::certify, &RobotOverrides::member));
#include <tcert/parameters/robot.def>
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
  add_fields(table, Stage::control, &ParameterSet::route);
  add_fields(table, Stage::control, &ParameterSet::replay);
  return table;
}

}  // namespace

std::span<const ParameterInfo> parameter_table() {
  static const ParameterEntries table = make_table();
  return table;
}

}  // namespace tcert::study
