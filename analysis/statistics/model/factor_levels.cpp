#include <statistics/model/factor_levels.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <statistics/model/expression.hpp>
#include <table/csv_write.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

/// The number of 15 significant digits that R prints for `value`; 0 for -0.
double as_printed(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return value == 0.0 ? 0.0 : value;
  }
  constexpr int kDigits = 15;
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(
      text.data(), text.data() + text.size(), value, std::chars_format::scientific, kDigits - 1);
  double printed = value;
  std::from_chars(text.data(), end, printed);
  return printed;
}

/// Keys stay below levels times levels, whatever the number of factors that were crossed before.
table::Factor cross_of_two(const table::Factor& slow,
                           const table::Factor& fast,
                           const std::string& separator) {
  const std::size_t rows = slow.rows();
  const auto is_missing = [&](std::size_t row) {
    return slow.codes[row] == table::Factor::kMissing || fast.codes[row] == table::Factor::kMissing;
  };
  const auto key = [&](std::size_t row) {
    return std::uint64_t{slow.codes[row]} * fast.levels.size() + fast.codes[row];
  };
  std::vector<std::uint64_t> distinct;
  for (std::size_t row = 0; row < rows; ++row) {
    if (!is_missing(row)) {
      distinct.push_back(key(row));
    }
  }
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  table::Factor cross;
  for (const std::uint64_t one : distinct) {
    cross.levels.push_back(slow.levels[one / fast.levels.size()] + separator +
                           fast.levels[one % fast.levels.size()]);
  }
  for (std::size_t row = 0; row < rows; ++row) {
    const auto at = is_missing(row) ? distinct.end()
                                    : std::lower_bound(distinct.begin(), distinct.end(), key(row));
    cross.codes.push_back(at == distinct.end() ? table::Factor::kMissing
                                               : static_cast<std::uint32_t>(at - distinct.begin()));
  }
  return cross;
}

}  // namespace

table::Factor levels_by_value(const std::vector<double>& numbers) {
  std::vector<double> distinct;
  std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(distinct), [](double x) {
    return !std::isnan(x);
  });
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  table::Factor factor;
  std::vector<std::uint32_t> level_of;  // of each distinct number
  double last = 0.0;
  for (const double value : distinct) {
    const double printed = as_printed(value);
    if (factor.levels.empty() || printed != last) {
      factor.levels.emplace_back();
      table::append_number(factor.levels.back(), printed);
    }
    last = printed;
    level_of.push_back(static_cast<std::uint32_t>(factor.levels.size() - 1));
  }
  factor.codes.reserve(numbers.size());
  for (const double x : numbers) {
    const auto place = std::lower_bound(distinct.begin(), distinct.end(), x) - distinct.begin();
    factor.codes.push_back(std::isnan(x) ? table::Factor::kMissing
                                         : level_of[static_cast<std::size_t>(place)]);
  }
  return factor;
}

table::Factor levels_of_truth(const std::vector<double>& numbers) {
  table::Factor factor = levels_by_value(numbers);
  for (std::string& level : factor.levels) {
    level = level == "0" ? "FALSE" : "TRUE";
  }
  return factor;
}

void put_first(table::Factor& factor, const std::string& level, const std::string& column) {
  const auto found = std::find(factor.levels.begin(), factor.levels.end(), level);
  if (found == factor.levels.end()) {
    std::string known;
    for (const std::string& one : factor.levels) {
      known += (known.empty() ? "" : ", ") + one;
    }
    throw FormulaError("column '" + column + "' has no level '" + level + "', only " + known);
  }
  const auto chosen = static_cast<std::uint32_t>(found - factor.levels.begin());
  std::rotate(factor.levels.begin(), found, found + 1);
  for (std::uint32_t& code : factor.codes) {
    if (code != table::Factor::kMissing && code <= chosen) {
      code = code == chosen ? 0 : code + 1;
    }
  }
}

void name_levels(table::Factor& factor, const std::string& name) {
  for (std::string& level : factor.levels) {
    level.insert(0, name + '=');
  }
}

table::Factor crossed(const std::vector<table::Factor>& factors, const std::string& separator) {
  table::Factor cross = factors.front();
  for (std::size_t k = 1; k < factors.size(); ++k) {
    cross = cross_of_two(cross, factors[k], separator);
  }
  return cross;
}

table::Factor on_rows(const table::Factor& factor, const std::vector<std::size_t>& rows) {
  std::vector<std::uint32_t> new_code(factor.levels.size(), table::Factor::kMissing);
  for (const std::size_t row : rows) {
    if (factor.codes[row] != table::Factor::kMissing) {
      new_code[factor.codes[row]] = 0;
    }
  }
  table::Factor kept;
  for (std::size_t level = 0; level < new_code.size(); ++level) {
    if (new_code[level] != table::Factor::kMissing) {
      new_code[level] = static_cast<std::uint32_t>(kept.levels.size());
      kept.levels.push_back(factor.levels[level]);
    }
  }
  kept.codes.reserve(rows.size());
  for (const std::size_t row : rows) {
    const std::uint32_t code = factor.codes[row];
    kept.codes.push_back(code == table::Factor::kMissing ? code : new_code[code]);
  }
  return kept;
}

}  // namespace tcert::statistics
