#include <algorithm>
#include <cstdint>

#include "datasets/import/decoder.hpp"
#include "datasets/import/message_reader.hpp"

namespace tcert::recording {
namespace {

constexpr std::size_t kHeaderBytes = 4;

/// Rules of the encapsulation that the first two bytes name (DDS-XTypes 1.3, 7.6.3.1.2; the two of
/// its first version too); nothing if it is not read.
std::optional<WireRules> rules_of(std::uint32_t kind) noexcept {
  WireRules rules;
  switch (kind) {
    case 0x0000:  // CDR_BE
    case 0x0001:  // CDR_LE
      break;
    case 0x0006:  // CDR2_BE
    case 0x0007:  // CDR2_LE
    case 0x0010:
    case 0x0011:
      rules.alignment = 4;
      rules.delimits_arrays = true;
      break;
    default:
      return std::nullopt;
  }
  rules.swap = (kind & 1U) == 0;
  return rules;
}

std::string hexadecimal(std::uint32_t kind) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "0x";
  for (const unsigned shift : {12U, 8U, 4U, 0U}) {
    text += kDigits[(kind >> shift) & 0xFU];
  }
  return text;
}

bool has_wide_text(const MessageType& type) noexcept {
  return std::ranges::any_of(type.structures, [](const Structure& structure) {
    return std::ranges::any_of(structure.fields,
                               [](const Field& field) { return field.kind == FieldKind::wstring; });
  });
}

}  // namespace

bool decode(const MessageType& type,
            std::span<const std::byte> cdr,
            Value& out,
            std::string& problem) {
  if (cdr.size() < kHeaderBytes) {
    problem = "the message has " + std::to_string(cdr.size()) + " bytes, fewer than the header";
    return false;
  }
  const std::uint32_t kind =
      std::to_integer<std::uint32_t>(cdr[0]) << 8U | std::to_integer<std::uint32_t>(cdr[1]);
  auto rules = rules_of(kind);
  if (!rules) {
    problem = "the encapsulation " + hexadecimal(kind) +
              " of the message is not plain CDR (parameter lists and delimited types are not read)";
    return false;
  }
  const std::span<const std::byte> body = cdr.subspan(kHeaderBytes);
  if (read_message(type, body, *rules, out, problem)) {
    return true;
  }
  if (!has_wide_text(type)) {
    return false;
  }
  // Middlewares differ in the bytes of a wide character, and no header says which it was.
  std::string ignored;
  rules->wide_character = 2;
  if (!read_message(type, body, *rules, out, ignored)) {
    return false;
  }
  problem.clear();
  return true;
}

bool decode_ros1(const MessageType& type,
                 std::span<const std::byte> bytes,
                 Value& out,
                 std::string& problem) {
  WireRules rules;
  rules.alignment = 1;
  rules.ends_text_with_zero = false;
  rules.fills_empty = false;
  rules.padding = 0;
  return read_message(type, bytes, rules, out, problem);
}

}  // namespace tcert::recording
