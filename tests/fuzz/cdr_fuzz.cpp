// A definition, a zero byte, a message: it is decoded or says why not, in every encoding; memory
// that is used again changes nothing.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "datasets/import/decoder.hpp"
#include "fuzz/check.hpp"

namespace {

using namespace tcert;
using namespace tcert::recording;

void check(const MessageType& type, std::span<const std::byte> bytes, auto decode_as) {
  static Value reused;
  Value fresh;
  std::string problem;
  const bool fits = decode_as(type, bytes, fresh, problem);
  fuzz::require(fits != !problem.empty(), "a message that does not fit says why");
  std::string again;
  fuzz::require(decode_as(type, bytes, reused, again) == fits, "the same bytes fit again");
  fuzz::require(problem == again, "for the same reason");
  if (fits) {
    fuzz::require(size(reused) == size(fresh), "with the same members");
    for (const FieldName& name : field_names(type)) {
      const std::string path = name.path.substr(0, name.path.find('['));
      const Value* a = find(fresh, path);
      const Value* b = find(reused, path);
      fuzz::require((a == nullptr) == (b == nullptr), "at the same paths");
      fuzz::require(a == nullptr || (a->data.index() == b->data.index() && size(*a) == size(*b)),
                    "of the same kinds and sizes");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* end = std::find(data, data + size, 0);
  const std::string_view definition(reinterpret_cast<const char*>(data),
                                    static_cast<std::size_t>(end - data));
  const std::size_t used = std::min(size, definition.size() + 1);
  const auto message = std::as_bytes(std::span(data + used, size - used));
  for (const bool ros1 : {false, true}) {
    std::string problem;
    const auto type = message_type("test_msgs/Root", definition, problem, ros1);
    if (type && ros1) {
      check(*type, message, decode_ros1);
    } else if (type) {
      check(*type, message, decode);
    }
  }
  Value value;
  std::string problem;
  fuzz::require(decode_json(message, value, problem) != !problem.empty(),
                "JSON is read or says why not");
  return 0;
}
