// Any text as a message definition: a type within its bounds, or a reason.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/import/bag_metadata.hpp"
#include "datasets/import/message_type.hpp"
#include "datasets/import/value.hpp"
#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  using namespace tcert::recording;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const bool ros1 : {false, true}) {
    std::string problem;
    const auto type = message_type("test_msgs/msg/Root", text, problem, ros1);
    fuzz::require(type.has_value() != !problem.empty(), "no type iff there is a reason");
    if (!type) {
      continue;
    }
    const auto names = field_names(*type);
    fuzz::require(names.size() <= kMostFields, "a flattened type is bounded");
    for (const Structure& structure : type->structures) {
      for (const Field& field : structure.fields) {
        fuzz::require(field.structure < type->structures.size(), "a field is of a type");
      }
    }
    for (const FieldName& name : names) {
      std::string path = name.path;
      for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]", at)) {
        path.replace(at, 2, "[0]");
      }
      fuzz::require(field_path(path).has_value(), "the path of a field is a path");
    }
  }
  (void)relative_file_paths(text);
  (void)field_path(text);
  return 0;
}
