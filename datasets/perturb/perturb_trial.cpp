#include "datasets/perturb/perturb_trial.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "datasets/bundle_files.hpp"
#include "datasets/perturb/perturb_stream.hpp"
#include "datasets/stream_reader.hpp"
#include "datasets/tick_columns.hpp"
#include "datasets/tick_limit.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert::perturb {
namespace {

constexpr double kTickS = 0.1;

/// A stream of a trial that was read.
struct ReadStream {
  StreamKind kind;
  std::string name;
  table::NumberOptions columns;
  std::int64_t first_ns = 0;
  std::int64_t last_ns = 0;
  bool is_merged = false;
};

std::vector<ReadStream> streams_of(const TrialLog& log, const Robot& robot) {
  if (log.merged) {
    const auto& time_ns = log.merged->time_ns;
    return {{StreamKind::tactile,
             "ticks.csv",
             tick_columns(robot),
             time_ns.front(),
             time_ns.back(),
             true}};
  }
  std::vector<ReadStream> streams;
  const auto add = [&](StreamKind kind,
                       const char* name,
                       table::NumberOptions columns,
                       const std::vector<std::int64_t>& time_ns) {
    if (!time_ns.empty()) {
      streams.push_back({kind, name, std::move(columns), time_ns.front(), time_ns.back()});
    }
  };
  add(StreamKind::pose, "pose.csv", stream_columns("pose.csv"), log.pose.time_ns);
  add(StreamKind::tactile, "tactile.csv", tactile_columns(robot), log.tactile.time_ns);
  add(StreamKind::control, "control.csv", stream_columns("control.csv"), log.control.time_ns);
  return streams;
}

/// The rays that state a value at all, or a force.
std::vector<std::size_t> rays_with(const TrialLog& log, double RayReading::*member) {
  const std::size_t rays = log.merged ? log.merged->rays : log.tactile.rays;
  const auto& readings = log.merged ? log.merged->readings : log.tactile.readings;
  std::vector<std::size_t> found;
  for (std::size_t ray = 0; ray < rays; ++ray) {
    bool states = false;
    for (std::size_t i = ray; i < readings.size() && !states; i += rays) {
      states = !std::isnan(readings[i].*member);
    }
    if (states) {
      found.push_back(ray);
    }
  }
  return found;
}

table::Diagnostic without_arrivals(const std::string& trial_id) {
  return {table::Severity::error,
          "logs/" + trial_id + "/ticks.csv",
          0,
          "",
          "ticks that are merged already",
          "streams for latency: ticks have no arrivals; ask for it without this trial",
          1};
}

class TrialPerturbation {
 public:
  TrialPerturbation(const Bundle& bundle, const TrialRow& trial, const PerturbPlan& plan)
      : bundle_(bundle), files_(bundle.path), trial_(trial), plan_(plan) {}

  PerturbedTrial run() {
    TrialResult read = read_trial(bundle_, trial_);
    result_.diagnostics = std::move(read.diagnostics);
    reject_too_many_ticks(read.log, kTickS, trial_.trial_id, result_.diagnostics);
    if (read.log && read.log->merged && plan_.faults.bursts_per_hour > 0.0) {
      result_.diagnostics.push_back(without_arrivals(trial_.trial_id));
      read.log.reset();
    }
    result_.rejected = !read.log;
    if (read.log) {
      perturb(*read.log);
    }
    return std::move(result_);
  }

 private:
  void perturb(const TrialLog& log) {
    const std::vector<ReadStream> streams = streams_of(log, bundle_.info.robot);
    draw_ = {plan_.seed, trial_.trial_id};
    draw_.begin_ns = streams.front().first_ns;
    draw_.end_ns = streams.front().last_ns;
    for (const ReadStream& stream : streams) {
      if (stream.kind == StreamKind::tactile) {
        draw_.begin_ns = std::max(draw_.begin_ns, stream.first_ns);
        draw_.end_ns = std::min(draw_.end_ns, stream.last_ns);
      }
    }
    for (const ReadStream& stream : streams) {
      draw_.stream = stream.kind;
      draw_.has_links = std::ranges::find(plan_.links, stream.kind) != plan_.links.end();
      const bool feels = stream.kind == StreamKind::tactile;
      draw_.rays = feels ? rays_with(log, &RayReading::value) : std::vector<std::size_t>();
      draw_.feeling = feels ? rays_with(log, &RayReading::fsr_n) : std::vector<std::size_t>();
      perturb(stream);
    }
  }

  void perturb(const ReadStream& stream) {
    const auto found = files_.find("logs/" + trial_.trial_id + "/" + stream.name);
    const table::BytesResult file = found ? files_.read(*found) : table::BytesResult();
    if (!file.bytes) {
      return;  // it was there when it was read
    }
    PerturbedStream done{stream.name, stream.kind, draw_faults(plan_.faults, draw_), 0};
    const table::CsvOptions csv = csv_of_stream(bundle_, stream.name, *found);
    const StreamText text{
        *file.bytes, csv, stream.columns, stream.first_ns, stream.last_ns, stream.is_merged};
    PerturbedText made =
        perturb_stream(text, bundle_.info, plan_.faults.wide_share, done.injections);
    done.samples = made.samples;
    std::erase_if(done.injections, [](const Injection& one) { return one.samples == 0; });
    if (!done.injections.empty()) {
      result_.files.push_back(
          {*found, "logs/" + trial_.trial_id + "/" + stream.name, std::move(made.text)});
    }
    result_.streams.push_back(std::move(done));
  }

  const Bundle& bundle_;
  BundleFiles files_;
  const TrialRow& trial_;
  const PerturbPlan& plan_;
  FaultDraw draw_;
  PerturbedTrial result_;
};

}  // namespace

PerturbedTrial perturb_trial(const Bundle& bundle, const TrialRow& trial, const PerturbPlan& plan) {
  return TrialPerturbation(bundle, trial, plan).run();
}

}  // namespace tcert::perturb
