#pragma once
/// \file
/// How an entry of the parameter table reads and writes its member. Internal to
/// parameter_table.cpp.

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <table/csv_write.hpp>
#include <tcert/parameter_fields.hpp>
#include <type_traits>
#include <vector>

#include "analysis/study/trials/parameters.hpp"

namespace tcert::study {

inline std::string number_text(double value) {
  std::string text;
  table::append_number(text, value);
  return text;
}

template <class Value>
std::optional<Value> read_number(std::string_view text, const FieldBounds& bounds) {
  Value value{};
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end) {
    return std::nullopt;
  }
  return bounds.contain(static_cast<double>(value)) ? std::optional(value) : std::nullopt;
}

template <class Group, class Value>
ParameterInfo entry_of(const NumberField& field,
                       Stage stage,
                       Group ParameterSet::*group,
                       Value Group::*member) {
  const std::string noun = std::is_integral_v<Value> ? "a whole number " : "a number ";
  return {field.key,
          field.unit,
          field.text,
          stage,
          noun + to_string(field.bounds),
          [=](const ParameterSet& set) {
            if constexpr (std::is_integral_v<Value>) {
              return std::to_string(set.*group.*member);
            } else {
              return number_text(set.*group.*member);
            }
          },
          [=, bounds = field.bounds](ParameterSet& set, std::string_view text) {
            const auto value = read_number<Value>(text, bounds);
            if (value) {
              set.*group.*member = *value;
            }
            return value.has_value();
          }};
}

/// Of a number that may be left at what it would be anyway, which `usual` calls.
template <class Group>
ParameterInfo override_of(const NumberField& field,
                          Stage stage,
                          Group ParameterSet::*group,
                          std::optional<double> Group::*member,
                          std::string_view usual) {
  return {field.key,
          field.unit,
          field.text,
          stage,
          "a number " + to_string(field.bounds) + ", or '" + std::string(usual) + "'",
          [=](const ParameterSet& set) {
            const std::optional<double> value = set.*group.*member;
            return value ? number_text(*value) : std::string(usual);
          },
          [=, bounds = field.bounds](ParameterSet& set, std::string_view text) {
            if (text == usual) {
              (set.*group.*member).reset();
              return true;
            }
            const auto value = read_number<double>(text, bounds);
            if (value) {
              set.*group.*member = value;
            }
            return value.has_value();
          }};
}

/// "width radial swept": three words.
inline std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> found;
  while (!words.empty()) {
    const std::size_t space = std::min(words.find(' '), words.size());
    found.push_back(words.substr(0, space));
    words.remove_prefix(std::min(space + 1, words.size()));
  }
  return found;
}

template <class Group, class Word>
ParameterInfo entry_of(const WordField& field,
                       Stage stage,
                       Group ParameterSet::*group,
                       Word Group::*member) {
  const std::vector<std::string_view> words = split(field.words);
  std::string accepts;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    accepts += std::string(i == 0 ? "" : (last ? " or " : ", ")) + std::string(words[i]);
  }
  return {field.key,
          "",
          field.text,
          stage,
          accepts,
          [=](const ParameterSet& set) {
            return std::string(words[static_cast<std::size_t>(set.*group.*member)]);
          },
          [=](ParameterSet& set, std::string_view text) {
            const auto found = std::find(words.begin(), words.end(), text);
            if (found != words.end()) {
              set.*group.*member = static_cast<Word>(found - words.begin());
            }
            return found != words.end();
          }};
}

using ParameterEntries = std::vector<ParameterInfo>;

/// The members of a declared list, in its order.
template <class Group>
void add_fields(ParameterEntries& table, Stage stage, Group ParameterSet::*group) {
  visit_fields(Group{}, [&](const auto& field, auto member) {
    table.push_back(entry_of(field, stage, group, member));
  });
}

}  // namespace tcert::study
