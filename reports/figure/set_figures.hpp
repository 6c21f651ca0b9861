#pragma once
/// \file
/// Figures of H2, H3, ablations and sweeps, the micro-study, and of all trials together. Empty if
/// the tables have nothing to draw.

#include <optional>
#include <table/data_table.hpp>

#include "reports/figure/figure.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Differences of AUC and C between lightings with their 90 % intervals and the margins of
/// equivalence, from h2_pairs and h2_equality; of the last panel.
[[nodiscard]] std::optional<Figure> equivalence_figure(const Table& h2_pairs,
                                                       const Table& h2_equality);

/// Gain against retention for every law and beta, by lighting, with the Pareto front, from h3.
[[nodiscard]] std::optional<Figure> pareto_figure(const Table& h3);

/// AUC under each cell's parameters, sorted, beside the full method, from cells: the specification
/// curve of a sweep, or ablations. Of the last panel.
[[nodiscard]] std::optional<Figure> cells_figure(const Table& cells,
                                                 const std::string& name,
                                                 const std::string& title);

/// Chance to pass a gate against its margin, from the tables of the micro-study.
[[nodiscard]] std::optional<Figure> gate_figure(const Table& gate,
                                                const Table& gate_passes,
                                                const Table& gate_curve,
                                                const Table& gate_calibration);

/// True if the table `speed` has what the paper prints beside every algorithm: the algorithms are
/// the paper's. Tables of older versions have values beside single names that happen to be.
[[nodiscard]] bool has_published_speeds(const Table& speed);

/// Commanded speed by algorithm or by lighting (Figures 1 and 2 of the paper): pooled medians and
/// what the paper prints from `speed`, the trials' own medians from features.csv.
[[nodiscard]] std::optional<Figure> speed_figure(const Table& speed,
                                                 const table::DataTable& features,
                                                 const std::string& grouped_by);

/// What each rule detects, its false alarms and what it costs, from `monitors` of an assurance.
[[nodiscard]] std::optional<Figure> rules_figure(const Table& monitors);

/// Progress against unsafe dwell of every choice of guards, with the front, and of the choices of
/// folds on their own days, from `guard_choices` and `guard_folds`.
[[nodiscard]] std::optional<Figure> guards_figure(const Table& guard_choices,
                                                  const Table& guard_front,
                                                  const Table& guard_folds);

/// The truth T(E; A) against the certificate T_t, from features.csv with the columns truth_lower_m
/// and truth_upper_m: the proven interval, its upper bound, and the certificates that it refutes.
[[nodiscard]] std::optional<Figure> truth_figure(const table::DataTable& features,
                                                 const std::optional<SyntheticLabel>& synthetic);

}  // namespace tcert
