#pragma once
/// \file
/// Writing a synthetic corpus with its manifest, and knowing it again.

#include <cstdint>
#include <filesystem>

#include "cli/options.hpp"
#include "datasets/corpus/corpus.hpp"

namespace tcert::cli {

struct SimulatedCorpus {
  CorpusOptions options;
  bool micro_study = false;  ///< The 60 gate passes; only the seed of the options counts.
};

/// Writes the bundle and its manifest.json into `folder`, whole or not at all; returns the number
/// of trials. \throws WriteError.
std::uint64_t write_corpus(const SimulatedCorpus& corpus,
                           const std::filesystem::path& folder,
                           const CommonOptions& common);

/// True if `folder` holds this corpus as this build makes it, every file with its bytes.
[[nodiscard]] bool is_there(const SimulatedCorpus& corpus, const std::filesystem::path& folder);

}  // namespace tcert::cli
