#pragma once
/// \file
/// A tree of results: which there are, what each was made from, and whether they belong together.

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <table/data_table.hpp>
#include <vector>

#include "reports/manifest_read.hpp"
#include "reports/table.hpp"

namespace tcert {

enum class ResultKind {
  corpus,        ///< simulate
  certificates,  ///< certify: features.csv, certificates.csv, series/, edges/
  h1,
  h2,
  replays,  ///< replay: replay.csv
  h3,
  ablation,  ///< ablate: cells.csv
  sweep,     ///< sweep: cells.csv
  gate,
  driven,     ///< drive
  h3_driven,  ///< hypotheses h3 --driven, of worlds of its own
  assurance,  ///< assure monitor, of a bundle of its own
  guards,     ///< calibrate guards, likewise
  other,
};

[[nodiscard]] std::string_view to_string(ResultKind kind) noexcept;

/// A folder with a manifest.json.
struct Result {
  ResultKind kind = ResultKind::other;
  std::filesystem::path folder;
  std::string name;  ///< Of the folder, relative to the tree; "." if it is the tree itself.
  WrittenResult manifest;
};

/// There is nothing to read, or not what a manifest lists. The message names the file.
class MissingResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results of different inputs. The message names both and the input that differs.
class MixedResults : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Results {
  std::filesystem::path folder;
  std::vector<Result> all;  ///< By name.
  std::optional<SyntheticLabel> synthetic;

  /// The first of its kind; null if there is none.
  [[nodiscard]] const Result* find(ResultKind kind) const noexcept;
};

/// The folder itself if it has a manifest.json, and each folder in it that has one; what a killed
/// process has left half written (is_temporary_name) is none.
/// \throws MissingResult if there is none.
[[nodiscard]] Results read_results(const std::filesystem::path& folder);

/// Every result but those of the micro-study and of driven arms, which have bundles of their own,
/// must have been made from the same logs with the same parameters; and what one was made from that
/// another has written must be that very file. \throws MixedResults.
void require_same_inputs(const Results& results);

/// A table that a command wrote as <name>.json into the result's folder; empty if it is not there.
/// \throws MissingResult if it is there and cannot be read.
[[nodiscard]] std::optional<Table> result_table(const Result& result, std::string_view name);

/// A CSV file of the result, its label line skipped; empty if it is not there. \throws
/// MissingResult.
[[nodiscard]] std::optional<table::DataTable> result_data(const Result& result,
                                                          std::string_view file);

}  // namespace tcert
