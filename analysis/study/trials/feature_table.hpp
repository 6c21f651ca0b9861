#pragma once
/// \file
/// A trial with what its early window shows, and the columns that hold it in a table.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "analysis/study/trials/features.hpp"
#include "analysis/study/trials/not_issued.hpp"
#include "datasets/bundle.hpp"

namespace tcert::study {

/// A witness was looked for.
struct SoughtWitness {
  std::optional<double> margin_m;  ///< Of the one that was found.
  bool has_edges = false;          ///< Those of the edges were looked for, too.
  std::size_t edges = 0;
  std::size_t edges_proven = 0;
};

struct FeatureRow {
  TrialRow trial;
  Features features;
  std::optional<NotIssued> not_issued{};  ///< Of a trial that was certified here.
  std::optional<SoughtWitness> witness{};
};

/// A column of the table that is a feature. Truth values are 0 and 1.
struct FeatureColumn {
  std::string_view name;
  std::string_view unit;  ///< Empty for a pure number.
  std::string_view meaning;
  std::optional<double> (*get)(const Features& features);
};

/// All features, in the order of the file's columns.
[[nodiscard]] std::span<const FeatureColumn> feature_columns() noexcept;

}  // namespace tcert::study
