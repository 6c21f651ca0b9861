#include "cli/runs/calibrate_rays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "analysis/study/rays/ray_calibration.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/bundle.hpp"
#include "datasets/ray_pairs.hpp"
#include "reports/ray_calibration_report.hpp"

namespace tcert::cli {
namespace {

void require_there(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw NoInput("there is nothing at '" + path + "'");
  }
}

/// A calibration is of a bundle, not in it.
void require_outside(const std::filesystem::path& bundle, const std::filesystem::path& output) {
  const auto outer = std::filesystem::weakly_canonical(bundle);
  const auto inner = std::filesystem::weakly_canonical(output);
  if (std::ranges::mismatch(outer, inner).in1 == outer.end()) {
    throw UsageError("the output " + output.string() + " lies in the bundle " + bundle.string() +
                     "; name a folder outside of it");
  }
}

RayPairs pairs_of(const CalibrateRaysRequest& request, Progress& progress) {
  require_there(request.pairs);
  table::CsvOptions csv;
  csv.decimal_comma = request.decimal_comma;
  RayPairsResult read = read_ray_pairs(std::filesystem::path(request.pairs), csv);
  progress.say(read.diagnostics);
  if (!read.pairs) {
    throw BadData("'" + request.pairs + "' cannot be used as pairs of bend and clearance");
  }
  return std::move(*read.pairs);
}

std::optional<BundleInfo> info_of_bundle(const std::string& bundle, Progress& progress) {
  if (bundle.empty()) {
    return std::nullopt;
  }
  require_there(bundle);
  BundleInfoResult read = read_bundle_info(bundle);
  progress.say(read.diagnostics);
  if (!read.info) {
    throw BadData("'" + bundle + "' has no bundle.json that can be used");
  }
  return std::move(read.info);
}

/// The rays of the bundle that the pairs are of; a clearance counts up to the reach, for no bend
/// can state more.
void fit_to_reach(const BundleInfo& info, const std::string& bundle, RayPairs& pairs) {
  std::vector<std::string> bending;
  for (const Ray& ray : info.robot.rays) {
    if (ray.kind == RayKind::bend) {
      bending.push_back(ray.name);
    }
  }
  std::vector<double> reach;
  for (const std::string& name : pairs.rays) {
    const auto found = std::ranges::find(info.robot.rays, name, &Ray::name);
    if (found == info.robot.rays.end() || found->kind != RayKind::bend) {
      throw BadData(fmt::format(
          "'{}' has no ray '{}' of kind bend{}", bundle, name, did_you_mean(name, bending)));
    }
    reach.push_back(found->reach_m);
  }
  for (RayPair& pair : pairs.pairs) {
    pair.clearance_m = std::min(pair.clearance_m, reach[pair.ray]);
  }
}

/// The rays with their new calibrations.
CalibratedRays calibrated(const std::optional<BundleInfo>& bundle,
                          const study::RayCalibration& made,
                          Progress& progress) {
  CalibratedRays result;
  result.of_a_bundle = bundle.has_value();
  if (!bundle) {
    for (std::size_t i = 0; i < made.rays.size(); ++i) {
      Ray ray;
      ray.name = made.rays[i];
      ray.kind = RayKind::bend;
      ray.calibration = made.usable[i];
      result.rays.push_back(ray);
    }
    return result;
  }
  result.rays = bundle->robot.rays;
  for (Ray& ray : result.rays) {
    const auto found = std::ranges::find(made.rays, ray.name);
    if (found != made.rays.end()) {
      ray.calibration = made.usable[static_cast<std::size_t>(found - made.rays.begin())];
    } else if (ray.kind == RayKind::bend) {
      progress.say("note: no pair of the ray '" + ray.name + "': it keeps its calibration");
    }
  }
  return result;
}

std::optional<SyntheticLabel> label_of_pairs(const RayPairs& pairs,
                                             const std::optional<BundleInfo>& bundle) {
  if (pairs.synthetic) {
    return SyntheticLabel{pairs.seed};
  }
  return bundle && bundle->synthetic ? std::optional(SyntheticLabel{bundle->seed}) : std::nullopt;
}

/// What was read of the bundle: its bundle.json, or the archive that holds it.
ManifestFile input_of(const std::string& bundle) {
  const std::filesystem::path json = std::filesystem::path(bundle) / "bundle.json";
  std::error_code error;
  const bool is_plain = std::filesystem::is_regular_file(json, error);
  const std::filesystem::path read = is_plain ? json : std::filesystem::path(bundle);
  return {name_of(read), digest_path(read)};
}

}  // namespace

OptionTable options_of(CalibrateRaysRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, {"rays"}});
  table.argument({"PAIRS", &request.pairs, true, OptionRole::input});
  table.add_input("bundle",
                  request.bundle,
                  "BUNDLE",
                  "whose rays they are: clearances count up to their reach, and the list 'rays' "
                  "comes out whole; nothing in it is changed");
  table
      .add("alpha",
           request.alpha,
           "P",
           "a new day has a clearance below the bound with this probability at most")
      .within(1e-4, 0.5);
  table.add("no-bound", request.no_bound, "the curves alone, fitted to all days");
  table.add("knots", request.knots, "N", "of a curve, at most").within(2, 1000);
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode calibrate_rays(const CalibrateRaysRequest& request, Progress& progress) {
  if (request.no_bound && is_given(request.given, "alpha")) {
    throw UsageError("--alpha does nothing with --no-bound");
  }
  if (!request.bundle.empty() && !request.output.path.empty()) {
    require_apart(request.bundle, request.output.path);
    require_outside(request.bundle, request.output.path);
  }
  ReportOutput output(request.output, "calibrate");
  RayPairs pairs = pairs_of(request, progress);
  const std::optional<BundleInfo> bundle = info_of_bundle(request.bundle, progress);
  if (bundle) {
    fit_to_reach(*bundle, request.bundle, pairs);
  }
  study::RayCalibrationOptions options;
  options.bound = !request.no_bound;
  options.alpha = request.alpha;
  options.most_knots = static_cast<std::size_t>(request.knots);
  options.seed = static_cast<std::uint64_t>(request.seed);
  const study::RayCalibrationResult made = study::calibrate_rays(pairs, options);
  if (!made.calibration) {
    throw BadData(made.problem);
  }
  FitReport report = ray_calibration_report(
      *made.calibration, options, calibrated(bundle, *made.calibration, progress));
  report.synthetic = label_of_pairs(pairs, bundle);
  Manifest manifest;
  manifest.command = "calibrate";
  record(written(request), manifest);
  manifest.seed = options.seed;
  manifest.synthetic = report.synthetic;
  manifest.inputs = {{name_of(request.pairs), digest_file(request.pairs)}};
  if (bundle) {
    manifest.inputs.push_back(input_of(request.bundle));
  }
  output.deliver(std::move(report), request.table, std::move(manifest), progress);
  say_one_file(request.output, progress);
  return exit_done;
}

}  // namespace tcert::cli
