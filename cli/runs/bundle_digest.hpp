#pragma once
/// \file
/// Digests of what a bundle consists of: for manifests, and for knowing results again.

#include <vector>

#include "datasets/bundle.hpp"
#include "reports/manifest.hpp"
#include "reports/sha256.hpp"

namespace tcert::cli {

/// Of one trial's log. Empty for a trial of a .zip, whose archive has a digest instead, and for a
/// log that cannot be read, which is rejected for that.
[[nodiscard]] FileDigest log_digest(const Bundle& bundle, const TrialRow& row);

/// bundle.json and trials.csv, then `logs` as "logs/"; of a .zip the archive alone.
[[nodiscard]] std::vector<ManifestFile> bundle_inputs(const Bundle& bundle, const FileDigest& logs);

}  // namespace tcert::cli
