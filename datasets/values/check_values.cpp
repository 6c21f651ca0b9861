#include "datasets/values/check_values.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "datasets/ray_names.hpp"
#include "datasets/travelled_way.hpp"
#include "datasets/values/check_course.hpp"
#include "datasets/values/check_duration.hpp"
#include "datasets/values/check_footing.hpp"
#include "datasets/values/check_rays.hpp"
#include "datasets/values/check_speed.hpp"
#include "datasets/values/check_units.hpp"
#include "datasets/values/check_yaw.hpp"
#include "datasets/values/ray_scan.hpp"

namespace tcert {
namespace {

/// One finding a kind: the first, with the names of all rays.
std::vector<ValueFinding> joined(std::vector<ValueFinding> findings) {
  std::vector<ValueFinding> out;
  std::map<ValueKind, std::vector<std::string>> columns;
  for (ValueFinding& finding : findings) {
    std::vector<std::string>& names = columns[finding.kind];
    names.push_back(finding.diagnostic.column);
    if (names.size() == 1) {
      out.push_back(std::move(finding));
    }
  }
  for (ValueFinding& finding : out) {
    finding.diagnostic.column = joined_names(columns[finding.kind]);
  }
  return out;
}

}  // namespace

std::vector<ValueFinding> check_values(const BundleInfo& info,
                                       const TrialRow& trial,
                                       const CertificateParameters& parameters,
                                       const TickTable& ticks) {
  std::vector<ValueFinding> found = check_course(info.course, trial.success, ticks);
  const auto add = [&found](std::vector<ValueFinding> more) {
    std::ranges::move(more, std::back_inserter(found));
  };
  const std::vector<double> way_m = travelled_way(ticks);
  const TrialScan scan = scan_rays(ticks, way_m);
  add(check_units(info.robot, parameters, ticks, scan));
  for (const std::optional<ValueFinding>& one :
       {check_yaw(ticks), check_speed(ticks), check_duration(trial, ticks), check_footing(ticks)}) {
    if (one) {
      found.push_back(*one);
    }
  }
  add(check_rays(info.robot, parameters, ticks, scan));
  found = joined(std::move(found));
  for (ValueFinding& finding : found) {
    finding.diagnostic.file = "logs/" + trial.trial_id;
  }
  return found;
}

void ValueSummary::add(const std::vector<ValueFinding>& findings) {
  for (const ValueFinding& finding : findings) {
    ++kinds_.try_emplace(finding.kind, Kind{finding.diagnostic, 0}).first->second.trials;
  }
}

std::vector<std::string> ValueSummary::lines() const {
  std::vector<std::string> lines;
  for (const auto& [kind, found] : kinds_) {
    lines.push_back(table::to_string(found.first));
    if (found.trials > 1) {
      lines.back() += " (and " + std::to_string(found.trials - 1) + " more trial" +
                      (found.trials > 2 ? "s)" : ")");
    }
  }
  return lines;
}

}  // namespace tcert
