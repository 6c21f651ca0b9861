#pragma once
// The table that a golden file holds as CSV.

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace tcert::statistics {

inline nlohmann::json golden_json(const std::string& name) {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/" + name);
  return nlohmann::json::parse(file);
}

/// Cells of each column as they are written.
inline std::map<std::string, std::vector<std::string>> golden_texts(const nlohmann::json& all) {
  std::istringstream lines(all["csv"].get<std::string>());
  std::string line;
  std::string cell;
  std::getline(lines, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, cell, ',');) {
    names.push_back(cell);
  }
  std::map<std::string, std::vector<std::string>> columns;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (const std::string& name : names) {
      std::getline(cells, cell, ',');
      columns[name].push_back(cell);
    }
  }
  return columns;
}

inline std::vector<double> golden_numbers(const nlohmann::json& all, const std::string& name) {
  std::vector<double> numbers;
  const std::vector<std::string> texts = golden_texts(all).at(name);
  for (const std::string& text : texts) {
    numbers.push_back(std::stod(text));
  }
  return numbers;
}

}  // namespace tcert::statistics
