#include <statistics/model/number_functions.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace tcert::statistics {
namespace {

constexpr std::array<NumberFunction, 12> kNumberFunctions{{
    {"log", [](double x) { return std::log(x); }},
    {"log2", [](double x) { return std::log2(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"log1p", [](double x) { return std::log1p(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"abs", [](double x) { return std::abs(x); }},
    {"I", [](double x) { return x; }},
    {"as.numeric", [](double x) { return x; }},
}};

constexpr std::array<NumberOperator, 11> kNumberOperators{{
    {"+", [](double a, double b) { return a + b; }, false},
    {"-", [](double a, double b) { return a - b; }, false},
    {"*", [](double a, double b) { return a * b; }, false},
    {"/", [](double a, double b) { return a / b; }, false},
    {"^", [](double a, double b) { return b == 2.0 ? a * a : std::pow(a, b); }, false},
    {"==", [](double a, double b) { return a == b ? 1.0 : 0.0; }, true},
    {"!=", [](double a, double b) { return a != b ? 1.0 : 0.0; }, true},
    {"<", [](double a, double b) { return a < b ? 1.0 : 0.0; }, true},
    {"<=", [](double a, double b) { return a <= b ? 1.0 : 0.0; }, true},
    {">", [](double a, double b) { return a > b ? 1.0 : 0.0; }, true},
    {">=", [](double a, double b) { return a >= b ? 1.0 : 0.0; }, true},
}};

template <class Table>
auto find_called(const Table& table, std::string_view name) noexcept {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

const NumberFunction* find_number_function(std::string_view name) noexcept {
  return find_called(kNumberFunctions, name);
}

const NumberOperator* find_number_operator(std::string_view name) noexcept {
  return find_called(kNumberOperators, name);
}

}  // namespace tcert::statistics
