/// The certificate against a program of another language that follows lib/README.md and shares no
/// code (scripts/reference_certificate.py): every column, at ticks of whole random runs, under
/// parameters that matter. A formula that is wrong in the same way on both sides of a comparison
/// of the library with itself is seen here.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tcert/certifier.hpp>
#include <vector>

#include "support/random_run.hpp"

namespace tcert {
namespace {

double value_of(const CertifiedTick& tick, const std::string& column) {
  static const std::map<std::string, double CertifiedTick::*> kNumbers = {
      {"travel_m", &CertifiedTick::travel_m},
      {"left_m", &CertifiedTick::left_m},
      {"right_m", &CertifiedTick::right_m},
      {"width_m", &CertifiedTick::width_m},
      {"turn_radius_m", &CertifiedTick::turn_radius_m},
      {"margin_m", &CertifiedTick::margin_m},
      {"edge_margin_m", &CertifiedTick::edge_margin_m},
      {"memory", &CertifiedTick::memory},
      {"corridor_value_m", &CertifiedTick::corridor_value_m},
      {"certificate_m", &CertifiedTick::certificate_m}};
  static const std::map<std::string, std::uint32_t CertifiedTick::*> kCounts = {
      {"contacts", &CertifiedTick::contacts},
      {"new_contacts", &CertifiedTick::new_contacts},
      {"nodes", &CertifiedTick::nodes},
      {"edges", &CertifiedTick::edges}};
  if (const auto number = kNumbers.find(column); number != kNumbers.end()) {
    return tick.*number->second;
  }
  return tick.*kCounts.at(column);
}

template <class Group>
void change(Group& group, const std::string& key, const nlohmann::json& value) {
  visit_fields(group, [&](const auto& field, auto member) {
    using Value = std::decay_t<decltype(group.*member)>;
    if (field.key != key) {
      return;
    }
    if constexpr (std::is_enum_v<Value>) {
      const std::string words = " " + std::string(field.words) + " ";
      const auto at = words.find(" " + value.get<std::string>() + " ");
      ASSERT_NE(at, std::string::npos) << value;
      group.*member = static_cast<Value>(
          std::count(words.begin() + 1, words.begin() + static_cast<std::ptrdiff_t>(at) + 1, ' '));
    } else {
      group.*member = value.get<Value>();
    }
  });
}

TEST(CertificateGolden, EveryColumnIsThatOfAnotherProgram) {
  const auto golden =
      nlohmann::json::parse(std::ifstream(std::string(TCERT_GOLDEN) + "/certificate.json"));
  std::size_t connected = 0;
  for (const auto& one : golden.at("cases")) {
    SCOPED_TRACE(one.at("parameters").dump());
    test_support::Run run = test_support::random_run(one.at("seed").get<std::uint32_t>(), 1500);
    CertificateParameters parameters;
    for (const auto& [key, value] : one.at("parameters").items()) {
      change(parameters, key, value);
      change(run.robot, key, value);
    }
    Certifier certifier(run.robot, run.course, parameters);
    std::vector<CertifiedTick> series;
    for (const Tick& tick : run.ticks) {
      series.push_back(certifier.update(tick));
    }
    for (const auto& row : one.at("rows")) {
      const auto tick = row.at(0).get<std::size_t>();
      for (std::size_t k = 1; k < row.size(); ++k) {
        const auto column = golden.at("columns").at(k).get<std::string>();
        const double found = value_of(series.at(tick), column);
        if (row.at(k).is_null()) {
          EXPECT_EQ(found, -std::numeric_limits<double>::infinity()) << column << ", tick " << tick;
        } else {
          const auto expected = row.at(k).get<double>();
          EXPECT_NEAR(found, expected, 1e-9 * std::max(1.0, std::abs(expected)))
              << column << ", tick " << tick;
        }
      }
    }
    connected += series.back().certificate_m > -1e9 ? 1 : 0;
  }
  EXPECT_GE(connected, 4U) << "too few runs reach G to test anything";
}

}  // namespace
}  // namespace tcert
