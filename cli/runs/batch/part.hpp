#pragma once
/// \file
/// What a shard made, as a file that appears whole, under its name alone, or not at all.
///
/// Lines: a head ("# key value": of which plan, program and arithmetic, which shard, which items),
/// a row an item ("item,what it gave", item counts through all sets of the plan), and the end
/// ("# end" and the digest of all before).

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <table/atomic_file.hpp>

#include "cli/runs/batch/plan.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {

/// PLAN/parts/000003.csv
[[nodiscard]] std::filesystem::path part_path(const ReadPlan& plan, std::uint64_t shard);

class PartWriter {
 public:
  /// \throws WriteError.
  PartWriter(const ReadPlan& plan, std::uint64_t shard);

  /// \throws WriteError.
  void add(std::uint64_t item, std::string_view line);

  /// Gives the part its name, for good. If another process was faster, false if it made the same.
  /// \throws WriteError; BadData if it made something else.
  [[nodiscard]] bool commit();

 private:
  void write(std::string_view text);

  std::filesystem::path path_;
  table::AtomicFile file_;
  Sha256 sum_;
  std::string pending_;
};

/// True if the part is there, whole, and of this plan; false if it is not there.
/// \throws BadData if it is of another plan, program or arithmetic, or damaged.
[[nodiscard]] bool has_part(const ReadPlan& plan, std::uint64_t shard);

/// Calls `take` for every item of a part that has_part(). \throws BadData.
void read_part(const ReadPlan& plan,
               std::uint64_t shard,
               const std::function<void(std::uint64_t item, std::string_view line)>& take);

}  // namespace tcert::cli
