#include "cli/runs/batch/batch.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kBatchText =
    R"(Do the work of a command in pieces, on any number of machines of one kind, and merge them: the result
is that of the command by itself, byte for byte. plan cuts the work into shards and writes scripts for
Slurm and GNU parallel; work makes one shard; merge makes the result of them, or says which are missing
and what makes them.

Usage: tcert batch plan COMMAND [arguments of the command] --shards N --output PLAN
       tcert batch work PLAN [--shard I/N]
       tcert batch merge PLAN [--partial]

'tcert batch plan --help' and so on tell more.

Example:
  tcert batch plan soundness --worlds 1000000 --hard 0 --u-turns 0 --shards 64 --output soundness
  sh soundness/submit --time=1:00:00
  tcert batch merge soundness

Cost: that of the command, in all; an empty shard 0.02 s, and what the scheduler takes.
)";

constexpr std::string_view kPlanText =
    R"(Plan the work of a command in shards. COMMAND is one of
  study     soundness, federation, coverage, inference, equivalence, gate, rays, null, price, terrain (without a
            file); the word study may be left out: 'batch plan soundness'
  ablate, sweep
  simulate  trials that are made, certified and forgotten: the result is their features.csv, and no
            logs are kept
  drive     the same of driven trials
with its arguments and options. --output is the folder of the plan; --threads is told to the work, and
--cache to nobody. The result of the merge is what the command would write to a folder; of 'simulate' and 'drive' what 'certify' would write
of their bundle.

An item (a world, a data set, a corpus, a cell, a trial) depends on the seed and on its number alone.
Parts know the plan, the program and the arithmetic that they were made with: those of another one are
refused. Processors of one kind compute alike; on others the C library takes other versions of exp and
the like, which may differ in the last bit.

PLAN holds plan.json, README.txt, submit (for Slurm), run_parallel, then parts/ and result/. It must lie
where every machine can read and write it.

Usage: tcert batch plan COMMAND [arguments of the command] --shards N --output PLAN

Example:
  tcert batch plan soundness --worlds 1000000 --hard 0 --u-turns 0 --shards 64 --output soundness
  tcert batch plan sweep corpus --grid memory_weight_m=0,0.05,0.1 --shards 4 --output grid
  tcert batch plan drive --trials 66000 --shards 100 --output driven

Cost: that of reading the inputs once.
)";

constexpr std::string_view kWorkText =
    R"(Make one shard of a plan: its part, or nothing if that is there. A part appears whole or not at all,
and is never written over: a shard that is made twice is harmless.

Usage: tcert batch work PLAN [--shard I/N] [options]

Example:
  tcert batch work soundness --shard 3/64
  parallel tcert batch work soundness --shard {}/64 ::: $(seq 0 63)

Cost: its share of the command's.
)";

constexpr std::string_view kMergeText =
    R"(Make of the parts of a plan what the command makes: in PLAN/result/, or in --output DIR. If a part is
missing, it says which, and the command that makes it, makes nothing, and ends with 3; --partial shows
what there is. A part of another plan, program or arithmetic, or a damaged one, is an error.

Usage: tcert batch merge PLAN [options]

Example:
  tcert batch merge soundness
  tcert batch merge soundness --partial

Cost: reading the parts twice.
)";

struct Kind {
  std::string_view name;
  int (*plan)(std::string_view help, Arguments arguments);
};

template <class Request>
int plan_kind(const char* command, std::string_view help, Arguments arguments) {
  PlanRequest<Request> request;
  Manner manner;
  if (!parse(help, options_of(request), manner, arguments)) {
    return exit_done;
  }
  TerminalProgress progress(manner.quiet);
  return plan_batch<Request>(command, request, progress);
}

constexpr std::array kKinds{Kind{"ablate",
                                 [](std::string_view help, Arguments arguments) {
                                   return plan_kind<AblateRequest>("ablate", help, arguments);
                                 }},
                            Kind{"sweep",
                                 [](std::string_view help, Arguments arguments) {
                                   return plan_kind<SweepRequest>("sweep", help, arguments);
                                 }},
                            Kind{"study",
                                 [](std::string_view help, Arguments arguments) {
                                   return plan_kind<StudyRequest>("study", help, arguments);
                                 }},
                            Kind{"simulate",
                                 [](std::string_view help, Arguments arguments) {
                                   return plan_kind<SimulateRequest>("simulate", help, arguments);
                                 }},
                            Kind{"drive", [](std::string_view help, Arguments arguments) {
                                   return plan_kind<DriveRequest>("drive", help, arguments);
                                 }}};

/// What `batch plan` and `batch` take by themselves.
struct PlanForm {
  std::string command;
  std::optional<std::int64_t> shards;
  OutputPath output;
  std::vector<std::string> given;
};

OptionTable options_of(PlanForm& request) {
  OptionTable table(request.given);
  std::vector<std::string> words = study_names();
  for (const Kind& kind : kKinds) {
    words.emplace_back(kind.name);
  }
  table.argument({"COMMAND", &request.command, true, OptionRole::shapes, words});
  table.add("shards", request.shards, "N", "into how many pieces the work is cut");
  add_common(table, request);
  return table;
}

struct BatchForm {
  std::string step;
  std::vector<std::string> given;
};

OptionTable options_of(BatchForm& request) {
  OptionTable table(request.given);
  table.argument({"STEP", &request.step, true, OptionRole::shapes, {"plan", "work", "merge"}});
  return table;
}

int run_plan(Arguments arguments) {
  if (!arguments.empty()) {
    const std::string& word = arguments.front();
    const auto* const kind = std::ranges::find(kKinds, word, &Kind::name);
    if (kind != kKinds.end()) {
      return kind->plan(kPlanText, arguments.subspan(1));
    }
    const std::vector<std::string> studies = study_names();
    if (std::ranges::find(studies, word) != studies.end()) {
      return plan_kind<StudyRequest>("study", kPlanText, arguments);
    }
  }
  PlanForm request;
  if (!arguments.empty() && !arguments.front().starts_with("-")) {
    throw UsageError(
        "'" + arguments.front() +
        "' cannot be made in pieces, expected study, ablate, sweep, simulate or drive" +
        did_you_mean(arguments.front(), options_of(request).arguments().front().words));
  }
  Manner manner;
  if (parse(kPlanText, options_of(request), manner, arguments)) {
    throw UsageError("the command comes first: 'tcert batch plan COMMAND ...'");
  }
  return exit_done;
}

int run_batch(Arguments arguments) {
  if (!arguments.empty()) {
    const std::string& word = arguments.front();
    if (word == "plan") {
      return run_plan(arguments.subspan(1));
    }
    if (word == "work") {
      return run_command(kWorkText, arguments.subspan(1), work);
    }
    if (word == "merge") {
      return run_command(kMergeText, arguments.subspan(1), merge);
    }
  }
  if (!arguments.empty() && !arguments.front().starts_with("-")) {
    throw UsageError("unknown step '" + arguments.front() + "', expected plan, work or merge" +
                     did_you_mean(arguments.front(), {"plan", "work", "merge"}));
  }
  BatchForm request;
  Manner manner;
  if (parse(kBatchText, options_of(request), manner, arguments)) {
    throw UsageError("the step comes first: 'tcert batch plan|work|merge ...'");
  }
  return exit_done;
}

std::vector<CommandForm> batch_forms() {
  return {form_for<BatchForm>(kBatchText),
          form_for<PlanForm>(kPlanText, "plan"),
          form_for<WorkRequest>(kWorkText, "work"),
          form_for<MergeRequest>(kMergeText, "merge")};
}

}  // namespace

const Command kBatch = {
    "batch", "do the work of a command in pieces, on many machines", run_batch, batch_forms};

}  // namespace tcert::cli
