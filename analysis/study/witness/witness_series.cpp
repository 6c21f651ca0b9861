#include "analysis/study/witness/witness_series.hpp"

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
  for (CertifiedTick& tick : trial.series.ticks) {
    tick.certificate_m = -std::numeric_limits<double>::infinity();
    tick.issued = false;
  }
  Features& features = trial.features;
  features.certificate_falls = 0;
  features.certificate_m = trial.proof->certificate_m();
  features.issued = features.certificate_m.value_or(0.0) > 0.0;
  features.issued_s = std::nullopt;
  features.issued_before_goal = std::nullopt;
  CertifiedTick& last = trial.series.ticks.back();
  last.certificate_m = features.certificate_m.value_or(last.certificate_m);
  last.issued = *features.issued;
  if (last.issued) {
    features.issued_s = features.end_s;
    features.issued_before_goal = false;
    trial.not_issued = std::nullopt;
  } else {
    trial.not_issued = without_witness(trial);
  }
}

}  // namespace tcert::study
