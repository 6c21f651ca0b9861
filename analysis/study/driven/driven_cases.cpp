#include "analysis/study/driven/driven_cases.hpp"

#include <string>

namespace tcert::study {
namespace {

constexpr std::uint64_t kReplicatesPerBlock = 60;

}  // namespace

// Neighbouring replicates lie on different days, so that even few of them have many days.
std::uint64_t world_of(Lighting lighting, std::uint64_t replicate) noexcept {
  const std::uint64_t block = replicate / kReplicatesPerBlock;
  const std::uint64_t within =
      kLightings * (replicate % kReplicatesPerBlock) + static_cast<std::uint64_t>(lighting);
  return kTrialsPerBlock * block + kTrialsPerDay * (within % kDaysPerBlock) +
         within / kDaysPerBlock;
}

std::vector<DrivenCase> paper_cases(std::uint64_t first, std::uint64_t count) {
  std::vector<DrivenCase> cases;
  cases.reserve(count);
  for (std::uint64_t k = first; k < first + count; ++k) {
    std::uint64_t within = k % kTrialsPerBlock;
    for (const Cell& cell : table_of_cells()) {
      if (within < cell.trials) {
        const std::uint64_t replicate = kReplicatesPerBlock * (k / kTrialsPerBlock) + within;
        cases.push_back({static_cast<std::size_t>(cell.algorithm),
                         cell.lighting,
                         world_of(cell.lighting, replicate)});
        break;
      }
      within -= cell.trials;
    }
  }
  return cases;
}

std::vector<DrivenCase> crossed_cases(std::size_t arms,
                                      const std::vector<Lighting>& lightings,
                                      std::uint64_t first,
                                      std::uint64_t count) {
  std::vector<DrivenCase> cases;
  cases.reserve(arms * lightings.size() * count);
  for (std::uint64_t replicate = first; replicate < first + count; ++replicate) {
    for (const Lighting lighting : lightings) {
      for (std::size_t arm = 0; arm < arms; ++arm) {
        cases.push_back({arm, lighting, world_of(lighting, replicate)});
      }
    }
  }
  return cases;
}

std::vector<Arm> paper_arms() {
  std::vector<Arm> arms;
  for (std::size_t a = 0; a < kAlgorithms; ++a) {
    arms.push_back(parse_arm(name_of(static_cast<Algorithm>(a)), {}));
  }
  return arms;
}

}  // namespace tcert::study
