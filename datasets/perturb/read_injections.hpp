#pragma once
/// \file
/// The list of the faults that were put into a bundle.

#include <map>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"

namespace tcert::perturb {

/// A row of injections.csv, as far as those who look for faults need it.
struct InjectionRow {
  std::string kind;
  std::string stream;
  double start_s = 0.0;  ///< On the trial's clock.
  double end_s = 0.0;
};

struct InjectionsResult {
  std::map<std::string, std::vector<InjectionRow>> of_trial;  ///< Empty without a file.
  std::vector<table::Diagnostic> diagnostics;  ///< With an error, nothing can be used.
};

[[nodiscard]] InjectionsResult read_injections(const Bundle& bundle);

}  // namespace tcert::perturb
