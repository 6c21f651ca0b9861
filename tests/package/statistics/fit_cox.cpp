// Fits a Cox model to a CSV with an installed tcert::statistics: fit_cox FILE FORMULA.
#include <cstdio>
#include <exception>
#include <statistics/cox/cox.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>
#include <table/read_data_table.hpp>

int main(int argc, char** argv) {
  using namespace tcert;
  if (argc != 3) {
    std::fprintf(stderr, "usage: fit_cox FILE FORMULA\n");
    return 2;
  }
  const table::DataTableResult read = table::read_data_table(argv[1]);
  for (const table::Diagnostic& problem : read.diagnostics) {
    std::fprintf(stderr, "%s\n", to_string(problem).c_str());
  }
  if (!read.table) {
    return 1;
  }
  try {
    const auto frame = statistics::model_frame(statistics::parse_formula(argv[2]), *read.table);
    const statistics::CoxFit fit = statistics::fit_cox(statistics::cox_data(frame));
    std::printf("%zu rows, %zu events\n", fit.rows, fit.events);
    for (const statistics::CoxCoefficient& one : fit.coefficients) {
      std::printf("%s %.6f (%.6f), p %.6f\n",
                  one.column.c_str(),
                  *one.estimate,
                  *one.model_se,
                  *one.p_value);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
