#include "cli/runs/verify/rerun.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "cli/runs/assure_monitor.hpp"
#include "cli/runs/assure_perturb.hpp"
#include "cli/runs/batch/trial_features.hpp"
#include "cli/runs/calibrate_guards.hpp"
#include "cli/runs/calibrate_rays.hpp"
#include "cli/runs/calibrate_tracking.hpp"
#include "cli/runs/certify.hpp"
#include "cli/runs/drive.hpp"
#include "cli/runs/experiment/cells.hpp"
#include "cli/runs/explore.hpp"
#include "cli/runs/federate.hpp"
#include "cli/runs/figures/figures.hpp"
#include "cli/runs/fit/fit.hpp"
#include "cli/runs/gate.hpp"
#include "cli/runs/hypotheses.hpp"
#include "cli/runs/import_barn.hpp"
#include "cli/runs/replay.hpp"
#include "cli/runs/report/report.hpp"
#include "cli/runs/simulate.hpp"
#include "cli/runs/simulate_terrain.hpp"
#include "cli/runs/study/study.hpp"
#include "cli/runs/world.hpp"

namespace tcert::cli {
namespace {

using Words = std::span<const ManifestArgument>;

/// A run of cells keeps nothing of what it makes for somebody else.
template <class Request>
void keep_nothing(Request& request) {
  if constexpr (std::is_base_of_v<CellsRequest, Request>) {
    request.no_cache = true;
  }
}

template <class Request, ExitCode (*run)(const Request&, Progress&)>
Rerun again(const std::string& command, Words words, const FindInput& find) {
  Request request;
  read_request(command, options_of(request), words, find);
  return [request](const std::string& output, Progress& progress) {
    Request now = request;
    require_values(options_of(now));
    now.output.path = output;
    keep_nothing(now);
    static_cast<void>(run(now, progress));
  };
}

struct Entry {
  std::string_view command;
  std::string_view first_word;  ///< Of what belongs to the command: "terrain"; or empty.
  bool is_argument;             ///< The first word is one of its request's arguments too.
  Rerun (*again)(const std::string& command, Words words, const FindInput& find);
};

constexpr std::array kEntries{
    Entry{"simulate", "terrain", false, again<SimulateTerrainRequest, simulate_terrain>},
    Entry{"simulate", "", false, again<SimulateRequest, simulate>},
    Entry{"drive", "", false, again<DriveRequest, drive>},
    Entry{"batch", "simulate", false, again<SimulateRequest, simulated_features>},
    Entry{"batch", "drive", false, again<DriveRequest, driven_features>},
    Entry{"import", "barn", true, again<ImportBarnRequest, import_barn>},
    Entry{"calibrate", "rays", true, again<CalibrateRaysRequest, calibrate_rays>},
    Entry{"calibrate", "tracking", true, again<CalibrateTrackingRequest, calibrate_tracking>},
    Entry{"calibrate", "guards", true, again<CalibrateGuardsRequest, calibrate_guards>},
    Entry{"assure", "monitor", true, again<AssureMonitorRequest, assure_monitor>},
    Entry{"assure", "perturb", true, again<AssurePerturbRequest, assure_perturb>},
    Entry{"certify", "", false, again<CertifyRequest, certify>},
    Entry{"replay", "", false, again<ReplayRequest, replay>},
    Entry{"ablate", "", false, again<AblateRequest, ablate>},
    Entry{"sweep", "", false, again<SweepRequest, sweep>},
    Entry{"gate", "", false, again<GateRequest, gate>},
    Entry{"study", "", false, again<StudyRequest, study>},
    Entry{"hypotheses", "", false, again<HypothesesRequest, hypotheses>},
    Entry{"fit", "", false, again<FitRequest, fit>},
    Entry{"world", "", false, again<WorldRequest, world>},
    Entry{"federate", "", false, again<FederateRequest, federate>},
    Entry{"explore", "", false, again<ExploreRequest, explore>},
    Entry{"figures", "", false, again<FiguresRequest, figures>},
    Entry{"report", "", false, again<ReportRequest, report>}};

}  // namespace

Rerun rerun_of(const WrittenResult& manifest, const FindInput& find) {
  Words words = *manifest.arguments;
  std::string name = manifest.command;
  std::string first_word;
  if (const auto space = name.find(' '); space != std::string::npos) {
    first_word = name.substr(space + 1);
    name.resize(space);
  } else if (!words.empty() && !words.front().is_input) {
    first_word = words.front().text;
  }
  const auto* const entry = std::ranges::find_if(kEntries, [&](const Entry& one) {
    return one.command == name && (one.first_word.empty() || one.first_word == first_word);
  });
  if (entry == kEntries.end()) {
    throw NotReproducible("its manifest names the command '" + name +
                          "', which makes no result that can be made again");
  }
  if (!entry->first_word.empty() && !entry->is_argument && !words.empty() &&
      !words.front().is_input && words.front().text == entry->first_word) {
    words = words.subspan(1);
  }
  try {
    return entry->again(name, words, find);
  } catch (const NotReproducible& error) {
    throw NotReproducible(std::string("its manifest: ") + error.what());
  }
}

}  // namespace tcert::cli
