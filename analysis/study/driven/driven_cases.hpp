#pragma once
/// \file
/// Which trials an experiment drives: who, under which lighting, in which world.

#include <cstdint>
#include <vector>

#include "analysis/study/driven/arm.hpp"
#include "datasets/corpus/design.hpp"

namespace tcert::study {

struct DrivenCase {
  std::size_t arm = 0;  ///< Of the arms of the experiment.
  Lighting lighting{};
  std::uint64_t world = 0;  ///< Of the seed's gated worlds.
};

/// The world that replicate `replicate` meets under a lighting: the same for every arm, another for
/// every lighting, since lighting changes nothing for who only feels. 60 replicates of three
/// lightings make a block of 22 days; worlds of one day share lane width and calibration.
[[nodiscard]] std::uint64_t world_of(Lighting lighting, std::uint64_t replicate) noexcept;

/// Trials `first` ... `first + count - 1` of the paper's design: blocks of 660, in each the cells
/// of Table 1 with their numbers of trials (30; 60 of M3 and of CB-V in the dark). Arms are the six
/// policies in the order of the table's rows.
[[nodiscard]] std::vector<DrivenCase> paper_cases(std::uint64_t first, std::uint64_t count);

/// Every arm under every lighting in replicates `first` ... `first + count - 1`: world by world, so
/// that arms are compared in pairs.
[[nodiscard]] std::vector<DrivenCase> crossed_cases(std::size_t arms,
                                                    const std::vector<Lighting>& lightings,
                                                    std::uint64_t first,
                                                    std::uint64_t count);

/// The six policies in the order of Table 1's rows, as they are.
[[nodiscard]] std::vector<Arm> paper_arms();

}  // namespace tcert::study
