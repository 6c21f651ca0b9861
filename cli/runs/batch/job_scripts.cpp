#include "cli/runs/batch/job_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tcert::cli {
namespace {

/// "3,17-19": shards less `offset`.
std::string ranges(const std::vector<std::uint64_t>& shards, std::uint64_t offset) {
  std::string text;
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t end = i + 1;
    while (end < shards.size() && shards[end] == shards[end - 1] + 1) {
      ++end;
    }
    text += fmt::format("{}{}", text.empty() ? "" : ",", shards[i] - offset);
    text += end - i > 1 ? fmt::format("-{}", shards[end - 1] - offset) : "";
    i = end;
  }
  return text;
}

constexpr std::string_view kShards = R"(#!/bin/sh
# One shard a task; TCERT_OFFSET is added to the number of the task. Written by 'tcert batch plan'.
#SBATCH --job-name=tcert-{command}
#SBATCH --array=0-{last}
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --cpus-per-task=1
exec {program} batch work {folder} --offset "${{TCERT_OFFSET:-0}}" --threads "${{SLURM_CPUS_PER_TASK:-1}}"
)";

constexpr std::string_view kMerge = R"(#!/bin/sh
# Written by 'tcert batch plan'.
#SBATCH --job-name=tcert-merge
#SBATCH --requeue
#SBATCH --open-mode=append
exec {program} batch merge {folder}
)";

constexpr std::string_view kSubmit = R"(#!/bin/sh
# Submits every shard, and the merge for when they have ended, well or not: it says what is missing.
# Arguments go to sbatch: --partition=..., --account=..., --time=...
set -eu
mkdir -p {folder}/logs
after=
for offset in $(seq 0 {most} {last}); do
  end=$(({shards} - offset < {most} ? {shards} - offset : {most}))
  job=$(sbatch --parsable --array=0-$((end - 1)) --export="ALL,TCERT_OFFSET=$offset" \
    --output={folder}/logs/%A_%a.txt "$@" {folder}/shards.sbatch)
  after=$after:${{job%%;*}}
done
sbatch --parsable --dependency="afterany$after" --output={folder}/logs/merge_%j.txt "$@" {folder}/merge.sbatch
)";

constexpr std::string_view kParallel = R"(#!/bin/sh
# Every shard by GNU parallel, one a core; once more: those that failed, and those that never ran.
# Arguments go to parallel: --jobs 8, --sshlogin ...
exec parallel --joblog {folder}/parallel.log --resume-failed "$@" \
  {program} batch work {folder} --shard {{}}/{shards} --threads 1 --quiet ::: $(seq 0 {last})
)";

constexpr std::string_view kReadme =
    R"({command}, {count} items in {shards} shards. Made by tcert {version}.

With Slurm:          sh {folder}/submit
With GNU parallel:   sh {folder}/run_parallel && {program} batch merge {folder}
One shard by itself: {program} batch work {folder} --shard 0/{shards}

The merge writes result/ and says what is missing, if anything, and the command that makes it. Parts of
shards that are done stay; whatever is run again makes only what is not there.
)";

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
                                                             const std::filesystem::path& folder,
                                                             const std::string& program) {
  const auto filled = [&](std::string_view text, std::uint64_t last) {
    return fmt::format(fmt::runtime(text),
                       fmt::arg("command", plan.command),
                       fmt::arg("program", quoted(program)),
                       fmt::arg("folder", quoted(folder.string())),
                       fmt::arg("shards", plan.shards),
                       fmt::arg("last", last),
                       fmt::arg("most", kMostTasks),
                       fmt::arg("count", plan.count()),
                       fmt::arg("version", plan.version));
  };
  const std::uint64_t last = plan.shards - 1;
  return {{"shards.sbatch", filled(kShards, std::min(last, kMostTasks - 1))},
          {"merge.sbatch", filled(kMerge, last)},
          {"submit", filled(kSubmit, last)},
          {"run_parallel", filled(kParallel, last)},
          {"README.txt", filled(kReadme, last)}};
}

std::string commands_for(const std::vector<std::uint64_t>& shards,
                         const Plan& plan,
                         const std::filesystem::path& folder) {
  const std::string place = quoted(folder.string());
  std::string text = "with Slurm:";
  for (std::size_t i = 0; i < shards.size();) {
    const std::uint64_t offset = shards[i] / kMostTasks * kMostTasks;
    std::vector<std::uint64_t> tasks;
    for (; i < shards.size() && shards[i] < offset + kMostTasks; ++i) {
      tasks.push_back(shards[i]);
    }
    text += fmt::format("\n  sbatch --array={}{} {}/shards.sbatch",
                        ranges(tasks, offset),
                        offset > 0 ? fmt::format(" --export=ALL,TCERT_OFFSET={}", offset) : "",
                        place);
  }
  text += fmt::format("\nwithout:\n  for i in");
  constexpr std::size_t kMostNamed = 20;
  if (shards.size() <= kMostNamed) {
    for (const std::uint64_t shard : shards) {
      text += fmt::format(" {}", shard);
    }
  } else {
    text += fmt::format(" $(seq 0 {})", plan.shards - 1);  // What is there is not made again.
  }
  return text + fmt::format("; do tcert batch work {} --shard $i/{}; done", place, plan.shards);
}

}  // namespace tcert::cli
