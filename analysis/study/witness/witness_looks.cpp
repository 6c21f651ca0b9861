#include "analysis/study/witness/witness_looks.hpp"

#include <algorithm>
#include <utility>
#include <witness/checker.hpp>
#include <witness/known_samples.hpp>

namespace tcert::study {

bool is_look(std::size_t tick, const witness::WitnessParameters& parameters) noexcept {
  return parameters.witness_every != 0 && (tick + 1) % parameters.witness_every == 0;
}

Proof prove_so_far(const witness::Samples& felt,
                   std::int64_t time_ns,
                   const Robot& robot,
                   const Course& course,
                   const witness::WitnessParameters& parameters,
                   const CertificateParameters& certificate) {
  const double lost_share = witness::free_space_options(parameters, certificate).strips.lost_share;
  return prove(witness::known_samples(felt, time_ns, robot, lost_share),
               robot,
               course,
               parameters,
               certificate);
}

std::vector<WitnessLook> witness_looks(const witness::Samples& felt,
                                       std::span<const CertifiedTick> series,
                                       const Robot& robot,
                                       const Course& course,
                                       const witness::WitnessParameters& parameters,
                                       const CertificateParameters& certificate) {
  std::vector<WitnessLook> looks;
  for (std::size_t i = 0; i + 1 < series.size(); ++i) {
    if (!is_look(i, parameters)) {
      continue;
    }
    Proof proof = prove_so_far(felt, series[i].time_ns, robot, course, parameters, certificate);
    if (proof.witness) {
      looks.push_back({i, std::move(*proof.witness)});
    }
  }
  return looks;
}

void keep_best(std::vector<WitnessLook>& looks,
               const Robot& robot,
               const Course& course,
               Proof& proof) {
  const auto margin_m = [](const WitnessLook& look) { return look.found.checked.margin_m; };
  const auto best = std::ranges::max_element(looks, {}, margin_m);
  if (best == looks.end()) {
    return;
  }
  const witness::Path& path = best->found.path;
  witness::Checked again = witness::check(path, proof.cells, proof.start, *course.goal, robot);
  if (again.refused.empty() && again.margin_m > proof.certificate_m().value_or(-1e300)) {
    proof.witness = witness::Witness{path, std::move(again)};
    proof.reason.clear();
  }
  std::erase_if(looks, [&](const WitnessLook& look) {
    return !proof.witness || margin_m(look) > proof.witness->checked.margin_m;
  });
}

}  // namespace tcert::study
