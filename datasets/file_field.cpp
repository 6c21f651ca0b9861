#include "datasets/file_field.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tcert {

std::vector<FileField> fields_at(std::string_view place, std::span<const FileField> fields) {
  std::vector<FileField> found;
  std::ranges::copy_if(fields, std::back_inserter(found), [&](const FileField& field) {
    return field.place == place;
  });
  return found;
}

std::vector<std::string> names_at(std::string_view place, std::span<const FileField> fields) {
  std::vector<std::string> names;
  for (const FileField& field : fields_at(place, fields)) {
    names.emplace_back(field.name);
  }
  return names;
}

table::NumberColumn number_column(const FileField& field, std::string name) {
  return {std::move(name),
          field.need != FieldNeed::optional,
          field.need != FieldNeed::required,
          field.is_flag,
          field.may_be_infinite,
          field.is_time};
}

}  // namespace tcert
