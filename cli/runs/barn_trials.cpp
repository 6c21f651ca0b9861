#include "cli/runs/barn_trials.hpp"

#include <filesystem>
#include <table/rename_advice.hpp>
#include <utility>

#include "cli/runs/errors.hpp"
#include "datasets/import/barn_results.hpp"

namespace tcert::cli {
namespace {

void require_barn_file(const std::string& option, const std::string& file) {
  if (file.empty()) {
    throw UsageError("needs --" + option + " FILE");
  }
  if (!std::filesystem::exists(file)) {
    throw NoInput("no table at '" + file + "'");
  }
}

std::string planner_of(const std::string& file, const std::string& told) {
  std::string planner = told.empty() ? planner_of_file(file) : told;
  if (planner.empty()) {
    throw UsageError("'" + file + "' names no planner: --planner NAME says whose trials these are");
  }
  return planner;
}

}  // namespace

BarnTable read_barn_table(const std::string& option, const std::string& file, Progress& progress) {
  require_barn_file(option, file);
  table::TextTableResult result = table::read_text_table(std::filesystem::path(file), {"world"});
  table::drop_rename_advice(result.diagnostics);
  progress.say(result.diagnostics);
  if (!result.table) {
    throw BadData("'" + file + "' cannot be read");
  }
  return {std::move(*result.table), file};
}

BarnTrials read_barn_trials(const std::vector<std::string>& files,
                            const std::string& planner,
                            Progress& progress) {
  for (const std::string& file : files) {
    require_barn_file("trials", file);
  }
  BarnTrials trials;
  bool has_results = false;
  for (const std::string& file : files) {
    const table::BytesResult bytes = table::read_file(file);
    if (!bytes.bytes || !is_barn_results(bytes.bytes->view())) {
      trials.tables.push_back(read_barn_table("trials", file, progress));
      continue;
    }
    has_results = true;
    table::DiagnosticGroups problems;
    trials.tables.push_back(
        {read_barn_results(*bytes.bytes, file, planner_of(file, planner), problems), file});
    trials.has_errors = trials.has_errors || problems.has_error();
    progress.say(problems.take());
  }
  if (!planner.empty() && !has_results) {
    throw UsageError("--planner: the trials are no result text, but tables with a header");
  }
  return trials;
}

}  // namespace tcert::cli
