#include "cli/runs/study/study.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kStudyText =
    R"(How often is the tool itself right? Studies on data that are made, so that the truth is known.

STUDY is one of
  soundness    is the certificate at most the truth, in random worlds, and how far below does it end
  federation   is the certificate of 1, 2, 4 and 8 robots together at most the truth, and how soon is
               it issued
  coverage     do the intervals of AUCs and Cs cover the truth, where trials of a day are alike
  inference    do tests of coefficients keep their level with few clusters
  equivalence  how often are lightings found equivalent, or different
  hypotheses   how often what H1 and H2 print misses the truth: within strata, hazard ratios, R2,
               groups, interactions, contrasts
  advance      how often what H3 prints misses it: rates, gains, losses, laws and lightings at once
  gate         do the sets of the 50 % point of the micro-study cover it
  rays         does the bound of a calibration of rays hold on all of a new day as often as its law says
  null         does H1 find nothing where there is nothing to be found
  price        what not knowing the Lipschitz constant costs: random terrains of seven kinds, L told,
               bounded, and not needed
  terrain      what do the rules of exploration hold safe that is not; with TERRAIN, a file like the
               thesis' own (600 x 400 numbers, its first line dropped): the scenarios of the thesis
               under every rule set, and baselines

With --output DIR/ (it ends with /, or is a folder): every table in every format. Another PATH, though
it had no ending, is one file of what would be printed, in --format. csv has the first table, or that
of --table: soundness, tightness; teams; coverage; inference; equivalence; misses; advance_misses;
gate_coverage; ray_coverage; null,
null_corpora; price; terrain_soundness, terrain_trust; scenarios, baselines.

Usage: tcert study STUDY [TERRAIN] [options]

Example:
  tcert study soundness --worlds 1000 --hard 700 --u-turns 100
  tcert study null --data-sets 2 --format csv
  tcert study coverage --data-sets 200 --replicates 499 --output coverage/

Cost in CPU time, as they are: soundness 15 minutes (with --witness more than 3 hours), federation 5, coverage 8, inference 6,
equivalence 10, gate 6, null 5, rays 1, price 8, terrain 40 s, but with TERRAIN an hour or more; in
proportion to --worlds, --hard, --data-sets, --terrains.
)";

int run_study(Arguments arguments) { return run_command(kStudyText, arguments, study); }

std::vector<CommandForm> study_forms() { return {form_for<StudyRequest>(kStudyText)}; }

}  // namespace

const Command kStudy = {"study",
                        "how often the tool itself is right, where the truth is known",
                        run_study,
                        study_forms};

}  // namespace tcert::cli
