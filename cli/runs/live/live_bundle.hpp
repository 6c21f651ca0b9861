#pragma once
/// \file
/// What a live run is of: the bundle that describes it, and its certifier.

#include <string>
#include <tcert/certifier.hpp>

#include "cli/runs/progress.hpp"
#include "datasets/bundle.hpp"

namespace tcert::cli {

/// Of a bundle, or of its bundle.json alone. \throws UsageError, NoInput, BadData.
[[nodiscard]] BundleInfo describe(const std::string& path, Progress& progress);

/// \throws UsageError if the parameters are none of a live run.
[[nodiscard]] Certifier certifier_of(const Robot& robot,
                                     const Course& course,
                                     const CertificateParameters& parameters);

}  // namespace tcert::cli
