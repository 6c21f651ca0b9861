#include "cli/runs/federate.hpp"

#include <cmath>
#include <federation/federate.hpp>
#include <federation/submap_text.hpp>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <table/text_file.hpp>
#include <utility>

#include "cli/runs/report_output.hpp"
#include "cli/runs/written_options.hpp"
#include "reports/federation_report.hpp"

namespace tcert::cli {
namespace {

struct Given {
  std::vector<GivenSubmap> files;
  std::vector<ManifestFile> inputs;
  std::vector<federation::Submap> submaps;
};

void add_file(const std::string& path, Given& given) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw NoInput("there is no submap at '" + path + "'");
  }
  const table::BytesResult read = table::read_text_file(path);
  if (!read.bytes) {
    throw BadData("cannot read '" + path + "': " + read.problem);
  }
  const std::string_view text = read.bytes->view();
  federation::ReadSubmap submap = federation::read_submap(text);
  if (!submap.submap) {
    throw BadData(path + ", " + federation::to_string(submap.problem));
  }
  given.files.push_back({path, text.size()});
  given.inputs.push_back({name_of(path), digest_file(path)});
  given.submaps.push_back(std::move(*submap.submap));
}

/// For sources that state none themselves.
void state_errors(const FederateRequest& request, federation::Submap& merged) {
  for (federation::Source& source : merged.sources) {
    if (request.frame_error_m && std::isinf(source.frame_error_m)) {
      source.frame_error_m = *request.frame_error_m;
    }
    if (request.frame_error_rad && std::isinf(source.frame_error_rad)) {
      source.frame_error_rad = *request.frame_error_rad;
    }
  }
}

}  // namespace

OptionTable options_of(FederateRequest& request) {
  OptionTable table(request.given);
  table.argument({"SUBMAP", &request.first, true, OptionRole::input});
  table.rest(request.rest);
  table
      .add("frame-error-m",
           request.frame_error_m,
           "M",
           "how far any place of a source may be off in the frame that all share, for sources that "
           "state nothing; without it they are joined to no other")
      .within(0.0, 1e6);
  table.add("frame-error-rad", request.frame_error_rad, "RAD", "the same of headings; needed too")
      .within(0.0, 4.0);
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  add_common(table, request);
  return table;
}

ExitCode federate(const FederateRequest& request, Progress& progress) {
  Given given;
  std::vector<std::string> paths{request.first};
  paths.insert(paths.end(), request.rest.begin(), request.rest.end());
  for (const std::string& path : paths) {
    if (!request.output.path.empty()) {
      require_apart(path, request.output.path);
    }
  }
  ReportOutput output(request.output, "federate");
  for (const std::string& path : paths) {
    add_file(path, given);
  }
  FitReport report;
  try {
    federation::Submap merged = federation::merge(given.submaps);
    state_errors(request, merged);
    report = federation_report(merged, federation::federate(merged), given.files);
  } catch (const std::logic_error& problem) {
    throw BadData(problem.what());
  }
  Manifest manifest;
  manifest.command = "federate";
  record(written(request), manifest);
  manifest.inputs = std::move(given.inputs);
  manifest.synthetic = report.synthetic;
  output.deliver(std::move(report), request.table, std::move(manifest), progress);
  say_one_file(request.output, progress);
  return exit_done;
}

}  // namespace tcert::cli
