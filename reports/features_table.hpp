#pragma once
/// \file
/// features.csv and certificates.csv: what a trial's certificate came to, one row a trial.

#include <string>
#include <vector>

#include "analysis/study/trials/study.hpp"
#include "analysis/study/trials/study_tables.hpp"
#include "datasets/bundle.hpp"
#include "reports/column_doc.hpp"
#include "reports/table.hpp"

namespace tcert {

/// The label of everything that is made from this bundle; empty for real data.
[[nodiscard]] std::optional<SyntheticLabel> synthetic_label(const BundleInfo& info);

/// Columns of the feature table, no rows: the trial's row of trials.csv, its features, the medians
/// of its control samples, then the extra columns of the bundle as text.
[[nodiscard]] Table features_table(const Bundle& bundle);
[[nodiscard]] std::vector<TableCell> features_row(const study::TrialRecord& trial);

/// What the columns of the two tables mean, in their order.
[[nodiscard]] std::vector<ColumnDoc> feature_column_docs();
[[nodiscard]] std::vector<ColumnDoc> certificate_column_docs();

/// Whether the certificate table has the columns of the witness, and of those of edges.
enum class WitnessColumns { no, yes, with_edges };

/// Columns of the certificate table, no rows: where and when each certificate was issued, what
/// decides it, and the digest of the log that it was made from.
[[nodiscard]] Table certificates_table(const Bundle& bundle,
                                       WitnessColumns witness = WitnessColumns::no);
[[nodiscard]] std::vector<TableCell> certificates_row(const study::StudiedTrial& trial,
                                                      const std::string& log_sha256,
                                                      WitnessColumns witness = WitnessColumns::no);

}  // namespace tcert
