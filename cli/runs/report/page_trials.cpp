#include "cli/runs/report/page_trials.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <system_error>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <table/path_name.hpp>
#include <utility>

#include "analysis/study/trials/study.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/report/courses.hpp"
#include "reports/html/trial_block.hpp"
#include "reports/html/trial_list.hpp"
#include "reports/witness_json.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTicksOfAStudy = 240'000;
constexpr std::size_t kMostTicks = 400;
constexpr std::size_t kFewestTicks = 60;
constexpr double kMostParts = 1000.0;  // of a piece of a path
constexpr std::size_t kMostWitnessCells = std::size_t{1} << 27U;

bool holds(const Result& result, const char* file) {
  std::error_code error;
  return fs::is_regular_file(result.folder / file, error);
}

const Result* certified(const Results& results) {
  const auto found = std::find_if(results.all.begin(), results.all.end(), [](const Result& one) {
    return holds(one, "certificates.csv") || holds(one, "features.csv");
  });
  return found == results.all.end() ? nullptr : &*found;
}

std::optional<table::TextTable> table_of(const Result& result,
                                         const char* file,
                                         const std::vector<std::string>& required) {
  if (!holds(result, file)) {
    return std::nullopt;
  }
  table::TextTableResult read = table::read_text_table(result.folder / file, required);
  if (!read.table) {
    throw BadData(read.diagnostics.empty() ? "cannot read '" + (result.folder / file).string() + "'"
                                           : table::to_string(read.diagnostics.front()));
  }
  return std::move(read.table);
}

std::optional<Point> point_of(const TrialList& trials,
                              std::size_t trial,
                              std::string_view x,
                              std::string_view y) {
  const Point point{trials.number(trial, x), trials.number(trial, y)};
  return std::isfinite(point.x_m) && std::isfinite(point.y_m) ? std::optional(point) : std::nullopt;
}

/// The straight edges of edges/<trial>.csv; none if there is no such file.
std::vector<MapEdge> edges_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return {};
  }
  table::NumberOptions options;
  options.time_column.clear();
  for (const char* name : {"a_x_m", "a_y_m", "b_x_m", "b_y_m", "margin_m"}) {
    options.columns.push_back({name, true, true});
  }
  table::CsvOptions csv;
  csv.file = path.string();
  table::BytesResult bytes = table::read_raw_file(path);
  table::DiagnosticGroups problems;
  std::optional<table::NumberTable> table;
  if (bytes.bytes) {
    table = table::read_numbers(*bytes.bytes, csv, options, problems);
  }
  if (!table || problems.has_error()) {
    const std::vector<table::Diagnostic> found = problems.take();
    throw BadData(found.empty() ? "cannot read '" + path.string() + "'"
                                : table::to_string(found.front()));
  }
  std::vector<MapEdge> edges;
  for (std::size_t i = 0; i < table->rows(); ++i) {
    edges.push_back(
        {{table->at(i, 0), table->at(i, 1)}, {table->at(i, 2), table->at(i, 3)}, table->at(i, 4)});
  }
  return edges;
}

/// The path of witness/<trial>.json, 5 cm apart and less in bends; nothing if there is no such
/// file or path.
void add_witness(const fs::path& path, TrialMap& map) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return;
  }
  const table::BytesResult bytes = table::read_raw_file(path);
  if (!bytes.bytes) {
    throw BadData("'" + path.string() + "': " + bytes.problem);
  }
  try {
    const WitnessDocument proof = witness_from_json(bytes.bytes->view(), kMostWitnessCells);
    for (const witness::Piece& piece : proof.path) {
      const double wanted = std::max(std::ceil(witness::chord(piece) / 0.05),
                                     std::ceil(std::abs(piece.turn_rad) / 0.1));
      const double parts = std::clamp(wanted, 1.0, kMostParts);
      for (int k = map.witness.empty() ? 0 : 1; k <= parts; ++k) {
        map.witness.push_back(witness::point_at(piece, k / parts));
      }
    }
    if (!proof.path.empty()) {
      map.witness_bottleneck = proof.stated.bottleneck;
    }
  } catch (const WitnessFormatError& wrong) {
    throw BadData("'" + path.string() + "': " + wrong.what());
  }
}

table::NumberTable series_of(const fs::path& path) {
  table::BytesResult bytes = table::read_raw_file(path);
  if (!bytes.bytes) {
    throw BadData("'" + path.string() + "': " + bytes.problem);
  }
  std::string problem;
  auto series = read_page_series(*bytes.bytes, path.string(), problem);
  if (!series) {
    throw BadData(problem);
  }
  return std::move(*series);
}

/// Worlds as blocks, each once however many trials it has.
class WorldBlocks {
 public:
  explicit WorldBlocks(std::vector<std::string>& lines) : lines_(lines) {}

  std::size_t number_of(std::string block) {
    const auto [at, is_new] = numbers_.emplace(std::move(block), lines_.size());
    if (is_new) {
      lines_.push_back(at->first);
    }
    return at->second;
  }

 private:
  std::vector<std::string>& lines_;
  std::map<std::string, std::size_t> numbers_;
};

}  // namespace

std::size_t ticks_shown(std::size_t trials) noexcept {
  return std::clamp(kTicksOfAStudy / std::max<std::size_t>(trials, 1), kFewestTicks, kMostTicks);
}

std::size_t add_trials(const Results& results,
                       const TrialPageOptions& options,
                       Progress& progress,
                       PageData& page,
                       std::vector<std::string>& left_out) {
  const Result* result = certified(results);
  if (result == nullptr) {
    left_out.emplace_back(
        "No list of trials: the results hold no features.csv. 'tcert certify' writes it.");
    return 0;
  }
  const TrialList trials(table_of(*result, "features.csv", {"trial_id"}),
                         table_of(*result, "certificates.csv", {"trial_id"}));
  std::error_code error;
  if (!fs::is_directory(result->folder / "series", error)) {
    left_out.emplace_back(
        "No trial can be opened: the results were written without series (--no-series).");
    page.trials = trial_list_block(trials, {});
    return trials.size();
  }
  const Courses courses(results, *result, options.bundle);
  if (!courses.missing().empty()) {
    left_out.push_back(courses.missing());
  }
  if (!fs::is_directory(result->folder / "edges", error)) {
    left_out.emplace_back("No corridor graph on the maps: the results hold no folder 'edges'.");
  }
  const std::size_t limit = options.ticks > 0 ? options.ticks : ticks_shown(trials.size());
  std::vector<Sparkline> sparks(trials.size());
  WorldBlocks worlds(page.worlds);
  Stage stage(progress, "packing trials", trials.size());
  study::in_order(trials.size(), options.threads, [&](std::size_t i) -> std::function<bool()> {
    if (!table::is_file_name(trials.id(i))) {
      throw BadData("'" + result->name + "': the trial_id '" + table::shortened(trials.id(i)) +
                    "' is not " + std::string(table::kFileNameRule));
    }
    const std::string file = trials.id(i) + ".csv";
    const table::NumberTable series = series_of(result->folder / "series" / file);
    TrialMap map;
    map.edges = edges_of(result->folder / "edges" / file);
    add_witness(result->folder / "witness" / (trials.id(i) + ".json"), map);
    map.bottleneck = point_of(trials, i, "bottleneck_x_m", "bottleneck_y_m");
    std::optional<std::string> world = courses.block(trials.id(i));
    map.felt = !world || !courses.has_walls(trials.id(i));
    map.note =
        map.felt ? "The walls are not known here: dots show how far the rays proved the sides free."
                 : "";
    sparks[i] = sparkline(series);
    std::string block = trial_block(series, map, trials.facts(i), limit);
    return [&, block = std::move(block), world = std::move(world)]() mutable {
      stage.advance();
      const std::string number = world ? std::to_string(worlds.number_of(std::move(*world))) : "";
      page.series.push_back(number + ' ' + block);
      return true;
    };
  });
  page.trials = trial_list_block(trials, sparks);
  return trials.size();
}

}  // namespace tcert::cli
