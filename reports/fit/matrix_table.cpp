#include "reports/fit/matrix_table.hpp"

#include <algorithm>

namespace tcert {

std::string apart_from(std::string name, const std::vector<std::string>& taken) {
  while (std::find(taken.begin(), taken.end(), name) != taken.end()) {
    name.insert(0, ".");
  }
  return name;
}

void add_matrix_columns(const std::vector<std::string>& names,
                        const Eigen::MatrixXd& values,
                        ColumnsOf<Eigen::Index>& columns) {
  Eigen::Index j = 0;
  for (const std::string& name : names) {
    columns.number(name, name, [&values, j](Eigen::Index i) { return values(i, j); });
    ++j;
  }
}

Table matrix_table(std::string name,
                   std::string title,
                   const std::vector<std::string>& names,
                   const Eigen::MatrixXd& values) {
  ColumnsOf<Eigen::Index> columns;
  columns.text(apart_from("term", names), "term", [&](Eigen::Index i) {
    return names[static_cast<std::size_t>(i)];
  });
  add_matrix_columns(names, values, columns);
  Table table = columns.table(std::move(name), std::move(title));
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    table.add_row(columns.row(i));
  }
  return table;
}

}  // namespace tcert
