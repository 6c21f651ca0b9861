#include "datasets/import/column_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <table/name_words.hpp>
#include <vector>

namespace tcert::recording {
namespace {

using Words = std::vector<std::string>;

constexpr std::array<std::string_view, 9> kMotionWords = {
    "linear", "twist", "vel", "velocity", "acc", "accel", "torque", "covariance", "v"};
constexpr std::array<std::string_view, 5> kTurnWords = {
    "orientation", "rotation", "quat", "quaternion", "q"};
constexpr std::array<std::string_view, 4> kYawWords = {"yaw", "heading", "theta", "psi"};
constexpr std::array<std::string_view, 4> kBendWords = {"bend", "flex", "deflection", "curl"};
constexpr std::array<std::string_view, 7> kRangeWords = {
    "range", "dist", "distance", "sonar", "tof", "lidar", "ranges"};
constexpr std::array<std::string_view, 7> kSides = {
    "left", "right", "front", "rear", "back", "ahead", "side"};
constexpr std::array<std::string_view, 4> kForceWords = {"force", "fsr", "load", "pressure"};
constexpr std::array<std::string_view, 3> kSpeedWords = {"speed", "vel", "velocity"};
constexpr std::array<std::string_view, 2> kSideWords = {"y", "z"};

struct UnitWord {
  std::string_view word;
  std::string_view unit;  ///< As a map has it; empty: ours.
};

constexpr std::array kUnitWords{UnitWord{"m", ""},
                                UnitWord{"cm", "cm"},
                                UnitWord{"mm", "mm"},
                                UnitWord{"rad", ""},
                                UnitWord{"deg", "deg"},
                                UnitWord{"degrees", "deg"},
                                UnitWord{"n", ""},
                                UnitWord{"g", "g"},
                                UnitWord{"grams", "g"},
                                UnitWord{"kg", "kg"},
                                UnitWord{"mps", ""},
                                UnitWord{"rps", ""},
                                UnitWord{"radps", ""},
                                UnitWord{"dps", "deg/s"},
                                UnitWord{"degps", "deg/s"}};

bool holds(const Words& words, std::span<const std::string_view> some) {
  return std::ranges::any_of(words, [some](const std::string& word) {
    return std::ranges::find(some, word) != some.end();
  });
}

bool holds(const Words& words, std::string_view one) {
  return std::ranges::find(words, one) != words.end();
}

ColumnRole place_or_turn(const Words& words) {
  const std::string& last = words.back();
  const bool turns = holds(words, kTurnWords);
  if (last == "qx" || (turns && last == "x")) {
    return ColumnRole::quaternion_x;
  }
  if (last == "qy" || (turns && last == "y")) {
    return ColumnRole::quaternion_y;
  }
  if (last == "qz" || (turns && last == "z")) {
    return ColumnRole::quaternion_z;
  }
  if (last == "qw" || (turns && last == "w")) {
    return ColumnRole::quaternion_w;
  }
  if (holds(words, kMotionWords) || holds(words, "angular") || holds(words, kForceWords)) {
    return ColumnRole::other;
  }
  if (last == "x" || last == "tx" || last == "px") {
    return ColumnRole::x;
  }
  if (last == "y" || last == "ty" || last == "py") {
    return ColumnRole::y;
  }
  return ColumnRole::other;
}

ColumnRole role_of_words(const Words& words) {
  if (words.empty() || holds(words, "covariance") || holds(words, "stamp")) {
    return ColumnRole::other;
  }
  const bool is_rate = holds(words, "rate") || holds(words, "omega") || holds(words, "yawrate") ||
                       (holds(words, "angular") && words.back() == "z");
  if (is_rate) {
    return ColumnRole::yaw_rate;
  }
  if (holds(words, kYawWords)) {
    return ColumnRole::yaw;
  }
  if (const ColumnRole role = place_or_turn(words); role != ColumnRole::other) {
    return role;
  }
  if (holds(words, kBendWords)) {
    return ColumnRole::bend;
  }
  if (holds(words, kForceWords) && words.back() != "x" && words.back() != "y" &&
      words.back() != "z") {
    return ColumnRole::force;
  }
  if (holds(words, kRangeWords) && !holds(words, "min") && !holds(words, "max")) {
    return ColumnRole::range;
  }
  const bool is_speed =
      holds(words, kSpeedWords) || (holds(words, "linear") && words.back() == "x");
  if (is_speed && !holds(words, kSideWords) && !holds(words, "angular")) {
    return ColumnRole::speed;
  }
  return ColumnRole::other;
}

std::string unit_by_size(ColumnRole role, double magnitude) {
  switch (role) {
    case ColumnRole::yaw:
      return magnitude > 7.0 ? "deg" : "";
    case ColumnRole::bend:
      return magnitude > 3.5 ? "deg" : "";
    case ColumnRole::range:
      return magnitude > 100.0 ? "mm" : "";
    case ColumnRole::force:
      return magnitude > 50.0 ? "g" : "";
    case ColumnRole::yaw_rate:
      return magnitude > 10.0 ? "deg/s" : "";
    default:
      return "";
  }
}

}  // namespace

ColumnGuess guess_column(std::string_view name,
                         std::optional<double> least,
                         std::optional<double> largest) {
  Words words;
  for (std::string& word : table::name_words(name)) {
    // The number of a sensor is no word: range1 is range.
    word.erase(
        std::remove_if(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; }),
        word.end());
    if (!word.empty()) {
      words.push_back(std::move(word));
    }
  }
  const UnitWord* unit = nullptr;
  if (words.size() > 1) {
    const auto* const found = std::ranges::find(kUnitWords, words.back(), &UnitWord::word);
    if (found != kUnitWords.end()) {
      unit = found;
      words.pop_back();
    }
  }
  ColumnGuess guess;
  guess.role = role_of_words(words);
  const bool is_length =
      unit != nullptr && (unit->word == "mm" || unit->word == "cm" || unit->word == "m");
  if (guess.role == ColumnRole::other && is_length && holds(words, kSides)) {
    guess.role = ColumnRole::range;
  }
  if (guess.role == ColumnRole::other) {
    return guess;
  }
  const double magnitude = std::max(std::abs(least.value_or(0.0)), std::abs(largest.value_or(0.0)));
  guess.unit = unit != nullptr ? std::string(unit->unit) : unit_by_size(guess.role, magnitude);
  return guess;
}

std::string_view to_string(ColumnRole role) noexcept {
  constexpr std::array<std::string_view, 13> kWords = {"",
                                                       "x",
                                                       "y",
                                                       "yaw",
                                                       "quaternion x",
                                                       "quaternion y",
                                                       "quaternion z",
                                                       "quaternion w",
                                                       "speed",
                                                       "yaw rate",
                                                       "bend",
                                                       "range",
                                                       "force"};
  return kWords[static_cast<std::size_t>(role)];
}

}  // namespace tcert::recording
