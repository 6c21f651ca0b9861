#include "datasets/import/stream_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tcert/tick.hpp>
#include <utility>

namespace tcert::recording {
namespace {

std::vector<std::string> tactile_columns(const std::vector<RayLayout>& layouts) {
  std::vector<std::string> columns;
  for (const RayLayout& layout : layouts) {
    const std::vector<std::string> more = layout.column_names();
    columns.insert(columns.end(), more.begin(), more.end());
  }
  return columns;
}

bool is_nan(double value) { return std::isnan(value); }

}  // namespace

std::size_t number_of_streams(const LogMap& map) noexcept {
  return 1 + map.rays.size() + (map.control ? 1 : 0);
}

const StreamSource& stream_at(const LogMap& map, std::size_t stream) {
  if (stream == 0) {
    return map.pose;
  }
  return stream <= map.rays.size() ? map.rays[stream - 1] : map.control.value();
}

std::string key_of(const LogMap& map, std::size_t stream) {
  if (stream == 0) {
    return "pose";
  }
  if (stream > map.rays.size()) {
    return "control";
  }
  return map.rays.size() == 1 ? "rays" : "rays[" + std::to_string(stream - 1) + "]";
}

struct StreamSet::Stream {
  const RayLayout* layout = nullptr;  // of rays
  std::size_t first_column = 0;       // of tactile.csv
  std::unique_ptr<StreamFile> file;   // of its own
  std::unique_ptr<SampleOrder> order;
  std::vector<Sample> held;  // of rays, if there are several streams of them
  RangeUse ranges;
  std::optional<std::int64_t> origin_ns;
  std::vector<double> row;
};

StreamSet::StreamSet(const LogMap& map,
                     const std::vector<RayLayout>& layouts,
                     std::filesystem::path folder,
                     std::int64_t window_ns)
    : map_(map),
      layouts_(layouts),
      folder_(std::move(folder)),
      tactile_(folder_ / "tactile.csv", tactile_columns(layouts)) {
  std::size_t column = 0;
  for (std::size_t i = 0; i < number_of_streams(map); ++i) {
    auto stream = std::make_unique<Stream>();
    SampleOrder::Sink sink;
    if (i >= 1 && i <= map.rays.size()) {
      stream->layout = &layouts_[i - 1];
      stream->first_column = column;
      column += stream->layout->column_names().size();
      if (map.rays.size() == 1) {
        sink = [this](const Sample& sample) { tactile_.add(sample.time_ns, sample.values); };
      } else {
        sink = [held = &stream->held](const Sample& sample) { held->push_back(sample); };
      }
    } else {
      const bool is_pose = i == 0;
      stream->file = std::make_unique<StreamFile>(folder_ / (is_pose ? "pose.csv" : "control.csv"),
                                                  is_pose ? pose_columns() : control_columns());
      sink = [file = stream->file.get()](const Sample& sample) {
        file->add(sample.time_ns, sample.values);
      };
    }
    stream->order = std::make_unique<SampleOrder>(window_ns, std::move(sink));
    streams_.push_back(std::move(stream));
  }
}

StreamSet::~StreamSet() = default;

void StreamSet::take(std::size_t stream_number,
                     std::optional<std::int64_t> time_ns,
                     std::span<const double> values,
                     std::size_t place) {
  Stream& stream = *streams_[stream_number];
  if (stream.layout != nullptr) {
    take_rays(stream, values);
  } else {
    stream.row.assign(values.begin(), values.end());
  }
  if (std::ranges::all_of(stream.row, is_nan)) {
    stream.order->count_empty();
    return;
  }
  const bool is_part_of_pose = stream_number == 0 && !std::ranges::all_of(stream.row, [](double v) {
                                 return std::isfinite(v);
                               });
  if (!time_ns || is_part_of_pose) {
    stream.order->count_unreadable();
    return;
  }
  if (stream_at(map_, stream_number).time.from_first) {
    stream.origin_ns = stream.origin_ns.value_or(*time_ns);
    *time_ns -= *stream.origin_ns;
  }
  for (double& value : stream.row) {
    value = std::isfinite(value) ? value : kMissing;
  }
  stream.order->add(*time_ns, stream.row, place);
}

void StreamSet::take_unreadable(std::size_t stream) { streams_[stream]->order->count_unreadable(); }

void StreamSet::take_rays(Stream& stream, std::span<const double> values) {
  stream.row.clear();
  const RayLayout& layout = *stream.layout;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const RayColumns& ray = layout.columns[i];
    const double value = values[2 * i];
    stream.row.push_back(
        ray.bends ? value : range_of(value, ray.value, ray.no_return, ray.reach_m, stream.ranges));
    if (ray.force.is_given()) {
      stream.row.push_back(values[2 * i + 1]);
    }
  }
}

/// By time; samples of one time of several streams become one row.
void StreamSet::merge_rays() {
  std::vector<std::size_t> next(map_.rays.size(), 0);
  std::vector<double> row;
  const std::size_t columns = tactile_columns(layouts_).size();
  while (true) {
    std::int64_t earliest = std::numeric_limits<std::int64_t>::max();
    bool any = false;
    for (std::size_t k = 0; k < next.size(); ++k) {
      const std::vector<Sample>& held = streams_[k + 1]->held;
      if (next[k] < held.size()) {
        earliest = std::min(earliest, held[next[k]].time_ns);
        any = true;
      }
    }
    if (!any) {
      return;
    }
    row.assign(columns, kMissing);
    for (std::size_t k = 0; k < next.size(); ++k) {
      const Stream& stream = *streams_[k + 1];
      if (next[k] < stream.held.size() && stream.held[next[k]].time_ns == earliest) {
        std::ranges::copy(stream.held[next[k]].values,
                          row.begin() + static_cast<std::ptrdiff_t>(stream.first_column));
        ++next[k];
      }
    }
    tactile_.add(earliest, row);
  }
}

std::vector<StreamResult> StreamSet::finish() {
  std::vector<StreamResult> results;
  for (const auto& stream : streams_) {
    results.push_back({stream->order->finish(), stream->ranges});
  }
  if (map_.rays.size() > 1) {
    merge_rays();
  }
  tactile_.flush();
  for (const auto& stream : streams_) {
    if (stream->file) {
      stream->file->flush();
    }
  }
  return results;
}

}  // namespace tcert::recording
