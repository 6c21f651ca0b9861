#include "support/survival_golden.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "analysis/concordance.hpp"
#include "datasets/csv.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::test_support {
namespace {

using Cells = std::vector<std::string>;

Cells cells_of(const std::string& data, const std::string& column) {
  const TextTableResult file = read_text_table(shared_data() / "stats" / "data" / data, {column});
  if (!file.table) {
    throw std::runtime_error(data + ": no column " + column);
  }
  Cells cells;
  for (std::size_t row = 0; row < file.table->rows(); ++row) {
    cells.push_back(file.table->at(row, file.table->find(column).value()));
  }
  return cells;
}

std::vector<std::string> arguments_of(const std::string& response) {
  std::vector<std::string> parts{""};
  const std::size_t open = response.find('(');
  const std::string inside = open == std::string::npos
                                 ? response
                                 : response.substr(open + 1, response.rfind(')') - open - 1);
  for (const char c : inside) {
    if (c == ',') {
      parts.emplace_back();
    } else if (c != ' ') {
      parts.back() += c;
    }
  }
  return parts;
}

bool missing(const std::string& cell) { return cell.empty() || cell == "NA" || cell == "NaN"; }

Factor factor_of(const std::vector<Cells>& columns,
                 const std::vector<std::string>& names,
                 const std::vector<std::size_t>& rows) {
  const auto less = [](const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[k] != b[k]) {
        char* end = nullptr;
        const double x = std::strtod(a[k].c_str(), &end);
        const bool numeric = *end == '\0';
        return numeric ? x < std::strtod(b[k].c_str(), nullptr) : a[k] < b[k];
      }
    }
    return false;
  };
  std::vector<std::vector<std::string>> keys;
  for (const std::size_t row : rows) {
    std::vector<std::string> key;
    for (const Cells& column : columns) {
      key.push_back(column[row]);
    }
    keys.push_back(key);
  }
  std::map<std::vector<std::string>, std::uint32_t, decltype(less)> levels(less);
  for (const auto& key : keys) {
    levels.emplace(key, 0U);
  }
  Factor factor;
  for (auto& [key, code] : levels) {
    code = static_cast<std::uint32_t>(factor.levels.size());
    std::string name;
    for (std::size_t k = 0; k < key.size(); ++k) {
      name += (k > 0 ? ", " : "") + names[k] + "=" + key[k];
    }
    factor.levels.push_back(name);
  }
  for (const auto& key : keys) {
    factor.codes.push_back(levels.at(key));
  }
  return factor;
}

}  // namespace

nlohmann::json golden_values(const std::string& name) {
  std::ifstream file(shared_data() / "stats" / "golden" / name);
  return file ? nlohmann::json::parse(file) : nlohmann::json();
}

GoldenFrame golden_frame(const GoldenCall& call) {
  std::map<std::string, Cells> columns;
  const auto use = [&](const std::string& name) {
    if (!name.empty() && columns.count(name) == 0) {
      columns[name] = cells_of(call.data, name);
    }
  };
  std::vector<std::string> response = arguments_of(call.response);
  std::string event_value;
  const std::size_t equals = response.back().find("==");
  if (equals != std::string::npos) {
    event_value = response.back().substr(equals + 2);
    response.back().resize(equals);
  }
  for (const std::vector<std::string>& names : {response, call.predictors, call.groups}) {
    std::for_each(names.begin(), names.end(), use);
  }
  for (const auto& name : {call.strata, call.cluster, call.weights}) {
    use(name);
  }
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < columns.begin()->second.size(); ++row) {
    if (std::none_of(columns.begin(), columns.end(), [row](const auto& column) {
          return missing(column.second[row]);
        })) {
      rows.push_back(row);
    }
  }
  const auto numbers = [&](const std::string& name) {
    std::vector<double> values;
    for (const std::size_t row : rows) {
      values.push_back(std::stod(columns.at(name)[row]));
    }
    return values;
  };
  GoldenFrame frame;
  if (response.size() == 1) {
    frame.outcome = uncensored(numbers(response[0]));
  } else {
    if (response.size() == 3) {
      frame.outcome.start = numbers(response[0]);
    }
    frame.outcome.stop = numbers(response[response.size() - 2]);
    for (const std::size_t row : rows) {
      const std::string& cell = columns.at(response.back())[row];
      frame.outcome.event.push_back(cell == (event_value.empty() ? "1" : event_value) ? 1 : 0);
    }
    snap_times(frame.outcome);
  }
  for (const std::string& name : call.predictors) {
    frame.predictors.push_back(numbers(name));
  }
  const auto factor = [&](const std::vector<std::string>& names) {
    std::vector<Cells> parts;
    for (const std::string& name : names) {
      parts.push_back(columns.at(name));
    }
    return factor_of(parts, names, rows);
  };
  frame.groups = factor(call.groups);
  if (!call.strata.empty()) {
    frame.strata = factor({call.strata});
  }
  if (!call.cluster.empty()) {
    frame.cluster = factor({call.cluster});
  }
  if (!call.weights.empty()) {
    frame.weights = numbers(call.weights);
  }
  return frame;
}

double golden_number(const nlohmann::json& value) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  if (value.is_number()) {
    return value.get<double>();
  }
  if (value == "Inf") {
    return kInf;
  }
  return value == "-Inf" ? -kInf : std::numeric_limits<double>::quiet_NaN();
}

double disagreement(double actual, double expected) {
  if (std::isnan(expected) || std::isinf(expected)) {
    return (std::isnan(expected) && std::isnan(actual)) || actual == expected
               ? 0.0
               : std::numeric_limits<double>::infinity();
  }
  const double difference = std::abs(actual - expected);
  if (std::isnan(difference)) {
    return std::numeric_limits<double>::infinity();
  }
  return expected == 0.0 ? difference : difference / std::abs(expected);
}

std::vector<double> efron_linear_predictor(const SurvivalOutcome& outcome,
                                           const std::vector<std::vector<double>>& columns) {
  const auto n = static_cast<Eigen::Index>(outcome.rows());
  const auto p = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd X(n, p);
  for (Eigen::Index j = 0; j < p; ++j) {
    X.col(j) = Eigen::Map<const Eigen::VectorXd>(columns[static_cast<std::size_t>(j)].data(), n);
    X.col(j).array() -= X.col(j).mean();
  }
  std::map<double, std::vector<Eigen::Index>> events;
  for (std::size_t row = 0; row < outcome.rows(); ++row) {
    if (outcome.event[row] != 0) {
      events[outcome.stop[row]].push_back(static_cast<Eigen::Index>(row));
    }
  }
  struct Moments {
    explicit Moments(Eigen::Index size)
        : first(Eigen::VectorXd::Zero(size)), second(Eigen::MatrixXd::Zero(size, size)) {}
    void add(const Eigen::VectorXd& x, double weight) {
      zeroth += weight;
      first += weight * x;
      second += weight * x * x.transpose();
    }
    double zeroth = 0.0;
    Eigen::VectorXd first;
    Eigen::MatrixXd second;
  };
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(p);
  for (int step = 0; step < 25; ++step) {
    Eigen::VectorXd score = Eigen::VectorXd::Zero(p);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(p, p);
    for (const auto& [time, tied] : events) {
      Moments all(p);
      Moments dead(p);
      for (Eigen::Index row = 0; row < n; ++row) {
        if (outcome.stop[static_cast<std::size_t>(row)] >= time) {
          all.add(X.row(row), std::exp(X.row(row).dot(beta)));
        }
      }
      for (const Eigen::Index row : tied) {
        dead.add(X.row(row), std::exp(X.row(row).dot(beta)));
        score += X.row(row);
      }
      for (std::size_t k = 0; k < tied.size(); ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(tied.size());
        const double zeroth = all.zeroth - part * dead.zeroth;
        const Eigen::VectorXd mean = (all.first - part * dead.first) / zeroth;
        score -= mean;
        information += (all.second - part * dead.second) / zeroth - mean * mean.transpose();
      }
    }
    beta += information.ldlt().solve(score);
  }
  const Eigen::VectorXd scores = X * beta;
  return {scores.data(), scores.data() + n};
}

}  // namespace tcert::test_support
