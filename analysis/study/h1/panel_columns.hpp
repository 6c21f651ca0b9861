#pragma once
/// \file
/// The columns of a feature table, as the panels of H1 and H2 use them.

#include <optional>
#include <string>
#include <table/data_table.hpp>
#include <table/factor.hpp>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// Of the whole table, an entry a row.
struct PanelColumns {
  std::vector<double> success;
  std::vector<double> time;
  std::vector<double> end;  ///< Time, or that of the last tick.
  std::vector<double> log_end;
  std::vector<std::vector<double>> predictors;
  std::optional<table::Factor> cluster;
  std::optional<table::Factor> strata;
  std::optional<table::Factor> group;
};

/// The landmark's own column where the table has it.
[[nodiscard]] const std::string& column_of(const table::DataTable& table,
                                           const H1Predictor& predictor,
                                           H1PanelKind kind);

/// The cross of those columns of `within` that are there; nothing if none is.
[[nodiscard]] std::optional<table::Factor> strata_of(const table::DataTable& table,
                                                     const std::vector<std::string>& within,
                                                     std::vector<std::string>& used);

/// \throws FormulaError if a column that the options need is not there or of the wrong kind.
[[nodiscard]] PanelColumns columns_of_table(const table::DataTable& table,
                                            const H1Options& options,
                                            H1PanelKind kind);

}  // namespace tcert::study
