#include "datasets/import/bag_streams.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "datasets/import/topic_stream.hpp"
#include "datasets/import/transforms.hpp"

namespace tcert::recording {
namespace {

using table::Severity;

using TopicStreams = std::vector<std::unique_ptr<TopicStream>>;

/// One a stream of the map; empty if one is missing. Control that is missing is a warning and a
/// null pointer: it is not required.
TopicStreams topic_streams(const Bag& bag,
                           const std::string& file,
                           const LogMap& map,
                           table::DiagnosticGroups& problems) {
  TopicStreams streams;
  bool all = true;
  for (std::size_t i = 0; i < number_of_streams(map); ++i) {
    const bool is_control = i > map.rays.size();
    table::DiagnosticGroups of_stream;
    streams.push_back(TopicStream::of(bag, file, stream_at(map, i), key_of(map, i), of_stream));
    for (table::Diagnostic& problem : of_stream.take()) {
      if (is_control) {
        problem.severity = Severity::warning;
        problem.expectation += "; there are no commands without it";
      }
      problems.add(std::move(problem));
    }
    all = all && (streams.back() || is_control);
  }
  return all ? std::move(streams) : TopicStreams{};
}

}  // namespace

std::optional<std::vector<RayLayout>> find_layouts(Bag& bag,
                                                   const std::string& file,
                                                   const LogMap& map,
                                                   table::DiagnosticGroups& problems) {
  const TopicStreams streams = topic_streams(bag, file, map, problems);
  if (streams.empty()) {
    return std::nullopt;
  }
  std::map<std::size_t, ScanGeometry> scans;       // by stream
  std::map<std::size_t, std::string> scan_frames;  // by stream
  std::size_t wanted_scans = 0;
  StaticTransforms transforms(bag);
  std::vector<std::size_t> wanted;
  bool needs_transforms = false;
  for (std::size_t k = 0; k < map.rays.size(); ++k) {
    if (map.rays[k].scan) {
      ++wanted_scans;
      wanted.push_back(streams[k + 1]->topic());
      needs_transforms = needs_transforms || map.rays[k].scan->offset.by_transforms;
    }
  }
  if (needs_transforms && transforms.topic()) {
    wanted.push_back(*transforms.topic());
  }
  const auto is_all_known = [&] {
    return scans.size() == wanted_scans && std::ranges::all_of(scan_frames, [&](const auto& entry) {
             return !map.rays[entry.first].scan->offset.by_transforms ||
                    transforms.find(map.base_frame, entry.second).has_value();
           });
  };
  if (wanted_scans > 0) {
    bag.for_each(
        wanted,
        [&](const RawMessage& raw) {
          std::string problem;
          if (needs_transforms && transforms.topic() == raw.topic) {
            transforms.take(raw);
          }
          for (std::size_t k = 0; k < map.rays.size(); ++k) {
            TopicStream& stream = *streams[k + 1];
            if (!map.rays[k].scan || scans.contains(k) || stream.topic() != raw.topic) {
              continue;
            }
            const Value* const message = stream.decode(raw, problem);
            const auto scan = message == nullptr ? std::nullopt : stream.geometry(*message);
            if (scan) {
              scans[k] = *scan;
              const Value* const frame = find(*message, "header.frame_id");
              const std::string* const name = frame == nullptr ? nullptr : text(*frame);
              scan_frames[k] = name == nullptr ? "" : *name;
            }
          }
          return !is_all_known();
        },
        problems);
  }
  std::vector<RayLayout> layouts;
  for (std::size_t k = 0; k < map.rays.size(); ++k) {
    const StreamSource& source = map.rays[k];
    if (!source.scan) {
      layouts.push_back(layout_of(source));
      continue;
    }
    const auto fail = [&](std::string found, std::string expectation) {
      problems.add({Severity::error,
                    file,
                    0,
                    key_of(map, k + 1),
                    std::move(found),
                    std::move(expectation),
                    1});
    };
    const auto scan = scans.find(k);
    if (scan == scans.end()) {
      fail("no scan in " + source.topic,
           "a message with ranges, angle_min and angle_increment, or these in the map");
      continue;
    }
    if (source.scan->offset.by_transforms) {
      const auto offset = transforms.find(map.base_frame, scan_frames[k]);
      if (!offset) {
        fail("no transform from '" + map.base_frame + "' to '" + scan_frames[k] + "'",
             "one in /tf_static, 'base_frame' in the map, or 'offset' as an object");
        continue;
      }
      scan->second.offset = *offset;
    }
    if (!source.scan->reach_m && !scan->second.range_max_m) {
      fail("a scan without range_max", "reach_m in the map");
      continue;
    }
    const std::string prefix = wanted_scans > 1 ? "s" + std::to_string(k) + "_b" : "b";
    layouts.push_back(layout_of(source, scan->second, prefix));
  }
  return layouts.size() == map.rays.size() ? std::optional(std::move(layouts)) : std::nullopt;
}

namespace {

/// Whether the bag's scanners are those of the first trial; else why not, as an error.
bool has_scans_of(const std::vector<RayLayout>& first,
                  Bag& bag,
                  const std::string& file,
                  const LogMap& map,
                  table::DiagnosticGroups& problems) {
  if (std::ranges::none_of(map.rays, [](auto& stream) { return stream.scan.has_value(); })) {
    return true;
  }
  const auto found = find_layouts(bag, file, map, problems);
  bool same = found.has_value();
  for (std::size_t k = 0; found && k < first.size(); ++k) {
    if (!are_same_rays(first[k], (*found)[k])) {
      problems.add(
          {Severity::error,
           file,
           0,
           key_of(map, k + 1),
           "another scanner: " + in_words((*found)[k].geometry.value()),
           in_words(first[k].geometry.value()) + ", as in the first trial; the trial is rejected",
           1});
      same = false;
    }
  }
  return same;
}

}  // namespace

bool read_bag_streams(Bag& bag,
                      const std::string& file,
                      const LogMap& map,
                      const std::vector<RayLayout>& layouts,
                      StreamSet& set,
                      table::DiagnosticGroups& problems) {
  const TopicStreams streams = topic_streams(bag, file, map, problems);
  if (streams.empty()) {
    return false;
  }
  if (!has_scans_of(layouts, bag, file, map, problems)) {
    return false;
  }
  std::vector<std::size_t> wanted;
  for (const auto& stream : streams) {
    if (stream && std::ranges::find(wanted, stream->topic()) == wanted.end()) {
      wanted.push_back(stream->topic());
    }
  }
  std::size_t number = 0;
  std::string problem;
  std::string prefix;
  std::vector<double> values;
  bag.for_each(
      wanted,
      [&](const RawMessage& raw) {
        ++number;
        for (std::size_t i = 0; i < streams.size(); ++i) {
          TopicStream* const stream = streams[i].get();
          if (stream == nullptr || stream->topic() != raw.topic) {
            continue;
          }
          const bool is_rays = i >= 1 && i <= map.rays.size();
          const RayLayout* const layout = is_rays ? &layouts[i - 1] : nullptr;
          const Value* const message = stream->decode(raw, problem);
          if (message == nullptr) {
            problems.add({Severity::warning,
                          file,
                          0,
                          stream->source().topic,
                          problem,
                          "a message of its type; it is not used",
                          1});
            set.take_unreadable(i);
            continue;
          }
          if (!stream->values(*message, layout, values, prefix)) {
            continue;
          }
          if (is_rays && values.empty()) {
            problems.add({Severity::warning,
                          file,
                          0,
                          stream->source().topic,
                          "a scan of other beams",
                          "the beams of the first; it is not used",
                          1});
            set.take_unreadable(i);
            continue;
          }
          const auto time_ns =
              map.header_clock ? header_time(*message, prefix) : std::optional(raw.log_ns);
          set.take(i, time_ns, values, number);
        }
        return true;
      },
      problems);
  return true;
}

}  // namespace tcert::recording
