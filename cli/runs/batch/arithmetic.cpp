#include "cli/runs/batch/arithmetic.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <table/random.hpp>

#include "reports/sha256.hpp"

namespace tcert::cli {
namespace {

constexpr std::uint32_t kPurpose = 0xa1;
constexpr std::size_t kPoints = 4000;

using Function = double (*)(double);

/// Of one positive argument; those of two take it and another one.
constexpr std::array<Function, 20> kFunctions{[](double x) { return std::exp(x); },
                                              [](double x) { return std::exp(-x); },
                                              [](double x) { return std::exp2(x); },
                                              [](double x) { return std::expm1(-x); },
                                              [](double x) { return std::log(x); },
                                              [](double x) { return std::log2(x); },
                                              [](double x) { return std::log10(x); },
                                              [](double x) { return std::log1p(x); },
                                              [](double x) { return std::sin(x); },
                                              [](double x) { return std::cos(x); },
                                              [](double x) { return std::tan(x); },
                                              [](double x) { return std::atan(x); },
                                              [](double x) { return std::asin(1.0 / (1.0 + x)); },
                                              [](double x) { return std::acos(1.0 / (1.0 + x)); },
                                              [](double x) { return std::sinh(x); },
                                              [](double x) { return std::tanh(x); },
                                              [](double x) { return std::cbrt(x); },
                                              [](double x) { return std::erf(x); },
                                              [](double x) { return std::erfc(x); },
                                              [](double x) { return std::lgamma(x); }};

using FunctionOfTwo = double (*)(double, double);

constexpr std::array<FunctionOfTwo, 4> kFunctionsOfTwo{
    [](double x, double y) { return std::pow(x, y); },
    [](double x, double y) { return std::atan2(x - 10.0, y - 10.0); },
    [](double x, double y) { return std::hypot(x, y); },
    [](double x, double y) { return std::fmod(x, y); }};

using LongFunction = long double (*)(long double);

/// Boost.Math computes in them, and processors of different makers need not agree.
constexpr std::array<LongFunction, 5> kLongFunctions{
    [](long double x) { return std::exp(-x); },
    [](long double x) { return std::log(x); },
    [](long double x) { return std::log1p(x); },
    [](long double x) { return std::expm1(-x); },
    [](long double x) { return std::pow(x, 0.5L * x); }};

std::string digest() {
  Sha256 sum;
  const auto add = [&](double value) {
    sum.update({reinterpret_cast<const char*>(&value), sizeof value});
  };
  table::RandomStream random(1, kPurpose, 0);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double x = random.uniform(1e-6, 20.0);
    const double y = random.uniform(1e-6, 20.0);
    for (const Function function : kFunctions) {
      add(function(x));
    }
    for (const FunctionOfTwo function : kFunctionsOfTwo) {
      add(function(x, y));
    }
    for (const LongFunction function : kLongFunctions) {
      const long double value = function(static_cast<long double>(x));
      const auto nearest = static_cast<double>(value);
      add(nearest);
      add(static_cast<double>(value - static_cast<long double>(nearest)));
    }
  }
  return sum.finish();
}

}  // namespace

const std::string& arithmetic_digest() {
  static const std::string text = digest();
  return text;
}

}  // namespace tcert::cli
