#include "analysis/study/h1/issued_counts.hpp"

#include <cmath>

namespace tcert::study {

std::vector<IssuedCount> issued_counts(const table::DataTable& table, const H1Options& options) {
  const table::DataColumn* const issued = table.find("issued");
  const table::DataColumn* const success = table.find(options.success);
  if (issued == nullptr || success == nullptr || issued->is_text || success->is_text) {
    return {};
  }
  std::vector<IssuedCount> counts{{true, 0, 0}, {false, 0, 0}};
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (!std::isnan(success->numbers[row])) {
      IssuedCount& count = counts[success->numbers[row] == 1.0 ? 0 : 1];
      ++count.trials;
      count.issued += issued->numbers[row] == 1.0 ? 1 : 0;
    }
  }
  return counts;
}

}  // namespace tcert::study
