#include "cli/runs/batch/job_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tcert::cli {
namespace {

constexpr std::string_view kOne = R"sh(#!/bin/sh
# Makes one shard: sh one 3. Written by 'tcert batch plan', as all scripts here.
case ${{1:-}} in
  '' | *[!0-9]*) echo "usage: sh one K, K from 0 to {last}" >&2; exit 2 ;;
esac
exec {program} batch work "$(dirname "$0")" --shard "$1/{shards}" --threads "${{TCERT_THREADS:-1}}"
)sh";

constexpr std::string_view kShards = R"sh(#!/bin/sh
# One shard a task. Arguments: the folder of the plan, what is added to the number of the task.
#SBATCH --job-name=tcert-{command}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --cpus-per-task=1
exec {program} batch work "${{1:?this is submitted by: sh submit}}" --offset "${{2:-0}}" --threads "${{SLURM_CPUS_PER_TASK:-1}}"
)sh";

constexpr std::string_view kMerge = R"sh(#!/bin/sh
#SBATCH --job-name=tcert-merge
#SBATCH --requeue
#SBATCH --open-mode=append
exec {program} batch merge "${{1:?this is submitted by: sh submit}}"
)sh";

constexpr std::string_view kSubmit = R"sh(#!/bin/sh
# Submits every shard that is not there, as arrays of at most {most} tasks, and the merge for when they
# have ended, well or not: it says what is missing. Arguments go to sbatch: --partition=..., --time=...
# TCERT_AT_ONCE=50 runs no more than 50 tasks of an array at a time.
set -eu
for option; do
  case $option in
    -a* | --array* | -d* | --dependency* | -o* | --output* | --parsable)
      echo "submit sets $option itself; how many run at a time is told by TCERT_AT_ONCE" >&2
      exit 2 ;;
  esac
done
[ -x {program} ] || {{ echo "the program of this plan is gone: "{program} >&2; exit 1; }}
plan=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$plan/logs"
logs=$(printf '%s/logs' "$plan" | sed 's/%/%%/g')
after=
offset=0
while [ "$offset" -lt {shards} ]; do
  most=$(({shards} - offset < {most} ? {shards} - offset : {most}))
  tasks=
  count=0
  task=0
  while [ "$task" -lt "$most" ]; do
    if [ ! -e "$(printf '%s/parts/%06d.csv' "$plan" $((offset + task)))" ]; then
      tasks=$tasks,$task
      count=$((count + 1))
    fi
    task=$((task + 1))
  done
  [ "$count" -lt "$most" ] || tasks=,0-$((most - 1))
  if [ -n "$tasks" ]; then
    job=$(sbatch --parsable --array="${{tasks#,}}${{TCERT_AT_ONCE:+%$TCERT_AT_ONCE}}" --output="$logs/%A_%a.txt" \
      "$@" "$plan/shards.sbatch" "$plan" "$offset")
    echo "shards from $offset: $count tasks in job ${{job%%;*}}"
    after=$after:${{job%%;*}}
  fi
  offset=$((offset + {most}))
done
job=$(sbatch --parsable ${{after:+--dependency="afterany$after"}} --output="$logs/merge_%j.txt" "$@" \
  "$plan/merge.sbatch" "$plan")
echo "merge: job ${{job%%;*}}, when they have ended; what they say: $plan/logs"
)sh";

constexpr std::string_view kParallel = R"sh(#!/bin/sh
# Every shard by GNU parallel, one a core; those that are there are not made again.
# Arguments go to parallel: --jobs 8, --sshlogin ... --workdir .
cd "$(dirname "$0")" || exit
seq 0 {last} | parallel "$@" sh ./one
)sh";

constexpr std::string_view kReadme = R"sh(tcert {words}
{count} items in {shards} shards. Planned by tcert {version}, {program}, which must stay there.

With Slurm:          sh submit            (its arguments go to sbatch: --time, --partition, --account, --constraint)
With GNU parallel:   sh run_parallel      then {program} batch merge .
One shard by itself: sh one 0

plan.json       what is planned, with digests of the inputs, of the program and of the arithmetic
shards.sbatch   one shard, as a task of an array; merge.sbatch: the merge
parts/          what the shards made; hidden files are left by killed tasks, and the merge removes them
logs/           what tasks of Slurm said
result/         what the merge makes

Inputs are read where they lay when this was planned. Nodes must be of one kind (--constraint): on others
exp and the like differ in the last bit, and work refuses. submit and run_parallel, run again, make what
is not there.
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
  std::string words = plan.command;
  for (const ManifestArgument& one : plan.arguments) {
    words += ' ' + quoted(one.text);
  }
  const auto filled = [&](std::string_view text) {
    return fmt::format(fmt::runtime(text),
                       fmt::arg("command", plan.command),
                       fmt::arg("words", words),
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
