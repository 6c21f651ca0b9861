#include <statistics/model/basis_functions.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <statistics/basics/quantile.hpp>
#include <statistics/model/expression.hpp>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

constexpr std::size_t kOrder = 4;
constexpr std::int64_t kMostColumns = 100;

/// The B-splines of some order at x (de Boor's recursion); x at the last knot belongs to the last
/// span.
std::vector<double> b_splines(const std::vector<double>& knots, double x, std::size_t order) {
  std::vector<double> values(knots.size() - 1, 0.0);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const bool last = x == knots.back() && knots[i + 1] == knots.back() && knots[i] < knots[i + 1];
    values[i] = (knots[i] <= x && x < knots[i + 1]) || last ? 1.0 : 0.0;
  }
  for (std::size_t k = 2; k <= order; ++k) {
    for (std::size_t i = 0; i + k < knots.size(); ++i) {
      const double left = knots[i + k - 1] - knots[i];
      const double right = knots[i + k] - knots[i + 1];
      values[i] = (left > 0.0 ? (x - knots[i]) / left * values[i] : 0.0) +
                  (right > 0.0 ? (knots[i + k] - x) / right * values[i + 1] : 0.0);
    }
  }
  values.resize(knots.size() - order);
  return values;
}

/// The `times`-th derivative of the cubic B-splines at x.
std::vector<double> derivative(const std::vector<double>& knots, double x, std::size_t times) {
  std::vector<double> values = b_splines(knots, x, kOrder - times);
  for (std::size_t k = kOrder - times + 1; k <= kOrder; ++k) {
    std::vector<double> next(knots.size() - k, 0.0);
    for (std::size_t i = 0; i < next.size(); ++i) {
      const double left = knots[i + k - 1] - knots[i];
      const double right = knots[i + k] - knots[i + 1];
      next[i] = static_cast<double>(k - 1) * ((left > 0.0 ? values[i] / left : 0.0) -
                                              (right > 0.0 ? values[i + 1] / right : 0.0));
    }
    values = std::move(next);
  }
  return values;
}

/// Applies a reflection that begins at place `at`.
void reflect(const std::vector<double>& by, std::size_t at, std::vector<double>& y) {
  double sum = 0.0;
  for (std::size_t i = at; i < y.size(); ++i) {
    sum += by[i] * y[i];
  }
  for (std::size_t i = at; i < y.size(); ++i) {
    y[i] -= sum / by[at] * by[i];
  }
}

/// Householder's of column `x` from place `at` on, with LINPACK's signs, which R's columns have.
std::vector<double> reflection_of(std::vector<double> x, std::size_t at) {
  double squares = 0.0;
  for (std::size_t i = at; i < x.size(); ++i) {
    squares += x[i] * x[i];
  }
  const double norm = std::copysign(std::sqrt(squares), x[at]);
  for (std::size_t i = at; i < x.size(); ++i) {
    x[i] /= norm;
  }
  x[at] += 1.0;
  return x;
}

void require_degree(std::int64_t degree, const std::string& text) {
  if (degree > kMostColumns) {
    throw FormulaError("'" + text + "': at most " + std::to_string(kMostColumns) + " columns");
  }
}

}  // namespace

NaturalSpline::NaturalSpline(const std::vector<double>& known,
                             const std::optional<std::int64_t>& df,
                             std::vector<double> knots,
                             const std::string& text) {
  const std::set<double> different(known.begin(), known.end());
  if (different.size() < 2 || std::isinf(*different.begin()) || std::isinf(*different.rbegin())) {
    throw FormulaError("'" + text + "': needs two finite numbers or more that differ");
  }
  require_degree(df.value_or(1), text);
  low_ = *different.begin();
  high_ = *different.rbegin();
  if (knots.empty() && df) {
    std::vector<double> sorted = known;
    std::sort(sorted.begin(), sorted.end());
    for (std::int64_t k = 1; k < *df; ++k) {
      knots.push_back(quantile(sorted, static_cast<double>(k) / static_cast<double>(*df)).value());
    }
  }
  std::sort(knots.begin(), knots.end());
  if (!knots.empty() && (knots.front() <= low_ || knots.back() >= high_ ||
                         static_cast<std::int64_t>(knots.size()) > kMostColumns)) {
    throw FormulaError("'" + text + "': knots lie within the range of the column");
  }
  knots_.assign(kOrder, low_);
  knots_.insert(knots_.end(), knots.begin(), knots.end());
  knots_.insert(knots_.end(), kOrder, high_);
  std::vector<std::vector<double>> bends;
  for (const double end : {low_, high_}) {
    std::vector<double> bend = derivative(knots_, end, 2);
    bend.erase(bend.begin());  // Without intercept.
    bends.push_back(std::move(bend));
  }
  for (std::size_t k = 0; k < bends.size(); ++k) {
    for (std::size_t before = 0; before < reflections_.size(); ++before) {
      reflect(reflections_[before], before, bends[k]);
    }
    reflections_.push_back(reflection_of(bends[k], k));
  }
}

std::vector<std::vector<double>> NaturalSpline::columns(const std::vector<double>& x) const {
  const std::size_t count = knots_.size() - kOrder - 3;
  std::vector<std::vector<double>> all(count, std::vector<double>(x.size(), table::kNaN));
  for (std::size_t row = 0; row < x.size(); ++row) {
    if (std::isnan(x[row])) {
      continue;
    }
    const double inside = std::clamp(x[row], low_, high_);
    std::vector<double> values = b_splines(knots_, inside, kOrder);
    if (inside != x[row]) {
      const std::vector<double> slope = derivative(knots_, inside, 1);
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] += (x[row] - inside) * slope[i];
      }
    }
    values.erase(values.begin());
    for (std::size_t k = 0; k < reflections_.size(); ++k) {
      reflect(reflections_[k], k, values);
    }
    for (std::size_t k = 0; k < count; ++k) {
      all[k][row] = values[k + 2];
    }
  }
  return all;
}

std::vector<std::vector<double>> orthogonal_powers(const std::vector<double>& known,
                                                   const std::vector<double>& x,
                                                   std::int64_t degree,
                                                   const std::string& text) {
  require_degree(degree, text);
  const std::set<double> different(known.begin(), known.end());
  if (static_cast<std::int64_t>(different.size()) <= degree) {
    throw FormulaError("'" + text + "': needs more different numbers than its degree");
  }
  // Monic polynomials p_(k+1) = (x - a_k) p_k - b_k p_(k-1), orthogonal on the known numbers.
  const auto columns = static_cast<std::size_t>(degree);
  std::vector<double> before(known.size(), 0.0);
  std::vector<double> now(known.size(), 1.0);
  std::vector<double> x_before(x.size(), 0.0);
  std::vector<double> x_now(x.size(), 1.0);
  double norm_before = 1.0;
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k <= columns; ++k) {
    double norm = 0.0;
    double moment = 0.0;
    for (std::size_t i = 0; i < known.size(); ++i) {
      norm += now[i] * now[i];
      moment += known[i] * now[i] * now[i];
    }
    if (k > 0) {
      std::vector<double> column(x.size());
      for (std::size_t i = 0; i < x.size(); ++i) {
        column[i] = std::isnan(x[i]) ? table::kNaN : x_now[i] / std::sqrt(norm);
      }
      all.push_back(std::move(column));
    }
    const double a = moment / norm;
    const double b = k == 0 ? 0.0 : norm / norm_before;
    const auto step = [&](double at, double& one, double& older) {
      const double next = (at - a) * one - b * older;
      older = one;
      one = next;
    };
    for (std::size_t i = 0; i < known.size(); ++i) {
      step(known[i], now[i], before[i]);
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      step(x[i], x_now[i], x_before[i]);
    }
    norm_before = norm;
  }
  return all;
}

std::vector<std::vector<double>> powers(const std::vector<double>& x,
                                        std::int64_t degree,
                                        const std::string& text) {
  require_degree(degree, text);
  std::vector<std::vector<double>> all{x};
  for (std::int64_t k = 2; k <= degree; ++k) {
    std::vector<double> next(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      next[i] = k == 2 ? x[i] * x[i] : std::pow(x[i], static_cast<double>(k));
    }
    all.push_back(std::move(next));
  }
  return all;
}

}  // namespace tcert::statistics
