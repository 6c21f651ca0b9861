#include "cli/runs/study/study.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include "cli/runs/report_output.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/study/studies.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {
namespace {

struct Study {
  std::string_view name;
  std::string_view tables;   ///< Blank between.
  std::string_view options;  ///< Beside those that all take; blank between.
  StudyItems (*items)(const StudyRequest& request, Progress& progress);
};

constexpr std::array kStudies{
    Study{"soundness",
          "soundness tightness",
          "worlds hard u-turns driven witness methods readings reading-bound",
          soundness_study},
    Study{"federation", "teams", "worlds", federation_study},
    Study{"coverage", "coverage", "data-sets replicates", coverage_study},
    Study{"inference", "inference", "data-sets replicates", inference_study},
    Study{"equivalence", "equivalence", "data-sets", equivalence_study},
    Study{"hypotheses", "misses", "data-sets replicates", hypotheses_study},
    Study{"advance", "advance_misses", "data-sets replicates", advance_study},
    Study{"gate", "gate_coverage", "data-sets replicates", gate_coverage_study},
    Study{"rays", "ray_coverage", "data-sets", ray_study},
    Study{"null", "null null_corpora", "data-sets", null_study},
    Study{"price", "price", "terrains", price_study},
    Study{"terrain", "terrain_soundness terrain_trust", "terrains", terrain_study}};

/// `study terrain` with a file.
constexpr Study kScenarios{"terrain TERRAIN", "scenarios baselines", "seeds", terrain_study};

constexpr std::int64_t kMostDataSets = 1000000;

constexpr std::array kOfSome{"worlds",
                             "hard",
                             "u-turns",
                             "driven",
                             "witness",
                             "methods",
                             "readings",
                             "reading-bound",
                             "data-sets",
                             "replicates",
                             "terrains",
                             "seeds"};

/// True if `word` is among words with a blank between.
bool lists(std::string_view words, const std::string& word) {
  return (' ' + std::string(words) + ' ').find(' ' + word + ' ') != std::string::npos;
}

const Study& study_of(const StudyRequest& request) {
  const auto* const found = std::ranges::find(kStudies, request.study, &Study::name);
  if (found == kStudies.end()) {
    throw UsageError(
        "unknown study '" + request.study +
        "', expected soundness, federation, coverage, inference, equivalence, hypotheses, advance, "
        "gate, rays, null, price or terrain" +
        did_you_mean(request.study, study_names()));
  }
  const Study& one = request.study == "terrain" && !request.terrain.empty() ? kScenarios : *found;
  for (const char* const option : kOfSome) {
    if (is_given(request.given, option) && !lists(one.options, option)) {
      throw UsageError("--" + std::string(option) + " does nothing to 'study " +
                       std::string(one.name) + "'");
    }
  }
  if (!request.table.empty() && request.table != "summary" && !lists(one.tables, request.table)) {
    throw UsageError("--table: found '" + request.table + "', expected one of summary " +
                     std::string(one.tables));
  }
  if (!request.terrain.empty() && request.study != "terrain") {
    throw UsageError("unexpected argument '" + request.terrain + "'");
  }
  if (request.study == "null" &&
      request.seed > std::numeric_limits<std::int64_t>::max() - kMostDataSets) {
    throw UsageError("--seed: too large for the seeds that follow it");
  }
  return one;
}

}  // namespace

std::vector<std::string> study_names() {
  std::vector<std::string> all;
  all.reserve(kStudies.size());
  for (const Study& one : kStudies) {
    all.emplace_back(one.name);
  }
  return all;
}

OptionTable options_of(StudyRequest& request) {
  OptionTable table(request.given);
  table.argument({"STUDY", &request.study, true, OptionRole::shapes, study_names()});
  table.argument({"TERRAIN", &request.terrain, false, OptionRole::input});
  table.add("worlds", request.worlds, "N", "soundness: random worlds; federation: 2000 of them")
      .within(1, 1e8);
  table
      .add("hard",
           request.hard,
           "N",
           "soundness: worlds with tight ends, slanted gates, staggered jaws, posts, dead ends, "
           "kinks or S-bends; 0 leaves them out")
      .within(0, 1e8);
  table
      .add("u-turns",
           request.u_turns,
           "N",
           "soundness: worlds that ask for a turn by half; 0 leaves them out")
      .within(0, 1e8);
  table
      .add("driven",
           request.driven,
           "N",
           "soundness: gated worlds that a policy drives through in closed loop, wandering as it "
           "does")
      .within(0, 1e8);
  table.add("witness",
            request.witness,
            "soundness: of witnesses in place of the clearance readings; about 0.1 s a world");
  table.add("methods",
            request.methods,
            "LIST",
            "soundness: only these of radial, width, swept, A2, A3, comma between");
  table
      .add("readings",
           request.readings,
           "WORD",
           "soundness: true readings (exact), logged ones (noisy), or both")
      .one_of({"exact", "noisy", "both"});
  table
      .add("reading-bound",
           request.reading_bound_m,
           "M",
           "soundness, with --witness: metres taken off logged readings, in the methods that do")
      .within(0.0, 10.0);
  table
      .add("data-sets",
           request.data_sets,
           "N",
           "coverage, equivalence: 2000; gate: 1000 micro-studies; rays: 10000 calibrations; null: "
           "40 corpora")
      .within(1, 1e6);
  table.add("replicates", request.replicates, "R", "of the bootstrap; coverage: 1999; gate: 999")
      .within(1, 1e6);
  table.add("terrains", request.terrains, "N", "price, terrain: random terrains").within(1, 1e6);
  table.add("seeds", request.seeds, "N", "terrain, with TERRAIN: runs of rules that draw")
      .within(1, 1e4);
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  add_common(table, request);
  table.config_file();
  return table;
}

std::vector<ItemSet> items_of(const StudyRequest& request, Progress& progress) {
  return study_of(request).items(request, progress).sets;
}

ExitCode study(const StudyRequest& request, Progress& progress) {
  return study(request, progress, made_here(progress));
}

ExitCode study(const StudyRequest& request, Progress& progress, const ItemSource& source) {
  const Study& one = study_of(request);
  if (!request.terrain.empty() && !std::filesystem::exists(request.terrain)) {
    throw NoInput("cannot read the terrain '" + request.terrain + "': there is no such file");
  }
  if (!request.terrain.empty() && !request.output.path.empty()) {
    require_apart(request.terrain, request.output.path);
  }
  ReportOutput output(request.output, "study");
  const ThreadLimit limit(request.threads);
  Manifest manifest;
  manifest.command = "study";
  record(written(request), manifest);
  manifest.seed = static_cast<std::uint64_t>(request.seed);
  if (!request.terrain.empty()) {
    manifest.inputs = {{name_of(request.terrain), digest_file(request.terrain)}};
  }
  const StudyItems items = one.items(request, progress);
  source(items.sets, items.take);
  FitReport report;
  try {
    report = items.report();
  } catch (const std::domain_error& error) {
    throw UnfitData(error.what());
  }
  manifest.synthetic = report.synthetic;
  output.deliver(std::move(report), request.table, std::move(manifest), progress);
  say_one_file(request.output, progress);
  return exit_done;
}

}  // namespace tcert::cli
