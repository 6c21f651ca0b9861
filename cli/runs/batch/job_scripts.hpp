#pragma once
/// \file
/// The scripts of a plan: for Slurm, for GNU parallel, and what people read of it.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/runs/batch/plan.hpp"

namespace tcert::cli {

/// Shards of one Slurm array: its MaxArraySize is 1001 unless somebody raised it.
inline constexpr std::uint64_t kMostTasks = 1000;

/// File names with their texts: submit (a shell script: every array, then the merge),
/// shards.sbatch, merge.sbatch, run_parallel, README.txt. \param folder absolute. \param program
/// absolute path of the tool.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> job_scripts(
    const Plan& plan, const std::filesystem::path& folder, const std::string& program);

/// What makes shards that are missing: a command for Slurm, and one without.
[[nodiscard]] std::string commands_for(const std::vector<std::uint64_t>& shards,
                                       const Plan& plan,
                                       const std::filesystem::path& folder);

/// 'it'"'"'s': one word for a shell.
[[nodiscard]] std::string quoted(const std::string& word);

}  // namespace tcert::cli
