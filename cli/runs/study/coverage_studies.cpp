#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/coverage/equivalence_study.hpp"
#include "analysis/study/coverage/gate_study.hpp"
#include "analysis/study/coverage/ray_study.hpp"
#include "cli/runs/study/studies.hpp"
#include "cli/runs/watched_stages.hpp"
#include "reports/study/coverage_report.hpp"

namespace tcert::cli {
namespace {

/// Of each scenario its own stream of random numbers.
constexpr std::uint32_t kCoverageStream = 10;
constexpr std::uint32_t kEquivalenceStream = 200;
constexpr std::uint32_t kRayStream = 400;

std::size_t number(const std::optional<std::int64_t>& told, std::size_t usual) {
  return told ? static_cast<std::size_t>(*told) : usual;
}

}  // namespace

FitReport coverage_study(const StudyRequest& request, Progress& progress) {
  study::coverage::Options options;
  options.data_sets = number(request.data_sets, options.data_sets);
  options.replicates = number(request.replicates, options.replicates);
  options.seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::coverage_scenarios();
  std::vector<study::coverage::Coverage> rows;
  Stage stage(progress, "scenarios", scenarios.size());
  std::uint32_t stream = kCoverageStream;
  for (const study::coverage::Scenario& scenario : scenarios) {
    const auto some = study::coverage::run(scenario, stream++, options);
    rows.insert(rows.end(), some.begin(), some.end());
    stage.advance();
  }
  return coverage_report(rows, options);
}

FitReport equivalence_study(const StudyRequest& request, Progress& progress) {
  const std::size_t data_sets = number(request.data_sets, 2000);
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::equivalence_scenarios();
  std::vector<ScenarioRates> rows;
  Stage stage(progress, "scenarios", scenarios.size());
  std::uint32_t stream = kEquivalenceStream;
  for (const study::coverage::LightingScenario& scenario : scenarios) {
    rows.emplace_back(scenario,
                      study::coverage::run_equivalence(scenario, stream++, data_sets, seed));
    stage.advance();
  }
  return equivalence_report(rows, data_sets, seed);
}

FitReport gate_coverage_study(const StudyRequest& request, Progress& progress) {
  study::coverage::GateOptions options;
  options.studies = number(request.data_sets, options.studies);
  options.replicates = number(request.replicates, options.replicates);
  options.first_seed = static_cast<std::uint64_t>(request.seed);
  WatchedStages stages(progress);
  return gate_coverage_report(study::coverage::run_gates(options, stages.watch()), options);
}

FitReport ray_study(const StudyRequest& request, Progress& progress) {
  constexpr std::size_t kNewDays = 100;
  const std::size_t calibrations = number(request.data_sets, 10000);
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::ray_scenarios();
  std::vector<study::coverage::RayCoverage> rows;
  Stage stage(progress, "scenarios", scenarios.size());
  std::uint32_t stream = kRayStream;
  for (const study::coverage::RayScenario& scenario : scenarios) {
    rows.push_back(study::coverage::run_rays(scenario, stream++, calibrations, kNewDays, seed));
    stage.advance();
  }
  return ray_coverage_report(rows, seed);
}

}  // namespace tcert::cli
