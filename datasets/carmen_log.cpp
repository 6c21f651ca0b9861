#include "datasets/carmen_log.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <table/csv_write.hpp>
#include <table/decimal.hpp>
#include <utility>

namespace tcert {

namespace {

constexpr std::size_t kMostBeams = 4096;

/// The words of one line, one after another. The line lies in a Bytes.
class Words {
 public:
  explicit Words(std::string_view line) noexcept : rest_(line) {}

  /// Empty at the end of the line.
  std::string_view next() noexcept {
    const std::size_t first = rest_.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
      rest_ = {};
      return rest_;
    }
    rest_.remove_prefix(first);
    const std::size_t length = std::min(rest_.find_first_of(" \t\r"), rest_.size());
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

 private:
  std::string_view rest_;
};

/// What a record lacked: the field, the word in its place, what it should have been.
struct Fault {
  std::string field;
  std::string value;
  std::string expectation;
};

struct Scan {
  std::int64_t time_ns = 0;
  Pose pose;
  std::vector<double> ranges_m;
};

/// Reads one FLASER record after its first word.
class ScanReader {
 public:
  ScanReader(Words words, Scan& scan) : words_(words), scan_(scan) {}

  [[nodiscard]] std::optional<Fault> read(std::size_t beams_before) {
    double beams = 0.0;
    number("number of beams", beams);
    const bool countable =
        beams >= 1.0 && beams <= static_cast<double>(kMostBeams) && beams == std::floor(beams);
    if (!fault_ && !countable) {
      fail("number of beams", word_, "a whole number, 1 to 4096");
    }
    if (!fault_ && beams_before != 0 && static_cast<std::size_t>(beams) != beams_before) {
      fail("number of beams", word_, "as many beams as the first scan has");
    }
    if (fault_) {
      return fault_;
    }
    scan_.ranges_m.assign(static_cast<std::size_t>(beams), 0.0);
    for (double& range : scan_.ranges_m) {
      number("range", range);
      if (!fault_ && range < 0.0) {
        fail("range", word_, "a range in metres, 0 or more");
      }
    }
    number("x", scan_.pose.position.x_m);
    number("y", scan_.pose.position.y_m);
    number("theta", scan_.pose.yaw_rad);
    double ignored = 0.0;
    number("odom_x", ignored);
    number("odom_y", ignored);
    number("odom_theta", ignored);
    seconds("ipc_timestamp", scan_.time_ns);
    return fault_;
  }

 private:
  void fail(const char* field, std::string_view value, const char* expectation) {
    fault_ = Fault{field, table::shortened(value), expectation};
  }

  void number(const char* field, double& value) {
    if (fault_) {
      return;
    }
    word_ = words_.next();
    if (word_.empty() ||
        table::scan_number(word_.data(), '.', value) != word_.data() + word_.size()) {
      fail(field, word_, "a finite number");
    }
  }

  void seconds(const char* field, std::int64_t& time_ns) {
    if (fault_) {
      return;
    }
    word_ = words_.next();
    if (word_.empty() ||
        table::scan_seconds(word_.data(), '.', time_ns) != word_.data() + word_.size()) {
      fail(field, word_, "a time in seconds");
    }
  }

  Words words_;
  Scan& scan_;
  std::string_view word_;
  std::optional<Fault> fault_;
};

std::optional<Fault> fault_of_order(const CarmenLog& log, const Scan& scan) {
  if (log.scans() == 0 || scan.time_ns > log.time_ns.back()) {
    return std::nullopt;
  }
  std::string found;
  table::append_seconds(found, scan.time_ns);
  found += " after ";
  table::append_seconds(found, log.time_ns.back());
  return Fault{"ipc_timestamp", found, "a time after that of the scan before"};
}

void append(CarmenLog& log, const Scan& scan) {
  log.beams = scan.ranges_m.size();
  log.time_ns.push_back(scan.time_ns);
  log.poses.push_back(scan.pose);
  log.ranges_m.insert(log.ranges_m.end(), scan.ranges_m.begin(), scan.ranges_m.end());
}

}  // namespace

double carmen_bearing_rad(std::size_t beam, std::size_t beams) noexcept {
  const double share = (static_cast<double>(beam) + 0.5) / static_cast<double>(beams);
  return (share - 0.5) * std::numbers::pi;
}

CarmenLog read_carmen_log(const table::Bytes& bytes,
                          const std::string& file,
                          table::DiagnosticGroups& problems) {
  CarmenLog log;
  Scan scan;
  std::string_view rest = bytes.view();
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    Words words(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
    const std::string_view kind = words.next();
    if (kind.empty() || kind.front() == '#') {
      continue;
    }
    if (kind != "FLASER") {
      (kind == "ODOM" ? log.odometry_records : log.other_records) += 1;
      continue;
    }
    std::optional<Fault> fault = ScanReader(words, scan).read(log.beams);
    if (!fault) {
      fault = fault_of_order(log, scan);
    }
    if (!fault) {
      append(log, scan);
      continue;
    }
    problems.add({table::Severity::warning,
                  file,
                  line,
                  std::move(fault->field),
                  std::move(fault->value),
                  fault->expectation + "; the record is not used",
                  1});
  }
  if (log.scans() == 0) {
    problems.add({table::Severity::error, file, 0, "", "no scan", "at least one FLASER record", 1});
  }
  return log;
}

}  // namespace tcert
