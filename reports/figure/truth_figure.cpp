#include "reports/figure/set_figures.hpp"

#include <table/not_a_number.hpp>

#include <cmath>
#include <utility>

#include "reports/figure/figure_parts.hpp"
#include "reports/figure/figure_table.hpp"

namespace tcert {
namespace {

constexpr const char* kSuccess = "success (dot: upper bound of T)";
constexpr const char* kFailure = "failure (dot: upper bound of T)";
constexpr const char* kUnknown = "outcome not known (dot: upper bound of T)";
constexpr const char* kRefuted = "T_t above the upper bound: refuted";

const char* outcome(double success) {
  return std::isnan(success) ? kUnknown : success == 1.0 ? kSuccess : kFailure;
}

}  // namespace

std::optional<Figure> truth_figure(const table::DataTable& features,
                                   const std::optional<SyntheticLabel>& synthetic) {
  Figure figure = named("truth", "The certificate against the truth", synthetic);
  figure.caption =
      "T(E; A), the best margin that any path through the known world has, as the interval that is "
      "proven, against the certificate T_t at the end of the trial. The dot is the interval's "
      "upper bound: a certificate is refuted if it is larger, which is a dot below the dashed "
      "diagonal. Where the diagonal crosses an interval, T may be on either side of T_t.";
  figure.key = {"", {kSuccess, kFailure, kUnknown, kRefuted}};
  figure.data = figure_table(
      "truth", {"trial_id", "outcome"}, {"certificate_m", "truth_lower_m", "truth_upper_m"});
  Extent extent;
  for (std::size_t row = 0; row < features.rows; ++row) {
    const double certificate = number_at(features, row, "certificate_m");
    const double low = number_at(features, row, "truth_lower_m");
    const double high = number_at(features, row, "truth_upper_m");
    if (!std::isfinite(certificate) || !std::isfinite(high)) {
      continue;
    }
    for (const double value : {certificate, low, high}) {
      extent.add(value);
    }
    const std::vector<std::string> texts = {text_at(features, row, "trial_id"),
                                            outcome(number_at(features, row, "success"))};
    add_figure_row(figure.data, "trial", texts, {certificate, low, high});
    if (certificate > high) {
      add_figure_row(figure.data, "refuted", texts, {certificate, low, high});
    }
  }
  add_figure_row(figure.data, "equal", {"", ""}, {extent.low, table::kNaN, extent.low});
  add_figure_row(figure.data, "equal", {"", ""}, {extent.high, table::kNaN, extent.high});
  Panel one;
  one.x = axis("certificate T_t", "m");
  one.y = axis("truth T(E; A)", "m");
  extent.apply(one.x);
  extent.apply(one.y);
  Layer range = range_y("trial", "certificate_m", "truth_lower_m", "truth_upper_m");
  range.colour = "outcome";
  range.width = 0.8;
  Layer upper = layer(Mark::point, "trial", "certificate_m", "truth_upper_m");
  upper.colour = "outcome";
  upper.size = 0.7;
  Layer refuted = layer(Mark::point, "refuted", "certificate_m", "truth_upper_m");
  refuted.label = kRefuted;
  refuted.size = 2.4;
  refuted.hollow = true;
  one.layers = {range, guide("equal", "certificate_m", "truth_upper_m"), upper, refuted};
  one.height = 1.4;
  figure.panels = {std::move(one)};
  return finished(std::move(figure));
}

}  // namespace tcert
