#include "reports/fit/left_out_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "reports/columns_of.hpp"

namespace tcert {
namespace {

struct LeftOutRow {
  std::string cluster;
  std::int64_t rows = 0;
  std::string term;
  std::optional<double> estimate;
  std::optional<double> change;
};

}  // namespace

Table left_out_table(const std::vector<std::string>& names,
                     const table::Factor& cluster,
                     const Eigen::VectorXd& estimates,
                     const Eigen::MatrixXd& left_out) {
  std::vector<std::int64_t> rows(cluster.levels.size(), 0);
  for (const std::uint32_t code : cluster.codes) {
    ++rows.at(code);
  }
  std::vector<LeftOutRow> all;
  Eigen::Index column = 0;
  for (std::size_t level = 0; level < rows.size(); ++level) {
    if (rows[level] == 0) {
      continue;
    }
    if (column == left_out.cols()) {
      throw std::invalid_argument("left out: more clusters than estimates");
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      LeftOutRow row{cluster.levels[level], rows[level], names[k], {}, {}};
      if (std::isfinite(left_out(at, column))) {
        row.estimate = left_out(at, column);
        row.change = left_out(at, column) - estimates(at);
      }
      all.push_back(std::move(row));
    }
    ++column;
  }
  return ColumnsOf<LeftOutRow>()
      .text("cluster", "without", &LeftOutRow::cluster)
      .integer("rows", "rows", &LeftOutRow::rows)
      .text("term", "term", &LeftOutRow::term)
      .number("estimate", "estimate", &LeftOutRow::estimate)
      .number("change", "change", &LeftOutRow::change)
      .table("left_out", "Coefficients without each cluster in turn", all);
}

}  // namespace tcert
