#include "cli/runs/federate.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kFederateText =
    R"(The certificate over what several robots know together.

Each SUBMAP is a file of a few kilobytes: the corridor graph of a run, or the union of several, as
'certify --submaps' and this command write them; robots may exchange them as they like. Their union
does not depend on order or repetition: of equal edges the larger margin counts. Nodes of different
sources are joined where the body surely passes from the one to the other, by an S-bend that the
robot can drive, its length and the errors of both frames taken off. T_H is the widest way from S to
G over all of that: at most T(E; A) if every edge's margin is a lower bound (those of --witness-edges
are, under the assumptions of a witness; those of 'width' are not for sure), frame errors are bounded
as stated, and all sources mean the same S and G.

Prints T_H, what each source knows alone, and the widest way. With --output DIR/ (it ends with /, or is
a folder): every table in every format, and merged.submap, the union. Another PATH is one file of what
would be printed, in --format. csv has the table of sources, or that of --table: sources, way.

Usage: tcert federate SUBMAP... [options]

Example:
  tcert certify corpus --witness-edges --submaps --output results
  tcert federate results/submaps/*.csv --frame-error-m 0.02 --frame-error-rad 0.01 --output union/
  tcert federate union/merged.submap from_another_robot.csv

Cost: milliseconds for ten submaps; in proportion to the pairs of nodes that lie near each other.
)";

int run_federate(Arguments arguments) { return run_command(kFederateText, arguments, federate); }

std::vector<CommandForm> federate_forms() { return {form_for<FederateRequest>(kFederateText)}; }

}  // namespace

const Command kFederate = {
    "federate", "the certificate over the submaps of several robots", run_federate, federate_forms};

}  // namespace tcert::cli
