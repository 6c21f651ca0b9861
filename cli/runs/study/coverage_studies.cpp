#include <memory>

#include "analysis/study/coverage/advance_study.hpp"
#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/coverage/equivalence_study.hpp"
#include "analysis/study/coverage/gate_study.hpp"
#include "analysis/study/coverage/hypotheses_study.hpp"
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
constexpr std::uint32_t kHypothesesStream = 700;
constexpr std::uint32_t kAdvanceStream = 800;

constexpr std::size_t kNewDays = 100;

std::size_t number(const std::optional<std::int64_t>& told, std::size_t usual) {
  return told ? static_cast<std::size_t>(*told) : usual;
}

/// Data sets of each scenario, two streams a scenario; the rows of all scenarios are reported.
template <class Set, class Scenario, class Make, class Rows, class Report>
StudyItems studies_of(const std::vector<Scenario>& scenarios,
                      const study::coverage::Options& options,
                      std::uint32_t first_stream,
                      Make make,
                      Rows rows_of,
                      Report report) {
  const auto made = std::make_shared<std::vector<std::vector<Set>>>(scenarios.size());
  StudyItems items;
  std::uint32_t stream = first_stream;
  for (const Scenario& scenario : scenarios) {
    items.sets.push_back(independent_items("data sets of " + scenario.name,
                                           options.data_sets,
                                           [scenario, options, stream, make](std::uint64_t set) {
                                             return table::row_text(
                                                 make(scenario, stream, options, set));
                                           }));
    stream += 2;
  }
  items.take = [made](std::size_t scenario, std::uint64_t /*set*/, std::string_view line) {
    made->at(scenario).push_back(table::from_row<Set>(line));
  };
  items.report = [made, scenarios, options, rows_of, report] {
    auto rows = rows_of(scenarios.front(), made->front());
    for (std::size_t i = 1; i < scenarios.size(); ++i) {
      const auto some = rows_of(scenarios[i], (*made)[i]);
      rows.insert(rows.end(), some.begin(), some.end());
    }
    return report(rows, options);
  };
  return items;
}

study::coverage::Options options_of_data_sets(const StudyRequest& request,
                                              std::size_t data_sets,
                                              std::size_t replicates) {
  study::coverage::Options options;
  options.data_sets = number(request.data_sets, data_sets);
  options.replicates = number(request.replicates, replicates);
  options.seed = static_cast<std::uint64_t>(request.seed);
  return options;
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
  const study::coverage::Options options = options_of_data_sets(request, 1000, 399);
  return studies_of<study::coverage::TruthTests>(
      study::coverage::coverage_scenarios(),
      options,
      kInferenceStream,
      study::coverage::truth_tests_of,
      [level = options.level](const auto& scenario, const auto& sets) {
        return study::coverage::inference_rates(scenario, sets, level);
      },
      inference_report);
}

StudyItems hypotheses_study(const StudyRequest& request, Progress& /*progress*/) {
  return studies_of<study::coverage::Misses>(study::coverage::coverage_scenarios(),
                                             options_of_data_sets(request, 400, 299),
                                             kHypothesesStream,
                                             study::coverage::misses_of,
                                             study::coverage::miss_rates,
                                             hypotheses_report);
}

StudyItems advance_study(const StudyRequest& request, Progress& /*progress*/) {
  return studies_of<study::coverage::AdvanceMisses>(study::coverage::advance_scenarios(),
                                                    options_of_data_sets(request, 1000, 999),
                                                    kAdvanceStream,
                                                    study::coverage::advance_misses_of,
                                                    study::coverage::advance_rates,
                                                    advance_report);
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
