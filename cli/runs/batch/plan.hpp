#pragma once
/// \file
/// The plan of a batch: what is to be made, and in how many shards. A folder with plan.json, the
/// scripts that submit it, parts/ and, in the end, result/.

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/runs/batch/kinds.hpp"
#include "reports/manifest.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {

inline constexpr std::uint64_t kMostShards = 1000000;
inline constexpr std::uint64_t kMostItems = 1000000000000;

struct PlanInput {
  std::string name;   ///< As the words of the command have it.
  std::string place;  ///< Absolute path.
  FileDigest digest;
};

struct Plan {
  std::string command;  ///< "sweep".
  std::vector<ManifestArgument> arguments;
  std::vector<PlanInput> inputs;
  std::vector<std::pair<std::string, std::uint64_t>> items;  ///< Sets and their counts.
  std::uint64_t shards = 1;
  std::string version;     ///< Of the program,
  std::string program;     ///< and its digest.
  std::string arithmetic;  ///< arithmetic_digest() of where it was planned.

  [[nodiscard]] std::uint64_t count() const noexcept;

  /// Item k of n goes to shard floor(k shards / n): this is the range of one of them.
  /// \pre shard < shards.
  [[nodiscard]] ItemRange range_of(std::uint64_t shard) const noexcept;

  /// \throws BadData if the plan names no command of ours that works in pieces.
  [[nodiscard]] Pieces pieces() const;
};

/// \throws BadData unless these are the sets of the plan.
void require_items(const Plan& plan, const std::vector<ItemSet>& sets);

/// plan.json.
[[nodiscard]] std::string to_json(const Plan& plan);

/// A plan and the digest of its text, by which parts know it.
struct ReadPlan {
  Plan plan;
  std::string digest;
  std::filesystem::path folder;
};

/// \throws NoInput if there is no plan in `folder`; BadData if it is none of ours, was made by
/// another program, on another arithmetic, or of inputs that have changed since.
[[nodiscard]] ReadPlan read_plan(const std::filesystem::path& folder);

}  // namespace tcert::cli
