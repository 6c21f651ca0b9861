#include <cstddef>
#include <string>
#include <utility>

#include "datasets/import/csv_stream.hpp"

namespace tcert::recording {

std::vector<ValueSource> sources_of(const StreamSource& stream, const table::CsvHeader& header) {
  std::vector<ValueSource> sources = stream.values;
  for (const MappedRay& ray : stream.rays) {
    sources.push_back(ray.value);
    sources.push_back(ray.force);
  }
  if (stream.scan) {
    const std::string& pattern = stream.scan->ranges;
    const std::size_t mark = pattern.find("{i}");
    for (std::size_t i = 0; mark != std::string::npos; i += stream.scan->every) {
      std::string column = pattern;
      column.replace(mark, 3, std::to_string(i));
      if (!header.find(column)) {
        break;
      }
      sources.push_back({{std::move(column)}, 1.0, 0.0});
      sources.emplace_back();
    }
  }
  return sources;
}

}  // namespace tcert::recording
