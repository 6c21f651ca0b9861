#include "cli/runs/gate.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kGateText =
    R"(The bottleneck micro-study: is the chance to pass a gate even where the margin is 0?

Fits logit Pr(success) = alpha + beta m to passes through gates about as wide as the body, m the
smallest margin felt in the pass. Prints the slope with Wald and profile intervals; the 50 % point
-alpha / beta with Fieller's, the profile and the bootstrap set, each bounded or named unbounded, and
whether it covers 0; the calibration; and the least certificate before the gate as second predictor.

With --output DIR/ (it ends with /, or is a folder): every table in every format, and the curve. Another
PATH, though it had no ending, is one file of what would be printed, in --format.
json has every number; csv has the table of the 50 % point, or that of --table: gate_slope,
gate_calibration, gate_model, gate_passes, gate_curve.

Usage: tcert gate BUNDLE [options]

Example:
  tcert simulate --micro-study --output gates
  tcert gate gates --output gate/

Cost: a second for 60 passes.
)";

int run_gate(Arguments arguments) { return run_command(kGateText, arguments, gate); }

std::vector<CommandForm> gate_forms() { return {form_for<GateRequest>(kGateText)}; }

}  // namespace

const Command kGate = {
    "gate", "the bottleneck micro-study: the margin of an even chance", run_gate, gate_forms};

}  // namespace tcert::cli
