#include "reports/results/results.hpp"

#include <fmt/format.h>
#include <table/read_data_table.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <system_error>
#include <table/bytes.hpp>
#include <table/path_name.hpp>

#include "reports/manifest_checks.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 14> kWords = {"corpus",
                                                     "certificates",
                                                     "h1",
                                                     "h2",
                                                     "replays",
                                                     "h3",
                                                     "ablation",
                                                     "sweep",
                                                     "gate",
                                                     "driven",
                                                     "h3_driven",
                                                     "assurance",
                                                     "guards",
                                                     "other"};

ResultKind kind_of(const WrittenResult& written) {
  if (written.command == "hypotheses" && written.arguments) {
    for (const ManifestArgument& argument : *written.arguments) {
      if (argument.text == "h1") {
        return ResultKind::h1;
      }
      if (argument.text == "h2") {
        return ResultKind::h2;
      }
      if (argument.text == "h3") {
        const bool is_driven = std::ranges::any_of(
            *written.arguments, [](const ManifestArgument& one) { return one.text == "--driven"; });
        return is_driven ? ResultKind::h3_driven : ResultKind::h3;
      }
    }
  }
  const auto says = [&](std::string_view word) {
    return written.arguments &&
           std::ranges::any_of(*written.arguments,
                               [&](const ManifestArgument& one) { return one.text == word; });
  };
  if (written.command == "assure" && says("monitor")) {
    return ResultKind::assurance;
  }
  if (written.command == "calibrate" && says("guards")) {
    return ResultKind::guards;
  }
  static const std::map<std::string_view, ResultKind> kinds = {
      {"simulate", ResultKind::corpus},
      {"certify", ResultKind::certificates},
      {"replay", ResultKind::replays},
      {"ablate", ResultKind::ablation},
      {"sweep", ResultKind::sweep},
      {"gate", ResultKind::gate},
      {"drive", ResultKind::driven}};
  const auto kind = kinds.find(written.command);
  return kind == kinds.end() ? ResultKind::other : kind->second;
}

void add_result(const fs::path& folder, std::string name, Results& results) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "manifest.json", error)) {
    return;
  }
  std::optional<WrittenResult> written = read_manifest(folder / "manifest.json");
  if (!written) {
    throw MissingResult(why_no_manifest(folder / "manifest.json"));
  }
  if (written->synthetic && !results.synthetic) {
    results.synthetic = written->synthetic;
  }
  const ResultKind kind = kind_of(*written);
  results.all.push_back({kind, folder, std::move(name), std::move(*written)});
}

/// Made from the logs of the study, not from those of the micro-study or from nothing.
bool of_the_study(const Result& result) {
  return result.kind != ResultKind::corpus && result.kind != ResultKind::gate &&
         result.kind != ResultKind::driven && result.kind != ResultKind::h3_driven &&
         result.kind != ResultKind::assurance && result.kind != ResultKind::guards &&
         result.kind != ResultKind::other;
}

bool is_output(const std::string& input) {
  return input == "features.csv" || input == "replay.csv";
}

/// The first input or parameter of both that is not the same.
std::optional<std::string> difference_of(const Result& a, const Result& b) {
  for (const ManifestFile& first : a.manifest.inputs) {
    for (const ManifestFile& second : b.manifest.inputs) {
      if (first.path == second.path && first.digest.sha256 != second.digest.sha256) {
        return "'" + first.path + "' is " + first.digest.sha256.substr(0, 12) + " there and " +
               second.digest.sha256.substr(0, 12) + " here";
      }
    }
  }
  for (const auto& [key, value] : a.manifest.parameters) {
    for (const auto& [other_key, other] : b.manifest.parameters) {
      if (key == other_key && value != other) {
        return fmt::format("the parameter {} is '{}' there and '{}' here", key, value, other);
      }
    }
  }
  return std::nullopt;
}

/// An input of `reader` that `writer` wrote under that name with other bytes.
std::optional<std::string> stale_input(const Result& writer, const Result& reader) {
  for (const ManifestFile& input : reader.manifest.inputs) {
    for (const ManifestFile& output : writer.manifest.outputs) {
      if (is_output(input.path) && input.path == output.path &&
          input.digest.sha256 != output.digest.sha256) {
        return "its input '" + input.path + "' is not the one that '" + writer.name + "' holds";
      }
    }
  }
  return std::nullopt;
}

/// The result whose file of that name a hypothesis read, if the tree has one of the kind.
bool feeds(const Result& writer, const Result& reader) {
  return (writer.kind == ResultKind::certificates &&
          (reader.kind == ResultKind::h1 || reader.kind == ResultKind::h2)) ||
         (writer.kind == ResultKind::replays && reader.kind == ResultKind::h3);
}

table::Bytes bytes_of_file(const fs::path& path) {
  table::BytesResult file = table::read_raw_file(path);
  if (!file.bytes) {
    throw MissingResult("cannot read '" + path.string() + "': " + file.problem);
  }
  return std::move(*file.bytes);
}

}  // namespace

std::string_view to_string(ResultKind kind) noexcept {
  return kWords[static_cast<std::size_t>(kind)];
}

const Result* Results::find(ResultKind kind) const noexcept {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Result& one) { return one.kind == kind; });
  return found == all.end() ? nullptr : &*found;
}

Results read_results(const fs::path& folder) {
  Results results;
  results.folder = folder;
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw MissingResult("'" + folder.string() + "' is not a folder");
  }
  add_result(folder, ".", results);
  if (results.all.empty()) {
    std::vector<fs::path> parts;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_directory() && !table::is_temporary_name(entry.path().filename().native())) {
        parts.push_back(entry.path());
      }
    }
    std::sort(parts.begin(), parts.end());
    for (const fs::path& part : parts) {
      add_result(part, part.filename().string(), results);
    }
  }
  if (results.all.empty()) {
    throw MissingResult("'" + folder.string() +
                        "' holds no results: neither it nor a folder in it has a manifest.json, as "
                        "'tcert certify' and the other commands write it with --output DIR, and "
                        "'tcert reproduce --output DIR' all of them");
  }
  return results;
}

void require_same_inputs(const Results& results) {
  for (const Result& reader : results.all) {
    for (const Result& writer : results.all) {
      std::optional<std::string> difference;
      if (feeds(writer, reader)) {
        difference = stale_input(writer, reader);
      }
      if (!difference && &writer < &reader && of_the_study(writer) && of_the_study(reader)) {
        difference = difference_of(writer, reader);
      }
      if (difference) {
        throw MixedResults("results of different inputs: '" + writer.name + "' and '" +
                           reader.name + "': " + *difference +
                           "; make one of them again, or put them into folders of their own");
      }
    }
  }
}

std::optional<Table> result_table(const Result& result, std::string_view name) {
  const fs::path path = result.folder / (std::string(name) + ".json");
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return std::nullopt;
  }
  try {
    return table_from_json(bytes_of_file(path).view());
  } catch (const std::invalid_argument& cause) {
    throw MissingResult("'" + path.string() + "': " + cause.what());
  }
}

std::optional<table::DataTable> result_data(const Result& result, std::string_view file) {
  const fs::path path = result.folder / file;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return std::nullopt;
  }
  table::DataTableResult read = table::read_data_table(path);
  if (!read.table) {
    throw MissingResult(read.diagnostics.empty() ? "cannot read '" + path.string() + "'"
                                                 : table::to_string(read.diagnostics.front()));
  }
  return std::move(read.table);
}

}  // namespace tcert
