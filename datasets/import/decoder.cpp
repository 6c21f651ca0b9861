#include "datasets/import/decoder.hpp"

#include <table/diagnostic.hpp>
#include <utility>

namespace tcert::recording {

Decoder::Decoder(Encoding encoding, MessageType type)
    : encoding_(encoding), type_(std::move(type)) {}

std::optional<Decoder> Decoder::of(const Topic& topic, std::string& problem) {
  if (topic.encoding == "json") {
    return Decoder(Encoding::json, {});
  }
  const bool is_ros1 = topic.encoding == "ros1";
  if (!is_ros1 && topic.encoding != "cdr") {
    problem = "its messages are encoded as '" + table::shortened(topic.encoding) +
              "', which is not read: only cdr, ros1 and json are";
    return std::nullopt;
  }
  const bool has_text =
      topic.definition_encoding == "ros2msg" || topic.definition_encoding == "ros1msg";
  // A type without fields has an empty text.
  const bool is_empty = has_text && topic.definition.empty() && !builtin_definition(topic.type);
  const std::string_view text = has_text ? std::string_view(topic.definition) : "";
  auto type = message_type(topic.type, is_empty ? "\n" : text, problem, is_ros1);
  if (!type) {
    if (!has_text && !topic.definition.empty()) {
      problem = "its type is defined in '" + table::shortened(topic.definition_encoding) +
                "', which is not read: only ros2msg and ros1msg are";
    }
    return std::nullopt;
  }
  return Decoder(is_ros1 ? Encoding::ros1 : Encoding::cdr, std::move(*type));
}

bool Decoder::operator()(std::span<const std::byte> data, Value& out, std::string& problem) const {
  switch (encoding_) {
    case Encoding::ros1:
      return decode_ros1(type_, data, out, problem);
    case Encoding::json:
      return decode_json(data, out, problem);
    case Encoding::cdr:
      break;
  }
  return decode(type_, data, out, problem);
}

const MessageType* Decoder::type() const noexcept {
  return encoding_ == Encoding::json ? nullptr : &type_;
}

}  // namespace tcert::recording
