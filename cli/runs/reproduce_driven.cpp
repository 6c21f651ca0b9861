#include "cli/runs/reproduce_driven.hpp"

#include <filesystem>
#include <utility>

#include "cli/runs/assure_monitor.hpp"
#include "cli/runs/calibrate_guards.hpp"
#include "cli/runs/certify.hpp"
#include "cli/runs/drive.hpp"
#include "cli/runs/hypotheses.hpp"
#include "cli/runs/reproduce_page.hpp"
#include "cli/runs/reproduce_steps.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

/// Trials of `request`, driven unless they are there.
std::string driven_in(DriveRequest request,
                      const char* part,
                      const ReproduceRequest& of,
                      Progress& progress) {
  request.seed = of.seed;
  request.threads = of.threads;
  request.parameters = of.logs.parameters;
  request.output.path = (fs::path(of.output.path) / part).string();
  if (!is_there(request)) {
    OnlyWords words(progress);
    static_cast<void>(drive(request, words));
  }
  return request.output.path;
}

constexpr const char* kArms =
    "M3,M3+squash5,M3+squash10,M3+squash20,M3+clip5,M3+clip10,M3+clip20,M3+A1,CB-V";
constexpr std::int64_t kPairedWorlds = 20;  // under each of three lightings
constexpr std::int64_t kWatchedWorlds = 20;

}  // namespace

bool drives(const ReproduceRequest& request) {
  return request.bundle.empty() && !request.no_driven;
}

std::vector<std::pair<fs::path, const char*>> driven_parts(const fs::path& output) {
  const fs::path folder = output / "driven";
  return {{folder / "bundle", "drive"},
          {folder / "paired", "drive"},
          {folder / "certificates", "certify"},
          {folder / "h1", "hypotheses"},
          {folder / "h2", "hypotheses"},
          {folder / "h3", "hypotheses"},
          {folder / "watched", "drive"},
          {folder / "assurance", "assure"},
          {folder / "guards", "calibrate"}};
}

ExitCode driven_study(ReproduceRequest request, Progress& progress) {
  request.output.path = (fs::path(request.output.path) / "driven").string();
  Steps steps(request, progress);
  const std::string bundle = driven_in({}, "bundle", request, progress);
  auto certified = steps.of_logs<CertifyRequest>("certificates", bundle);
  certified.no_series = request.no_series;
  steps.require(certify, certified);
  for (const char* const hypothesis : {"h1", "h2"}) {
    auto tested = steps.of<HypothesesRequest>(hypothesis);
    tested.hypothesis = hypothesis;
    tested.features = (steps.at("certificates") / "features.csv").string();
    tested.landmark = landmark_of(open_for(bundle, request.logs, progress, SayDiagnostics::no));
    steps.attempt(hypothesis, "hypotheses", hypotheses, tested);
  }
  DriveRequest arms;
  arms.policies = kArms;
  arms.worlds = kPairedWorlds;
  auto paired =
      steps.of_logs<HypothesesRequest>("h3", driven_in(arms, "paired", request, progress));
  paired.hypothesis = "h3";
  paired.driven = true;
  steps.attempt("h3", "hypotheses", hypotheses, paired);
  DriveRequest watched;
  watched.policies = "M3";
  watched.worlds = kWatchedWorlds;
  watched.truth = true;
  const std::string with_truth = driven_in(watched, "watched", request, progress);
  auto assured = steps.of_logs<AssureMonitorRequest>("assurance", with_truth);
  assured.kind = "monitor";
  assured.risk = true;
  steps.attempt("assurance", "assure", assure_monitor, assured);
  auto guards = steps.of_logs<CalibrateGuardsRequest>("guards", with_truth);
  guards.kind = "guards";
  steps.attempt("guards", "calibrate", calibrate_guards, guards);
  write_page(request, progress);
  return steps.code();
}

}  // namespace tcert::cli
