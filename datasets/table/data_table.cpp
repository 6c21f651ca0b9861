#include <algorithm>
#include <table/data_table.hpp>

namespace tcert::table {

const DataColumn* DataTable::find(std::string_view name) const noexcept {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const DataColumn& column) {
    return column.name == name;
  });
  return found == columns.end() ? nullptr : &*found;
}

}  // namespace tcert::table
