#include "cli/commands/calibrate.hpp"

#include <algorithm>
#include <string>

#include "cli/commands/run_command.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCalibrateText =
    R"(Calibrate what a robot feels with.

rays: bends beside measured clearances become the calibrations of a bundle's rays, with a lower bound
that holds on a new day.

Usage: tcert calibrate rays PAIRS [options]

'tcert calibrate rays --help' lists the options.

Example:
  tcert calibrate rays pairs.csv --bundle logs --output calibration/

Cost: a second for a million pairs.
)";

/// Of a calibration without a kind that is known.
struct CalibrateRequest {
  std::string kind;
  std::vector<std::string> given;
};

OptionTable options_of(CalibrateRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, {"rays"}});
  return table;
}

int run_calibrate(Arguments arguments) {
  if (std::ranges::find(arguments, "rays") != arguments.end()) {
    return calibrate_rays_command(arguments);
  }
  CalibrateRequest request;
  Manner manner;
  if (parse(kCalibrateText, options_of(request), manner, arguments)) {
    throw UsageError("unknown kind '" + request.kind + "', expected rays" +
                     did_you_mean(request.kind, {"rays"}));
  }
  return exit_done;
}

std::vector<CommandForm> calibrate_forms() {
  return {form_for<CalibrateRequest>(kCalibrateText), calibrate_rays_form()};
}

}  // namespace

const Command kCalibrate = {"calibrate",
                            "calibrate rays: a curve with a bound that holds on a new day",
                            run_calibrate,
                            calibrate_forms};

}  // namespace tcert::cli
