#include "datasets/import/unit_word.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <table/nearest_name.hpp>

namespace tcert::recording {
namespace {

struct Unit {
  std::string_view ending;  ///< Of the names of our columns of that quantity.
  std::string_view word;
  double scale;
};

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kGramN = 9.80665e-3;

constexpr std::array kUnits{Unit{"_m", "m", 1.0},         Unit{"_m", "cm", 0.01},
                            Unit{"_m", "mm", 0.001},      Unit{"_rad", "rad", 1.0},
                            Unit{"_rad", "deg", kDegree}, Unit{"_n", "N", 1.0},
                            Unit{"_n", "g", kGramN},      Unit{"_n", "kg", 1000.0 * kGramN},
                            Unit{"_mps", "m/s", 1.0},     Unit{"_mps", "cm/s", 0.01},
                            Unit{"_mps", "mm/s", 0.001},  Unit{"_mps", "km/h", 1.0 / 3.6},
                            Unit{"_rps", "rad/s", 1.0},   Unit{"_rps", "deg/s", kDegree},
                            Unit{"_ms", "ms", 1.0},       Unit{"_ms", "s", 1000.0},
                            Unit{"_ms", "us", 0.001},     Unit{"_s", "s", 1.0},
                            Unit{"_s", "ms", 1e-3},       Unit{"_s", "us", 1e-6},
                            Unit{"_s", "ns", 1e-9},       Unit{"_s", "min", 60.0}};

std::string_view ending_of(std::string_view name) noexcept {
  const std::size_t mark = name.rfind('_');
  return mark == std::string_view::npos ? std::string_view{} : name.substr(mark);
}

}  // namespace

std::optional<double> unit_scale(std::string_view name, std::string_view unit) {
  const auto* const found = std::ranges::find_if(kUnits, [&](const Unit& one) {
    return one.ending == ending_of(name) &&
           table::case_folded(one.word) == table::case_folded(unit);
  });
  return found == kUnits.end() ? std::nullopt : std::optional(found->scale);
}

std::vector<std::string> units_of(std::string_view name) {
  std::vector<std::string> words;
  for (const Unit& unit : kUnits) {
    if (unit.ending == ending_of(name)) {
      words.emplace_back(unit.word);
    }
  }
  return words;
}

}  // namespace tcert::recording
