#include "datasets/import/message_reader.hpp"

#include <utility>

#include "datasets/import/wide_text.hpp"

namespace tcert::recording {
namespace {

/// The alternative T of `value`, as it is if it is one already.
template <class T>
T& hold(Value& value) {
  T* held = std::get_if<T>(&value.data);
  return held != nullptr ? *held : value.data.emplace<T>();
}

class MessageReader {
 public:
  MessageReader(const MessageType& type, std::span<const std::byte> body, const WireRules& rules)
      : type_(type),
        rules_(rules),
        cursor_(body, rules.alignment, rules.swap),
        // A byte is at most a leaf below all levels of the type; elements without bytes end here.
        most_values_(std::min(kMostValues, kMostFields + 2 * (kDeepestType + 1) * body.size())) {}

  bool read(std::size_t structure, Value& out);

  [[nodiscard]] std::size_t left() const noexcept { return cursor_.left(); }

  /// Of the value that did not fit; empty if there is only no room.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }
  [[nodiscard]] const std::string& failed_field() const noexcept { return failed_field_; }

 private:
  bool fail(std::string reason) {
    reason_ = std::move(reason);
    return false;
  }
  bool count(std::size_t values) {
    values_ += values;
    return values_ <= most_values_ ||
           fail("it holds more than " + std::to_string(most_values_) + " values");
  }
  bool read_field(const Field& field, Value& out);
  bool read_scalar(const Field& field, Value& out);
  bool read_elements(const Field& field, std::size_t count, Value& out);
  bool read_trees(const Field& field, std::size_t elements, Value& out);
  bool read_text(std::string& out);
  bool read_wide_text(std::string& out);

  template <class T, class Wide = T>
  bool scalar(Value& out) {
    T value{};
    const bool fits = cursor_.take(value);
    // NOLINTNEXTLINE(bugprone-signed-char-misuse): an int8 keeps its sign.
    hold<Wide>(out) = static_cast<Wide>(value);
    return fits;
  }

  const MessageType& type_;
  const WireRules& rules_;
  CdrCursor cursor_;
  std::size_t most_values_;
  std::size_t values_ = 0;
  std::string reason_;
  std::string failed_field_;
  std::vector<std::uint64_t> units_;  // of a wide text
};

bool MessageReader::read(std::size_t structure, Value& out) {
  const std::vector<Field>& fields = type_.structures[structure].fields;
  auto& object = hold<Object>(out);
  if (!count(fields.size() + 1)) {
    return false;
  }
  object.resize(fields.size());
  if (fields.empty() && rules_.fills_empty) {
    std::uint8_t filler = 0;
    return cursor_.take(filler);
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (object[i].name != fields[i].name) {
      object[i].name = fields[i].name;
    }
    if (!read_field(fields[i], object[i].value)) {
      failed_field_ = failed_field_.empty() ? fields[i].name : fields[i].name + "." + failed_field_;
      return false;
    }
  }
  return true;
}

bool MessageReader::read_field(const Field& field, Value& out) {
  if (field.arity == Arity::scalar) {
    return read_scalar(field, out);
  }
  if (rules_.delimits_arrays && field.kind >= FieldKind::string) {
    std::uint32_t bytes = 0;
    if (!cursor_.take(bytes) || bytes > cursor_.left()) {
      return false;
    }
  }
  if (field.arity == Arity::fixed) {
    return read_elements(field, field.count, out);
  }
  std::uint32_t length = 0;
  if (!cursor_.take(length)) {
    return false;
  }
  if (field.count > 0 && length > field.count) {
    return fail("its length " + std::to_string(length) + " is above its bound");
  }
  return read_elements(field, length, out);
}

bool MessageReader::read_scalar(const Field& field, Value& out) {
  switch (field.kind) {
    case FieldKind::boolean: {
      std::uint8_t value = 0;
      const bool fits = cursor_.take(value);
      hold<bool>(out) = value != 0;
      return fits;
    }
    case FieldKind::int8:
      return scalar<std::int8_t, std::int64_t>(out);
    case FieldKind::uint8:
      return scalar<std::uint8_t, std::uint64_t>(out);
    case FieldKind::int16:
      return scalar<std::int16_t, std::int64_t>(out);
    case FieldKind::uint16:
      return scalar<std::uint16_t, std::uint64_t>(out);
    case FieldKind::int32:
      return scalar<std::int32_t, std::int64_t>(out);
    case FieldKind::uint32:
      return scalar<std::uint32_t, std::uint64_t>(out);
    case FieldKind::int64:
      return scalar<std::int64_t>(out);
    case FieldKind::uint64:
      return scalar<std::uint64_t>(out);
    case FieldKind::float32:
      return scalar<float, double>(out);
    case FieldKind::float64:
      return scalar<double>(out);
    case FieldKind::string:
      return read_text(hold<std::string>(out));
    case FieldKind::wstring:
      return read_wide_text(hold<std::string>(out));
    case FieldKind::structure:
      break;
  }
  return read(field.structure, out);
}

bool MessageReader::read_elements(const Field& field, std::size_t count, Value& out) {
  switch (field.kind) {
    case FieldKind::boolean: {
      auto& flags = hold<Flags>(out).values;
      const bool fits = cursor_.take_many<std::uint8_t>(count, flags);
      std::ranges::transform(flags, flags.begin(), [](std::uint8_t flag) {
        return static_cast<std::uint8_t>(flag != 0 ? 1 : 0);
      });
      return fits;
    }
    case FieldKind::int8:
      return cursor_.take_many<std::int8_t>(count, hold<Signed>(out));
    case FieldKind::uint8:
      return cursor_.take_many<std::uint8_t>(count, hold<Octets>(out));
    case FieldKind::int16:
      return cursor_.take_many<std::int16_t>(count, hold<Signed>(out));
    case FieldKind::uint16:
      return cursor_.take_many<std::uint16_t>(count, hold<Unsigned>(out));
    case FieldKind::int32:
      return cursor_.take_many<std::int32_t>(count, hold<Signed>(out));
    case FieldKind::uint32:
      return cursor_.take_many<std::uint32_t>(count, hold<Unsigned>(out));
    case FieldKind::int64:
      return cursor_.take_many<std::int64_t>(count, hold<Signed>(out));
    case FieldKind::uint64:
      return cursor_.take_many<std::uint64_t>(count, hold<Unsigned>(out));
    case FieldKind::float32:
      return cursor_.take_many<float>(count, hold<Doubles>(out));
    case FieldKind::float64:
      return cursor_.take_many<double>(count, hold<Doubles>(out));
    case FieldKind::string:
    case FieldKind::wstring:
    case FieldKind::structure:
      break;
  }
  return read_trees(field, count, out);
}

bool MessageReader::read_trees(const Field& field, std::size_t elements, Value& out) {
  auto& array = hold<Array>(out);
  // Each element takes a byte at least, where the rules have no elements without any.
  if (rules_.fills_empty && elements > cursor_.left()) {
    return false;
  }
  if (!count(elements)) {
    return false;
  }
  array.resize(elements);
  return std::ranges::all_of(array, [&](Value& element) { return read_scalar(field, element); });
}

bool MessageReader::read_text(std::string& out) {
  std::uint32_t length = 0;
  if (!cursor_.take(length) || !cursor_.take_text(length, out)) {
    return false;
  }
  if (rules_.ends_text_with_zero && out.ends_with('\0')) {
    out.pop_back();
  }
  return true;
}

bool MessageReader::read_wide_text(std::string& out) {
  std::uint32_t length = 0;
  if (!cursor_.take(length)) {
    return false;
  }
  const bool fits = rules_.wide_character == 2 ? cursor_.take_many<std::uint16_t>(length, units_)
                                               : cursor_.take_many<std::uint32_t>(length, units_);
  return fits && (to_utf8(units_, out) || fail("a wide text holds what is no character"));
}

}  // namespace

bool read_message(const MessageType& type,
                  std::span<const std::byte> body,
                  const WireRules& rules,
                  Value& out,
                  std::string& problem) {
  if (body.size() > kLongestMessage) {
    problem = "the message is longer than 64 MiB";
    return false;
  }
  MessageReader reader(type, body, rules);
  if (!reader.read(0, out)) {
    const std::string place = "its field '" + reader.failed_field() + "'";
    problem = reader.reason().empty() ? "the message ends in " + place
                                      : "of " + place + ": " + reader.reason();
    return false;
  }
  if (reader.left() > rules.padding) {
    problem = std::to_string(reader.left()) + " bytes are left behind the last field of the type";
    return false;
  }
  return true;
}

}  // namespace tcert::recording
