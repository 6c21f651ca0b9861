#include "datasets/driven/truth_stream.hpp"

#include <algorithm>
#include <table/csv.hpp>
#include <table/csv_write.hpp>

#include "datasets/bundle_files.hpp"

namespace tcert {
namespace {

constexpr std::int64_t kTruthPeriod = 50'000'000;  // ns
constexpr double kWithin = 1e-3;                   // m

}  // namespace

double free_way(const WallIndex& walls, Point from, Point ahead, double radius_m) {
  double way_m = 0.0;
  while (way_m < kTruthAhead) {
    const double room_m = walls.distance_from(from + way_m * ahead) - radius_m + kWithin;
    if (room_m < 0.0) {
      return way_m;
    }
    way_m += std::max(room_m, kWithin);  // nothing is nearer than the room there is
  }
  return kTruthAhead;
}

void TruthRecorder::take(std::int64_t time_ns, const Body& body) {
  force_n_ = std::max(force_n_, body.hold().force_n);
  if (time_ns % kTruthPeriod != 0) {
    return;
  }
  const Pose& pose = body.pose();
  samples_.push_back({time_ns,
                      pose,
                      body.forward_mps(),
                      force_n_,
                      free_way(walls_, pose.position, direction(pose.yaw_rad), radius_m_)});
  force_n_ = 0.0;
}

std::string truth_csv(const std::vector<TruthSample>& samples) {
  std::string text = "time_s,x_m,y_m,yaw_rad,speed_mps,force_n,free_ahead_m\n";
  for (const TruthSample& one : samples) {
    table::append_seconds(text, one.time_ns);
    for (const double value : {one.pose.position.x_m,
                               one.pose.position.y_m,
                               one.pose.yaw_rad,
                               one.speed_mps,
                               one.force_n,
                               one.free_ahead_m}) {
      table::append_cell(text, value);
    }
    text += '\n';
  }
  return text;
}

TruthResult read_truth(const Bundle& bundle, const std::string& trial_id) {
  TruthResult result;
  const BundleFiles files(bundle.path);
  const std::string name = "logs/" + trial_id + "/truth.csv";
  if (!files.problem().empty() || !files.find(name)) {
    return result;
  }
  const table::BytesResult bytes = files.read(name);
  table::DiagnosticGroups problems;
  table::CsvOptions csv;
  csv.file = name;
  table::NumberOptions options;
  for (const char* const column :
       {"x_m", "y_m", "yaw_rad", "speed_mps", "force_n", "free_ahead_m"}) {
    options.columns.push_back({column});
  }
  if (bytes.bytes) {
    if (const auto table = table::read_numbers(*bytes.bytes, csv, options, problems)) {
      result.samples.emplace();
      for (std::size_t i = 0; i < table->rows(); ++i) {
        result.samples->push_back({table->time_ns[i],
                                   {{table->at(i, 0), table->at(i, 1)}, table->at(i, 2)},
                                   table->at(i, 3),
                                   table->at(i, 4),
                                   table->at(i, 5)});
      }
    }
  } else {
    problems.add({table::Severity::error, name, 0, "", "", "a readable file: " + bytes.problem});
  }
  result.diagnostics = problems.take();
  return result;
}

}  // namespace tcert
