#pragma once
/// \file
/// The synthetic 660-trial corpus: what is published about the study, built in exactly, and
/// everything else declared.
///
/// Published, and reproduced: 660 figure-8 traversals, 6 algorithms under 3 tiers of lighting, the
/// 18 success rates of Table 1 (583 of 660 in all), the order of the algorithms' median commanded
/// speeds with their values to 0.01 m/s, the order of the tiers', and a median policy-loop latency
/// of 19.6 ms in every cell. Declared, by us: everything else; README.md beside this file tells it
/// all with the figures measured on the result. It is a test of the tool and an example of its
/// input, never a claim about the real robot, and says "synthetic" with its seed in every file.

#include <filesystem>

#include "datasets/corpus/design.hpp"
#include "datasets/corpus/write_bundle.hpp"

namespace tcert {

/// Description of the corpus: robot, S and G, lighting tiers, trial limit, provenance.
[[nodiscard]] BundleInfo corpus_info(const CorpusOptions& options);

/// Writes the corpus as a bundle into `folder`. 660 trials at 20 Hz: about 75 MB.
/// \throws std::invalid_argument as validate(options); WriteError.
void simulate_corpus(const std::filesystem::path& folder,
                     const CorpusOptions& options,
                     const TrialProgress& progress = {},
                     bool replace = false);

}  // namespace tcert
