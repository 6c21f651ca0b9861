#include <memory>

#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/coverage/equivalence_study.hpp"
#include "analysis/study/coverage/gate_study.hpp"
#include "analysis/study/coverage/inference_study.hpp"
#include "analysis/study/coverage/ray_study.hpp"
#include "cli/runs/study/studies.hpp"
#include "reports/study/coverage_report.hpp"

namespace tcert::cli {
namespace {

/// Of each scenario its own stream of random numbers.
constexpr std::uint32_t kCoverageStream = 10;
constexpr std::uint32_t kInferenceStream = 600;
constexpr std::uint32_t kEquivalenceStream = 200;
constexpr std::uint32_t kRayStream = 400;

constexpr std::size_t kNewDays = 100;

std::size_t number(const std::optional<std::int64_t>& told, std::size_t usual) {
  return told ? static_cast<std::size_t>(*told) : usual;
}

}  // namespace

StudyItems coverage_study(const StudyRequest& request, Progress& /*progress*/) {
  study::coverage::Options options;
  options.data_sets = number(request.data_sets, options.data_sets);
  options.replicates = number(request.replicates, options.replicates);
  options.seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::coverage_scenarios();
  const auto tallies = std::make_shared<std::vector<study::coverage::CoverageTally>>();
  StudyItems items;
  std::uint32_t stream = kCoverageStream;
  for (const study::coverage::Scenario& scenario : scenarios) {
    items.sets.push_back(independent_items("data sets of " + scenario.name,
                                           options.data_sets,
                                           [scenario, options, stream](std::uint64_t set) {
                                             return table::row_text(study::coverage::intervals_of(
                                                 scenario, stream, options, set));
                                           }));
    ++stream;
  }
  items.take = [tallies, scenarios](
                   std::size_t scenario, std::uint64_t /*set*/, std::string_view line) {
    while (tallies->size() <=
           scenario) {  // Their truth costs time, which only who tallies waits for.
      tallies->emplace_back(scenarios.at(tallies->size()).name);
    }
    (*tallies)[scenario].add(table::from_row<study::coverage::Intervals>(line));
  };
  items.report = [tallies, options] {
    std::vector<study::coverage::Coverage> rows;
    for (const study::coverage::CoverageTally& tally : *tallies) {
      const auto some = tally.rows();
      rows.insert(rows.end(), some.begin(), some.end());
    }
    return coverage_report(rows, options);
  };
  return items;
}

StudyItems inference_study(const StudyRequest& request, Progress& /*progress*/) {
  using study::coverage::TruthTests;
  study::coverage::Options options;
  options.data_sets = number(request.data_sets, 1000);
  options.replicates = number(request.replicates, 399);
  options.seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::coverage_scenarios();
  const auto made = std::make_shared<std::vector<std::vector<TruthTests>>>(scenarios.size());
  StudyItems items;
  std::uint32_t stream = kInferenceStream;
  for (const study::coverage::Scenario& scenario : scenarios) {
    items.sets.push_back(independent_items("data sets of " + scenario.name,
                                           options.data_sets,
                                           [scenario, options, stream](std::uint64_t set) {
                                             return table::row_text(study::coverage::truth_tests_of(
                                                 scenario, stream, options, set));
                                           }));
    stream += 2;
  }
  items.take = [made](std::size_t scenario, std::uint64_t /*set*/, std::string_view line) {
    made->at(scenario).push_back(table::from_row<TruthTests>(line));
  };
  items.report = [made, scenarios, options] {
    std::vector<study::coverage::InferenceRate> rows;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
      const auto some = study::coverage::inference_rates(scenarios[i], (*made)[i], options.level);
      rows.insert(rows.end(), some.begin(), some.end());
    }
    return inference_report(rows, options);
  };
  return items;
}

StudyItems equivalence_study(const StudyRequest& request, Progress& /*progress*/) {
  const std::size_t data_sets = number(request.data_sets, 2000);
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::equivalence_scenarios();
  const auto tallies =
      std::make_shared<std::vector<study::coverage::EquivalenceTally>>(scenarios.size());
  StudyItems items;
  std::uint32_t stream = kEquivalenceStream;
  for (const study::coverage::LightingScenario& scenario : scenarios) {
    const auto sets =
        std::make_shared<const study::coverage::EquivalenceSets>(scenario, stream++, seed);
    items.sets.push_back(independent_items("data sets", data_sets, [sets](std::uint64_t set) {
      return table::row_text((*sets)(set));
    }));
  }
  items.take = [tallies](std::size_t scenario, std::uint64_t /*set*/, std::string_view line) {
    using Found = std::optional<study::coverage::EquivalenceFound>;
    tallies->at(scenario).add(table::from_row<Found>(line));
  };
  items.report = [tallies, scenarios, data_sets, seed] {
    std::vector<ScenarioRates> rows;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
      rows.emplace_back(scenarios[i], (*tallies)[i].rates());
      rows.back().second.scenario = scenarios[i].name;
    }
    return equivalence_report(rows, data_sets, seed);
  };
  return items;
}

StudyItems gate_coverage_study(const StudyRequest& request, Progress& /*progress*/) {
  study::coverage::GateOptions options;
  options.studies = number(request.data_sets, options.studies);
  options.replicates = number(request.replicates, options.replicates);
  options.first_seed = static_cast<std::uint64_t>(request.seed);
  const auto make = std::make_shared<const study::coverage::GateStudies>(options);
  const auto made = std::make_shared<std::vector<study::coverage::GateStudy>>();
  StudyItems items;
  items.sets.push_back(independent_items("micro-studies", options.studies, [make](std::uint64_t i) {
    return table::row_text((*make)(i));
  }));
  items.take = [made](std::size_t /*set*/, std::uint64_t /*item*/, std::string_view line) {
    made->push_back(table::from_row<study::coverage::GateStudy>(line));
    if (made->back().margin.size() != made->back().success.size()) {
      throw table::RowError("found passes without an outcome");
    }
  };
  items.report = [made, options] {
    return gate_coverage_report(study::coverage::summarise(*made), options);
  };
  return items;
}

StudyItems ray_study(const StudyRequest& request, Progress& /*progress*/) {
  const std::size_t calibrations = number(request.data_sets, 10000);
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const auto scenarios = study::coverage::ray_scenarios();
  const auto made =
      std::make_shared<std::vector<std::vector<study::coverage::RayCalibrated>>>(scenarios.size());
  StudyItems items;
  std::uint32_t stream = kRayStream;
  for (const study::coverage::RayScenario& scenario : scenarios) {
    items.sets.push_back(independent_items("calibrations of " + scenario.name,
                                           calibrations,
                                           [scenario, stream, seed](std::uint64_t i) {
                                             return table::row_text(study::coverage::calibrate_one(
                                                 scenario, stream, kNewDays, seed, i));
                                           }));
    ++stream;
  }
  items.take = [made](std::size_t scenario, std::uint64_t /*item*/, std::string_view line) {
    const auto one = table::from_row<study::coverage::RayCalibrated>(line);
    if (one.covered_days > kNewDays) {
      throw table::RowError("found more days than there are");
    }
    made->at(scenario).push_back(one);
  };
  items.report = [made, scenarios, seed] {
    std::vector<study::coverage::RayCoverage> rows;
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
      if (!(*made)[i].empty()) {  // As of a batch that is not whole.
        rows.push_back(study::coverage::summarise(scenarios[i], kNewDays, (*made)[i]));
      }
    }
    return ray_coverage_report(rows, seed);
  };
  return items;
}

}  // namespace tcert::cli
