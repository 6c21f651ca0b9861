#pragma once
/// \file
/// The scripts of a plan: for Slurm, for GNU parallel, and what people read of it. They find their
/// folder by themselves, so that it may be moved.

#include <string>
#include <utility>
#include <vector>

#include "cli/runs/batch/plan.hpp"

namespace tcert::cli {

/// Shards of one Slurm array: its MaxArraySize is 1001 unless somebody raised it.
inline constexpr std::uint64_t kMostTasks = 1000;

/// File names with their texts: one (a shell script that makes one shard), submit (every shard that
/// is missing as arrays, then the merge), shards.sbatch, merge.sbatch, run_parallel, README.txt.
/// \param program absolute path of the tool.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> job_scripts(
    const Plan& plan, const std::string& program);

/// 'it'"'"'s': one word for a shell.
[[nodiscard]] std::string quoted(const std::string& word);

}  // namespace tcert::cli
