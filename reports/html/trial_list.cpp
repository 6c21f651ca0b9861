#include "reports/html/trial_list.hpp"

#include <table/not_a_number.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "reports/html/packed.hpp"
#include "reports/html/trial_block.hpp"
#include "reports/table.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

constexpr std::size_t kNoRow = std::numeric_limits<std::size_t>::max();
constexpr double kSparkScale = 1000.0;

struct ListColumn {
  std::string_view name;
  std::string_view heading;
  std::string_view unit;
  int decimals;  ///< -1: text.
  bool choice;   ///< A few values, to filter by.
};

constexpr auto kColumns = std::to_array<ListColumn>({
    {"trial_id", "trial", "", -1, false},
    {"algorithm", "algorithm", "", -1, true},
    {"lighting", "lighting", "", -1, true},
    {"day", "day", "", -1, false},
    {"success", "success", "", 0, true},
    {"end_reason", "end", "", -1, true},
    {"time_s", "time", "s", 1, false},
    {"tc_early", "TC_early", "m", 3, false},
    {"issued", "issued", "", 0, true},
    {"issued_s", "issued at", "s", 1, false},
    {"certificate_m", "T_t", "m", 3, false},
    {"corridor_value_m", "V_t", "m", 3, false},
});

double parsed(std::string_view text) {
  double value = table::kNaN;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} && read.ptr == text.data() + text.size() ? value : table::kNaN;
}

Json json_cell(const TrialList& trials, std::size_t trial, const ListColumn& column) {
  const std::string_view text = trials.cell(trial, column.name);
  if (text.empty()) {
    return nullptr;
  }
  if (column.decimals < 0) {
    return std::string(text);
  }
  const double value = parsed(text);
  if (!std::isfinite(value)) {
    return nullptr;
  }
  return parsed(fixed(value, column.decimals));
}

Json json_spark(const Sparkline& spark, double& low, double& high) {
  Json json = Json::array();
  for (const double value : spark) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
      json.push_back(std::round(value * kSparkScale) / kSparkScale);
    } else {
      json.push_back(nullptr);
    }
  }
  return json;
}

}  // namespace

TrialList::TrialList(const std::optional<table::TextTable>& features,
                     const std::optional<table::TextTable>& certificates)
    : features_(features), certificates_(certificates) {
  if (!features && !certificates) {
    throw std::invalid_argument("a list of trials needs features or certificates");
  }
  std::map<std::string, std::size_t, std::less<>> row_of;
  if (certificates) {
    const std::size_t id = certificates->find("trial_id").value();
    for (std::size_t r = 0; r < certificates->rows(); ++r) {
      row_of.emplace(certificates->at(r, id), r);
    }
  }
  const table::TextTable& lead = features ? *features : *certificates;
  const std::size_t id = lead.find("trial_id").value();
  for (std::size_t r = 0; r < lead.rows(); ++r) {
    ids_.push_back(lead.at(r, id));
    const auto found = row_of.find(ids_.back());
    certificate_rows_.push_back(found == row_of.end() ? kNoRow : found->second);
  }
}

std::string_view TrialList::cell(std::size_t trial, std::string_view column) const {
  if (features_) {
    if (const auto c = features_->find(column)) {
      return features_->at(trial, *c);
    }
  }
  if (certificates_ && certificate_rows_[trial] != kNoRow) {
    if (const auto c = certificates_->find(column)) {
      return certificates_->at(certificate_rows_[trial], *c);
    }
  }
  return {};
}

double TrialList::number(std::size_t trial, std::string_view column) const {
  return parsed(cell(trial, column));
}

std::string TrialList::facts(std::size_t trial) const {
  std::string words;
  const auto add = [&](std::string_view before, std::string_view text) {
    if (!text.empty()) {
      words += words.empty() ? "" : ", ";
      words += before;
      words += text;
    }
  };
  add("", cell(trial, "algorithm"));
  add("", cell(trial, "lighting"));
  add("day ", cell(trial, "day"));
  const std::string_view success = cell(trial, "success");
  if (!success.empty()) {
    words += words.empty() ? "" : ": ";
    words += success == "1" ? "success" : "failure";
    if (const double time_s = number(trial, "time_s"); std::isfinite(time_s)) {
      words += " after " + fixed(time_s, 1) + " s";
    }
  }
  words += words.empty() ? "" : ". ";
  const double certificate_m = number(trial, "certificate_m");
  words += std::isfinite(certificate_m) ? "Certificate " + fixed(certificate_m, 3) + " m"
                                        : std::string("No way from S to G was found");
  if (cell(trial, "issued") == "1") {
    words += ", issued at " + fixed(number(trial, "issued_s"), 1) + " s";
  } else {
    words += ", not issued";
  }
  return words + ".";
}

Sparkline sparkline(const table::NumberTable& series) {
  const auto& columns = page_series_columns();
  const auto position = [&](std::string_view name) {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                    columns.begin());
  };
  const std::size_t certificate = position("certificate_m");
  const std::size_t corridor = position("corridor_value_m");
  const std::size_t issued = position("issued");
  Sparkline spark;
  std::size_t tick = 0;
  const std::int64_t first = series.time_ns.front();
  const std::int64_t span = series.time_ns.back() - first;
  for (std::size_t p = 0; p < kSparkPoints; ++p) {
    const std::int64_t time_ns =
        first + span / static_cast<std::int64_t>(kSparkPoints - 1) * static_cast<std::int64_t>(p);
    while (tick + 1 < series.rows() && series.time_ns[tick + 1] <= time_ns) {
      ++tick;
    }
    spark.push_back(series.at(tick, series.at(tick, issued) == 1.0 ? certificate : corridor));
  }
  return spark;
}

std::string trial_list_block(const TrialList& trials, const std::vector<Sparkline>& sparks) {
  Json json;
  json["columns"] = Json::array();
  json["rows"] = Json::array();
  std::vector<const ListColumn*> shown;
  for (const ListColumn& column : kColumns) {
    bool any = false;
    for (std::size_t t = 0; t < trials.size() && !any; ++t) {
      any = !trials.cell(t, column.name).empty();
    }
    if (any) {
      shown.push_back(&column);
      json["columns"].push_back({{"name", column.name},
                                 {"heading", column.heading},
                                 {"unit", column.unit},
                                 {"decimals", column.decimals},
                                 {"numeric", column.decimals >= 0},
                                 {"choice", column.choice}});
    }
  }
  for (std::size_t t = 0; t < trials.size(); ++t) {
    Json row = Json::array();
    for (const ListColumn* column : shown) {
      row.push_back(json_cell(trials, t, *column));
    }
    json["rows"].push_back(std::move(row));
  }
  double low = 0.0;
  double high = 0.0;
  json["spark"] = Json::array();
  for (const Sparkline& spark : sparks) {
    json["spark"].push_back(json_spark(spark, low, high));
  }
  json["spark_range"] = Json::array({low, high});
  return packed(dumped(json, -1));
}

}  // namespace tcert
