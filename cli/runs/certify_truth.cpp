#include "cli/runs/certify_truth.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <table/csv_write.hpp>

#include "analysis/study/truth/truth.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/thread_limit.hpp"
#include "datasets/bundle_files.hpp"
#include "datasets/worlds/world_problems.hpp"

namespace tcert::cli {
namespace {

struct Answer {
  std::string lower;
  std::string upper;
  std::string problem;
};

std::string cell_of(double value) {
  std::string text;
  if (std::isfinite(value)) {
    table::append_number(text, value);
  }
  return text;
}

Answer answer(const std::string& text, const Robot& robot, const study::TruthOptions& options) {
  try {
    const World world = world_from_json(text);
    const std::vector<std::string> problems = world_problems(world);
    if (!problems.empty()) {
      return {"", "", "expected " + problems.front()};
    }
    const study::Truth truth = study::truth_of(world, robot, options);
    return {cell_of(truth.lower_m), cell_of(truth.upper_m), ""};
  } catch (const WorldFormatError& error) {
    return {"", "", error.what()};
  } catch (const std::invalid_argument& error) {
    return {"", "", error.what()};
  }
}

/// Name of the world's file without its ending.
std::string world_of(const TrialRow& row, const std::vector<std::string>& extra_columns) {
  const auto column = std::find(extra_columns.begin(), extra_columns.end(), "world");
  return column == extra_columns.end()
             ? row.trial_id
             : row.extra[static_cast<std::size_t>(column - extra_columns.begin())];
}

}  // namespace

void add_truth(OpenedBundle& opened, std::int64_t threads, Progress& progress) {
  Bundle& bundle = opened.bundle;
  const BundleFiles files(bundle.path);
  std::vector<std::string> texts;               // distinct
  std::vector<std::string> names;               // of the first world of that text
  std::map<std::string, std::size_t> index;     // text -> its place
  std::map<std::string, std::size_t> of_trial;  // trial id -> its text
  std::size_t missing = 0;
  for (const std::size_t i : opened.trials) {
    const TrialRow& row = bundle.trials[i];
    const std::string name = "worlds/" + world_of(row, bundle.extra_columns) + ".json";
    const table::BytesResult bytes = files.contains(name) ? files.read(name) : table::BytesResult{};
    if (!bytes.bytes) {
      ++missing;
      continue;
    }
    const auto [place, fresh] = index.emplace(bytes.bytes->view(), texts.size());
    if (fresh) {
      texts.emplace_back(bytes.bytes->view());
      names.push_back(name);
    }
    of_trial[row.trial_id] = place->second;
  }
  study::TruthOptions options;
  options.convention = opened.parameters.certificate.clearance == ClearanceReading::radial
                           ? study::SlackConvention::radial
                           : study::SlackConvention::width;
  const Robot robot = effective_robot(bundle.info, opened.parameters);
  const ThreadLimit limit(threads);
  std::vector<Answer> answers(texts.size());
  Stage stage(progress, "truth", texts.size());
  std::mutex counting;
  tbb::parallel_for(std::size_t{0}, texts.size(), [&](std::size_t i) {
    answers[i] = answer(texts[i], robot, options);
    const std::lock_guard lock(counting);
    stage.advance();
  });
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!answers[i].problem.empty()) {
      progress.say(names[i] + ": " + answers[i].problem);
    }
  }
  if (missing > 0) {
    progress.say(
        fmt::format("{} of {} trials have no world in worlds/", missing, opened.trials.size()));
  }
  bundle.extra_columns.insert(bundle.extra_columns.end(), {"truth_lower_m", "truth_upper_m"});
  for (TrialRow& row : bundle.trials) {
    const auto place = of_trial.find(row.trial_id);
    const Answer none;
    const Answer& found = place == of_trial.end() ? none : answers[place->second];
    row.extra.insert(row.extra.end(), {found.lower, found.upper});
  }
}

void say_issued_failures(const std::vector<study::TrialRecord>& trials, Progress& progress) {
  std::size_t failures = 0;
  std::size_t issued = 0;
  for (const study::TrialRecord& trial : trials) {
    const TrialRow& row = trial.row.trial;
    if (row.success.value_or(true)) {
      continue;
    }
    ++failures;
    if (!trial.row.features.issued.value_or(false)) {
      continue;
    }
    ++issued;
    const auto shown = [](const std::string& cell) { return cell.empty() ? "unknown" : cell; };
    const std::size_t n = row.extra.size();
    progress.say(fmt::format("issued, but failed: {}, T_t {:.4f} m, truth from {} to {}",
                             row.trial_id,
                             trial.row.features.certificate_m.value_or(std::nan("")),
                             shown(row.extra[n - 2]),
                             shown(row.extra[n - 1])));
  }
  progress.say(fmt::format("Certificates issued in failed trials: {} of {}.", issued, failures));
}

}  // namespace tcert::cli
