#include "cli/runs/drive.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kDriveText =
    R"(Drive policies in closed loop through worlds of gates: a bundle whose outcomes come out, while those
of 'simulate' are dealt. Six policies after their published descriptions (no program of theirs is public)
sense what tentacles, odometry, a bumper and, of CB-V, a camera say, and command a body that walls stop.
A speed law or guards may act on a policy in the loop, by the certificate as 'live' computes it.

Gates have one distribution for all policies, tied to no outcome. Every policy meets the same worlds.
Trials that share a world share its noise, so that policies are compared in pairs. Synthetic.

Usage: tcert drive --output DIR [options]

Example:
  tcert drive --output driven
  tcert drive --output paired --policies M3,M3+squash20,M3+clip10,CB-V --worlds 60
  tcert drive --output tight --worlds 20 --policies M1,M3 --drive_gate_margin_m 0.03

Then: tcert certify driven --output results; tcert hypotheses h3 paired --driven

Cost: about 0.05 s a trial and thread.
)";

int run_drive(Arguments arguments) { return run_command(kDriveText, arguments, drive); }

std::vector<CommandForm> drive_forms() { return {form_for<DriveRequest>(kDriveText)}; }

}  // namespace

const Command kDrive = {"drive", "drive policies in closed loop", run_drive, drive_forms};

}  // namespace tcert::cli
