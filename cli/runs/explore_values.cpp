#include "cli/runs/explore_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <table/csv.hpp>
#include <terrain/limits.hpp>

#include "cli/runs/data_file.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

terrain::Cell cell_of(const std::string& option, const std::string& text) {
  terrain::Cell cell;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, cell.x);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == ',') {
    const auto second = std::from_chars(first.ptr + 1, end, cell.y);
    if (second.ec == std::errc{} && second.ptr == end) {
      return cell;
    }
  }
  throw UsageError("--" + option + ": found '" + text +
                   "', expected a cell as X,Y with whole numbers");
}

std::vector<terrain::Cell> cells_of(const std::string& option, const std::string& text) {
  std::vector<terrain::Cell> cells;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    cells.push_back(cell_of(option, text.substr(at, end - at)));
    at = end + 1;
  }
  return cells;
}

terrain::Body body_of(const std::string& text) {
  terrain::Body body;
  if (text.empty()) {
    return body;
  }
  const std::vector<double> v = numbers_of("body", text);
  const double most = terrain::limit_of("body").high;
  const bool is_good = !v.empty() && v.size() <= 3 && v[0] > 0.0 && v[0] <= most &&
                       (v.size() < 2 || (v[1] > 0.0 && v[1] <= most)) &&
                       (v.size() < 3 || std::abs(v[2]) <= 360.0);
  if (!is_good) {
    throw UsageError(fmt::format(
        "--body: found '{}', expected a radius R, or LENGTH,WIDTH[,YAW], above 0 and at most {:g} "
        "cells, YAW within 360 degrees",
        text,
        most));
  }
  if (v.size() == 1) {
    body.kind = terrain::Body::Kind::disc;
    body.radius = v[0];
    return body;
  }
  body.kind = terrain::Body::Kind::box;
  body.length = v[0];
  body.width = v[1];
  body.yaw = v.size() == 3 ? v[2] * std::numbers::pi / 180.0 : 0.0;
  return body;
}

terrain::GradientPrior gradient_prior_of(const std::string& text) {
  if (text.empty()) {
    return {};
  }
  const std::vector<double> v = numbers_of("gradient-prior", text);
  const double most = terrain::limit_of("gradient-prior").high;
  if (v.size() != 2 || !(v[0] > 0.0 && v[0] <= most) || !(v[1] > 0.0 && v[1] <= most)) {
    throw UsageError("--gradient-prior: found '" + text +
                     "', expected SD,PLACES: the standard deviation of the slope along one axis "
                     "and the number of places it is worth, both above 0");
  }
  return {v[0], v[1]};
}

std::vector<terrain::Measurement> known_of(const std::string& path,
                                           const terrain::Grid& grid,
                                           const terrain::CellSet& blocked) {
  std::vector<terrain::Measurement> known;
  if (path.empty()) {
    return known;
  }
  const table::BytesResult file = table::read_file(path);
  if (!file.bytes) {
    throw NoInput("cannot read '" + path + "': " + file.problem);
  }
  table::CsvOptions csv;
  csv.file = path;
  table::NumberOptions options;
  options.time_column.clear();
  options.columns = {{"x"}, {"y"}, {"value"}};
  table::DiagnosticGroups problems;
  const auto table = table::read_numbers(*file.bytes, csv, options, problems);
  for (std::size_t row = 0; table && row < table->rows(); ++row) {
    const terrain::Position at(table->at(row, 0), table->at(row, 1));
    const terrain::Cell c =
        terrain::is_near(at) ? terrain::nearest_cell(at) : terrain::Cell{-1, -1};
    const auto fail = [&](const char* column, double value, std::string expected) {
      problems.add({table::Severity::error,
                    path,
                    table->lines[row],
                    column,
                    fmt::format("{}", value),
                    std::move(expected),
                    1});
    };
    if (!grid.contains(c)) {
      fail("x", at.x(), fmt::format("cells of the terrain of {} x {}", grid.rows, grid.columns));
    } else if (!blocked.empty() && blocked[grid.index(c)] != 0) {
      fail("x", at.x(), "cells that are neither obstacles nor gaps");
    } else if (!(std::abs(table->at(row, 2)) <= terrain::kLargestValue)) {
      fail("value", table->at(row, 2), "a number within +-1e30");
    }
    known.push_back({at, table->at(row, 2)});
  }
  if (!table || problems.has_error()) {
    const std::vector<table::Diagnostic> all = problems.take();
    throw BadData(all.empty() ? "'" + path + "' holds no measurements" : to_string(all.front()));
  }
  return known;
}

}  // namespace tcert::cli
