#pragma once
/// \file
/// How an entry of the parameter table reads and writes its member. Internal to
/// parameter_table.cpp.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "analysis/trials/parameters.hpp"
#include "datasets/csv_write.hpp"

namespace tcert {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Range {
  double low = 0.0;
  double high = kInfinity;
  bool low_allowed = true;
};

inline constexpr Range kAboveZero{0.0, kInfinity, false};
inline constexpr Range kNotNegative{0.0, kInfinity, true};

inline std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

inline std::string accepted(const Range& range, std::string_view noun) {
  std::string text(noun);
  if (range.high < kInfinity) {
    return text + (range.low_allowed ? " from " : " above ") + number_text(range.low) +
           (range.low_allowed ? " to " : ", at most ") + number_text(range.high);
  }
  return text + (range.low_allowed ? ", " + number_text(range.low) + " or more"
                                   : " above " + number_text(range.low));
}

template <class Value>
std::optional<Value> read_number(std::string_view text, const Range& range) {
  Value value{};
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end) {
    return std::nullopt;
  }
  const auto number = static_cast<double>(value);
  const bool inside = (number > range.low || (range.low_allowed && number == range.low)) &&
                      number <= range.high && std::isfinite(number);
  return inside ? std::optional(value) : std::nullopt;
}

/// What every entry says, whatever the type of its value.
struct About {
  std::string_view key;
  std::string_view unit;
  Stage stage;
  std::string_view doc;
};

template <class Group, class Value>
ParameterInfo number(const About& about,
                     Group ParameterSet::*group,
                     Value Group::*member,
                     const Range& range) {
  const std::string_view noun = std::is_integral_v<Value> ? "a whole number" : "a number";
  return {about.key,
          about.unit,
          about.doc,
          about.stage,
          accepted(range, noun),
          [=](const ParameterSet& set) {
            if constexpr (std::is_integral_v<Value>) {
              return std::to_string(set.*group.*member);
            } else {
              return number_text(set.*group.*member);
            }
          },
          [=](ParameterSet& set, std::string_view text) {
            const auto value = read_number<Value>(text, range);
            if (value) {
              set.*group.*member = *value;
            }
            return value.has_value();
          }};
}

inline ParameterInfo override_of(const About& about,
                                 std::optional<double> RobotOverrides::*member,
                                 const Range& range) {
  return {about.key,
          about.unit,
          about.doc,
          about.stage,
          accepted(range, "a number") + ", or 'bundle'",
          [=](const ParameterSet& set) {
            const std::optional<double> value = set.robot.*member;
            return value ? number_text(*value) : std::string("bundle");
          },
          [=](ParameterSet& set, std::string_view text) {
            if (text == "bundle") {
              (set.robot.*member).reset();
              return true;
            }
            const auto value = read_number<double>(text, range);
            if (value) {
              set.robot.*member = value;
            }
            return value.has_value();
          }};
}

/// `words` in the order of the enumerators.
template <class Group, class Word>
ParameterInfo word(const About& about,
                   Group ParameterSet::*group,
                   Word Group::*member,
                   std::vector<std::string_view> words) {
  std::string accepts;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    accepts += std::string(i == 0 ? "" : (last ? " or " : ", ")) + std::string(words[i]);
  }
  return {about.key,
          about.unit,
          about.doc,
          about.stage,
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

/// The members of CertificateParameters.
void add_certificate_entries(ParameterEntries& table);

/// The speed law, the guards, the routes and the replay.
void add_control_entries(ParameterEntries& table);

}  // namespace tcert
