#include "reports/study/study_summary.hpp"

#include <algorithm>

#include "reports/fit/cells.hpp"

namespace tcert {

FitReport study_report(std::string name, std::uint64_t seed) {
  FitReport report;
  report.model = std::move(name);
  report.synthetic = SyntheticLabel{seed};
  return report;
}

Table study_summary(const std::vector<std::pair<std::string, std::uint64_t>>& numbers) {
  Record record("summary", "Options");
  for (const auto& [name, value] : numbers) {
    std::string heading = name;
    std::ranges::replace(heading, '_', ' ');
    record.integer(name, heading, value);
  }
  return std::move(record).table();
}

}  // namespace tcert
