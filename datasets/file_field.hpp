#pragma once
/// \file
/// A column of a file, or a key of a JSON object, declared once: what its reader takes and what the
/// help shows.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <table/csv.hpp>
#include <vector>

namespace tcert {

enum class FieldNeed : std::uint8_t {
  required,
  may_be_empty,  ///< Of a column: it must be there, its cells may be missing.
  optional,      ///< It may be absent; the cells of a column may be missing.
};

struct FileField {
  std::string_view place;  ///< The file, or the object within it: "pose.csv", "robot".
  std::string_view name;
  std::string_view unit;  ///< Empty of a word or a pure number.
  FieldNeed need = FieldNeed::required;
  std::string_view doc;          ///< One line, no full stop.
  bool is_flag = false;          ///< 0 or 1, or a truth value.
  bool may_be_infinite = false;  ///< inf and -inf are values too.
  bool is_time = false;          ///< An instant of the clock of time_s.
};

/// Those of `place`, in the order in which they are declared.
[[nodiscard]] std::vector<FileField> fields_at(std::string_view place,
                                               std::span<const FileField> fields);

/// Names of the fields of `place`.
[[nodiscard]] std::vector<std::string> names_at(std::string_view place,
                                                std::span<const FileField> fields);

/// The column as read_numbers() takes it, under `name`.
[[nodiscard]] table::NumberColumn number_column(const FileField& field, std::string name);

}  // namespace tcert
