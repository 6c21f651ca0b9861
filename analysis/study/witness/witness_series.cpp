#include "analysis/study/witness/witness_series.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "analysis/study/trials/study.hpp"

namespace tcert::study {
namespace {

std::optional<NotIssued> without_witness(const StudiedTrial& trial) {
  if (trial.not_issued && trial.not_issued->reason <= NotIssuedReason::goal_missed) {
    return trial.not_issued;
  }
  if (!trial.proof->witness) {
    return NotIssued{NotIssuedReason::no_witness};
  }
  const witness::Checked& checked = trial.proof->witness->checked;
  return NotIssued{NotIssuedReason::narrow, 0.0, checked.margin_m, checked.bottleneck};
}

}  // namespace

void certify_by_witness(StudiedTrial& trial) {
  if (trial.series.ticks.empty()) {
    return;
  }
  trial.series.bottleneck = std::nullopt;
  double certificate_m = -std::numeric_limits<double>::infinity();
  auto look = trial.looks.begin();
  for (std::size_t i = 0; i < trial.series.ticks.size(); ++i) {
    if (look != trial.looks.end() && look->tick == i) {
      certificate_m = std::max(certificate_m, look->found.checked.margin_m);
      ++look;
    }
    if (i + 1 == trial.series.ticks.size()) {
      certificate_m = std::max(certificate_m, trial.proof->certificate_m().value_or(certificate_m));
    }
    trial.series.ticks[i].certificate_m = certificate_m;
    trial.series.ticks[i].issued = certificate_m > 0.0;
  }
  add_certificate(trial.ticks, trial.series.ticks, trial.features);
  if (*trial.features.issued) {
    trial.not_issued = std::nullopt;
  } else {
    trial.not_issued = without_witness(trial);
  }
}

}  // namespace tcert::study
