// Prints a bag as lines of JSON, read by our reader: print_bag BAG. First a line with the topics,
// then one a message, last one with the problems. Integers beyond 2^53 are texts that end in n.

#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/decoder.hpp"

namespace {

using namespace tcert;
using namespace tcert::recording;
using nlohmann::json;

template <class T>
json integer_json(T value) {
  constexpr auto kExact = std::int64_t{1} << 53;
  const bool is_exact = std::in_range<std::int64_t>(value) &&
                        std::abs(static_cast<double>(value)) < static_cast<double>(kExact);
  return is_exact ? json(value) : json(std::to_string(value) + "n");
}

json double_json(double value) {
  if (std::isnan(value)) {
    return "NaN";
  }
  return std::isinf(value) ? json(value > 0 ? "Infinity" : "-Infinity") : json(value);
}

json value_json(const Value& value);

template <class T>
json alternative_json(const T& data) {
  if constexpr (std::is_same_v<T, std::monostate>) {
    return nullptr;
  } else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>) {
    return data;
  } else if constexpr (std::is_same_v<T, double>) {
    return double_json(data);
  } else if constexpr (std::is_integral_v<T>) {
    return integer_json(data);
  } else if constexpr (std::is_same_v<T, Flags>) {
    json list = json::array();
    for (const auto flag : data.values) {
      list.push_back(flag != 0);
    }
    return list;
  } else if constexpr (std::is_same_v<T, Object>) {
    json object = json::object();
    for (const Member& member : data) {
      object[member.name] = value_json(member.value);
    }
    return object;
  } else {
    json list = json::array();
    for (const auto& element : data) {
      if constexpr (std::is_same_v<T, Array>) {
        list.push_back(value_json(element));
      } else {
        list.push_back(alternative_json(element));
      }
    }
    return list;
  }
}

json value_json(const Value& value) {
  return std::visit([](const auto& data) { return alternative_json(data); }, value.data);
}

void print(const json& line) {
  std::puts(line.dump(-1, ' ', false, json::error_handler_t::replace).c_str());
}

json topics_json(const Bag& bag) {
  json list = json::array();
  for (const Topic& topic : bag.topics()) {
    list.push_back({{"name", topic.name},
                    {"type", topic.type},
                    {"encoding", topic.encoding},
                    {"messages", topic.messages}});
  }
  return list;
}

void print_messages(Bag& bag, table::DiagnosticGroups& problems) {
  std::vector<std::optional<Decoder>> decoders;
  std::vector<std::string> reasons(bag.topics().size());
  std::vector<std::size_t> wanted;
  for (const Topic& topic : bag.topics()) {
    decoders.push_back(Decoder::of(topic, reasons[wanted.size()]));
    wanted.push_back(wanted.size());
  }
  Value value;
  bag.for_each(
      wanted,
      [&](const RawMessage& message) {
        json line{{"topic", bag.topics()[message.topic].name},
                  {"log", std::to_string(message.log_ns)},
                  {"publish", std::to_string(message.publish_ns)},
                  {"bytes", message.data.size()}};
        std::string reason = reasons[message.topic];
        if (decoders[message.topic] && (*decoders[message.topic])(message.data, value, reason)) {
          line["value"] = value_json(value);
        } else {
          line["problem"] = reason;
        }
        print(line);
        return true;
      },
      problems);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("print_bag BAG\n", stderr);
    return 2;
  }
  table::DiagnosticGroups problems;
  const auto bag = open_bag(argv[1], problems);
  if (bag) {
    print({{"topics", topics_json(*bag)}});
    print_messages(*bag, problems);
  }
  json said = json::array();
  for (const table::Diagnostic& problem : problems.take()) {
    said.push_back(table::to_string(problem));
  }
  print({{"problems", said}});
  return bag ? 0 : 1;
}
