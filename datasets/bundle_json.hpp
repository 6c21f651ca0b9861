#pragma once
/// \file
/// bundle.json, version 1: the description of a bundle.

#include <optional>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>

#include "datasets/bundle.hpp"

namespace tcert {

/// Reads a bundle.json strictly: unknown keys, wrong types and values out of range are errors, all
/// of them reported, and then there is no description.
[[nodiscard]] std::optional<BundleInfo> parse_bundle_json(std::string_view text,
                                                          table::DiagnosticGroups& problems);

/// The text of a bundle.json that reads back as `info`; ends with a line end.
[[nodiscard]] std::string to_bundle_json(const BundleInfo& info);

}  // namespace tcert
