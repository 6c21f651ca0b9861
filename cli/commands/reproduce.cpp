#include "cli/runs/reproduce.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kReproduceText =
    R"(From end to end: logs, certificates, features, every hypothesis, every table.

Without a BUNDLE it makes the synthetic corpus in DIR/corpus, and the gate passes of the micro-study
in DIR/gates, unless they are there already. Then it runs the other commands, each into its folder:

  DIR/certificates  tcert certify     DIR/h1       tcert hypotheses h1 on its features.csv
  DIR/replays       tcert replay      DIR/h2       tcert hypotheses h2 likewise
  DIR/ablation      tcert ablate      DIR/h3       tcert hypotheses h3 on replays/replay.csv
  DIR/gate          tcert gate        DIR/sensitivity  tcert sweep --sensitivity, if asked for

  DIR/driven        the same of trials that policies drive in closed loop (tcert drive): bundle,
                    certificates, h1, h2, h3 of arms that drive the same worlds in pairs, and of
                    watched trials what rules and guards are worth

and prints the tables; DIR/report.html (tcert report) shows all of it. A step that the data do not
allow (no lighting, no baseline) is left out and named. What an earlier run left in DIR and this one
does not make is removed; if it was edited, nothing is done. 'tcert verify DIR' makes everything again and compares it.

Usage: tcert reproduce [BUNDLE] --output DIR [options]

Example:
  tcert reproduce --output results
  tcert reproduce my-logs --output results --set body_width_m=0.5

Cost: a minute on two cores, of which --no-driven saves two thirds, and about 400 MB; a minute more with
--sensitivity.
)";

int run_reproduce(Arguments arguments) { return run_command(kReproduceText, arguments, reproduce); }

std::vector<CommandForm> reproduce_forms() { return {form_for<ReproduceRequest>(kReproduceText)}; }

}  // namespace

const Command kReproduce = {"reproduce",
                            "from logs to the tables of the paper, end to end",
                            run_reproduce,
                            reproduce_forms};

}  // namespace tcert::cli
