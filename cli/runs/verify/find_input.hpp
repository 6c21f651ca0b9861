#pragma once
/// \file
/// Where the inputs of a result lie now: a manifest keeps only their names.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/runs/verify/targets.hpp"

namespace tcert::cli {

/// The file or folder of an input's name: what `given` (--inputs) names or holds, beside the
/// results, here. Of several the one with the digest that `target` lists; else the first. Empty if
/// there is none. \pre is_path_step(name).
[[nodiscard]] std::optional<std::filesystem::path> find_input(
    const std::string& name,
    const VerifyTarget& target,
    const std::filesystem::path& results,
    const std::vector<std::string>& given);

}  // namespace tcert::cli
