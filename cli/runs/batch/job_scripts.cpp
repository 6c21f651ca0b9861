#include "cli/runs/batch/job_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tcert::cli {
namespace {

constexpr std::string_view kOne = R"sh(#!/bin/sh
# Makes one shard: sh one 3. Written by 'tcert batch plan', as all scripts here.
exec {program} batch work "$(dirname "$0")" --shard "$1/{shards}" --threads "${{TCERT_THREADS:-1}}"
)sh";

constexpr std::string_view kShards = R"sh(#!/bin/sh
# One shard a task, for submit, which says where the plan is and what is added to the task's number.
#SBATCH --job-name=tcert-{command}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --cpus-per-task=1
exec {program} batch work "${{TCERT_PLAN:?}}" --offset "${{TCERT_OFFSET:-0}}" --threads "${{SLURM_CPUS_PER_TASK:-1}}"
)sh";

constexpr std::string_view kMerge = R"sh(#!/bin/sh
#SBATCH --job-name=tcert-merge
#SBATCH --requeue
#SBATCH --open-mode=append
exec {program} batch merge "${{TCERT_PLAN:?}}"
)sh";

constexpr std::string_view kSubmit = R"sh(#!/bin/sh
# Submits every shard that is not there, as arrays of at most {most} tasks, and the merge for when they
# have ended, well or not: it says what is missing. Arguments go to sbatch: --partition=..., --time=...
set -eu
TCERT_PLAN=$(cd "$(dirname "$0")" && pwd)
export TCERT_PLAN
mkdir -p "$TCERT_PLAN/logs"
logs=$(printf '%s/logs' "$TCERT_PLAN" | sed 's/%/%%/g')
after=
TCERT_OFFSET=0
while [ "$TCERT_OFFSET" -lt {shards} ]; do
  export TCERT_OFFSET
  tasks=
  task=0
  while [ "$task" -lt {most} ] && [ $((TCERT_OFFSET + task)) -lt {shards} ]; do
    part=$(printf '%s/parts/%06d.csv' "$TCERT_PLAN" $((TCERT_OFFSET + task)))
    [ -e "$part" ] || tasks=$tasks,$task
    task=$((task + 1))
  done
  if [ -n "$tasks" ]; then
    job=$(sbatch --parsable --array="${{tasks#,}}" --output="$logs/%A_%a.txt" "$@" "$TCERT_PLAN/shards.sbatch")
    after=$after:${{job%%;*}}
  fi
  TCERT_OFFSET=$((TCERT_OFFSET + {most}))
done
sbatch --parsable ${{after:+--dependency="afterany$after"}} --output="$logs/merge_%j.txt" "$@" "$TCERT_PLAN/merge.sbatch"
)sh";

constexpr std::string_view kParallel = R"sh(#!/bin/sh
# Every shard by GNU parallel, one a core; those that are there are not made again.
# Arguments go to parallel: --jobs 8, --sshlogin ... --workdir .
cd "$(dirname "$0")" || exit
seq 0 {last} | parallel "$@" sh ./one
)sh";

constexpr std::string_view kReadme =
    R"sh({command}, {count} items in {shards} shards. Made by tcert {version}.

With Slurm:          sh submit
With GNU parallel:   sh run_parallel && {program} batch merge .
One shard by itself: sh one 0

The merge writes result/ and says what is missing, if anything. Parts of shards that are done stay: submit
and run_parallel, run again, make what is not there. A task that was killed may leave a hidden file in
parts/, which nobody reads and the merge removes.
)sh";

}  // namespace

std::string quoted(const std::string& word) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+=:@,").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) {
    return word;
  }
  std::string text = "'";
  for (const char c : word) {
    text += c == '\'' ? "'\"'\"'" : std::string(1, c);
  }
  return text + "'";
}

std::vector<std::pair<std::string, std::string>> job_scripts(const Plan& plan,
                                                             const std::string& program) {
  const auto filled = [&](std::string_view text) {
    return fmt::format(fmt::runtime(text),
                       fmt::arg("command", plan.command),
                       fmt::arg("program", quoted(program)),
                       fmt::arg("shards", plan.shards),
                       fmt::arg("last", plan.shards - 1),
                       fmt::arg("most", kMostTasks),
                       fmt::arg("count", plan.count()),
                       fmt::arg("version", plan.version));
  };
  return {{"one", filled(kOne)},
          {"shards.sbatch", filled(kShards)},
          {"merge.sbatch", filled(kMerge)},
          {"submit", filled(kSubmit)},
          {"run_parallel", filled(kParallel)},
          {"README.txt", filled(kReadme)}};
}

}  // namespace tcert::cli
