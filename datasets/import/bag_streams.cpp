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

/// The first scan of each stream that has beams by angles.
struct FirstScans {
  std::map<std::size_t, ScanGeometry> geometry;  // by stream
  std::map<std::size_t, std::string> frame;      // by stream
};

bool by_transforms(const StreamSource& source) {
  return source.scan && source.scan->offset.by_transforms;
}

void take_scan(const RawMessage& raw, std::size_t k, TopicStream& stream, FirstScans& first) {
  std::string problem;
  const Value* const message = stream.decode(raw, problem);
  const auto scan = message == nullptr ? std::nullopt : stream.geometry(*message);
  if (scan) {
    first.geometry[k] = *scan;
    const Value* const frame = find(*message, "header.frame_id");
    const std::string* const name = frame == nullptr ? nullptr : text(*frame);
    first.frame[k] = name == nullptr ? "" : *name;
  }
}

/// Reads until every scanner has a scan, and the transforms that it needs are known.
FirstScans first_scans(Bag& bag,
                       const LogMap& map,
                       const TopicStreams& streams,
                       StaticTransforms& transforms,
                       table::DiagnosticGroups& problems) {
  FirstScans first;
  std::vector<std::size_t> scanners;
  std::vector<std::size_t> wanted;
  for (std::size_t k = 0; k < map.rays.size(); ++k) {
    if (map.rays[k].scan) {
      scanners.push_back(k);
      wanted.push_back(streams[k + 1]->topic());
    }
  }
  if (scanners.empty()) {
    return first;
  }
  const bool needs_transforms = std::ranges::any_of(map.rays, by_transforms);
  if (needs_transforms && transforms.topic()) {
    wanted.push_back(*transforms.topic());
  }
  const auto is_known = [&](std::size_t k) {
    return first.geometry.contains(k) &&
           (!by_transforms(map.rays[k]) || transforms.find(map.base_frame, first.frame[k]));
  };
  bag.for_each(
      wanted,
      [&](const RawMessage& raw) {
        if (needs_transforms && transforms.topic() == raw.topic) {
          transforms.take(raw);
        }
        for (const std::size_t k : scanners) {
          if (!first.geometry.contains(k) && streams[k + 1]->topic() == raw.topic) {
            take_scan(raw, k, *streams[k + 1], first);
          }
        }
        return !std::ranges::all_of(scanners, is_known);
      },
      problems);
  return first;
}

/// What is missing of a layout, and what was expected.
struct NoLayout {
  std::string found;
  std::string expectation;
};

std::optional<NoLayout> complete_scan(const StreamSource& source,
                                      std::size_t k,
                                      const std::string& base_frame,
                                      const StaticTransforms& transforms,
                                      FirstScans& first) {
  const auto scan = first.geometry.find(k);
  if (scan == first.geometry.end()) {
    return NoLayout{"no scan in " + source.topic,
                    "a message with ranges, angle_min and angle_increment, or these in the map"};
  }
  if (by_transforms(source)) {
    const auto offset = transforms.find(base_frame, first.frame[k]);
    if (!offset) {
      return NoLayout{"no transform from '" + base_frame + "' to '" + first.frame[k] + "'",
                      "one in /tf_static, 'base_frame' in the map, or 'offset' as an object"};
    }
    scan->second.offset = *offset;
  }
  if (!source.scan->reach_m && !scan->second.range_max_m) {
    return NoLayout{"a scan without range_max", "reach_m in the map"};
  }
  return std::nullopt;
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
  StaticTransforms transforms(bag);
  FirstScans first = first_scans(bag, map, streams, transforms, problems);
  const auto scanners =
      std::ranges::count_if(map.rays, [](auto& stream) { return stream.scan.has_value(); });
  std::vector<RayLayout> layouts;
  for (std::size_t k = 0; k < map.rays.size(); ++k) {
    const StreamSource& source = map.rays[k];
    if (!source.scan) {
      layouts.push_back(layout_of(source));
    } else if (auto missing = complete_scan(source, k, map.base_frame, transforms, first)) {
      problems.add({Severity::error,
                    file,
                    0,
                    key_of(map, k + 1),
                    std::move(missing->found),
                    std::move(missing->expectation),
                    1});
    } else {
      const std::string prefix = scanners > 1 ? "s" + std::to_string(k) + "_b" : "b";
      layouts.push_back(layout_of(source, first.geometry.at(k), prefix));
    }
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

/// Puts the values of messages into the streams of a trial.
class MessageTaker {
 public:
  MessageTaker(const std::string& file,
               const LogMap& map,
               const std::vector<RayLayout>& layouts,
               StreamSet& set,
               table::DiagnosticGroups& problems)
      : file_(file), map_(map), layouts_(layouts), set_(set), problems_(problems) {}

  /// The message is the `number`-th of the bag, of stream `i`.
  void take(const RawMessage& raw, std::size_t number, std::size_t i, TopicStream& stream) {
    const bool is_rays = i >= 1 && i <= map_.rays.size();
    const Value* const message = stream.decode(raw, problem_);
    if (message == nullptr) {
      refuse(i, stream, problem_, "a message of its type; it is not used");
      return;
    }
    if (!stream.values(*message, is_rays ? &layouts_[i - 1] : nullptr, values_, prefix_)) {
      return;
    }
    if (is_rays && values_.empty()) {
      refuse(i, stream, "a scan of other beams", "the beams of the first; it is not used");
      return;
    }
    const auto time_ns =
        map_.header_clock ? header_time(*message, prefix_) : std::optional(raw.log_ns);
    set_.take(i, time_ns, values_, number);
  }

 private:
  void refuse(std::size_t i,
              const TopicStream& stream,
              const std::string& found,
              const char* expectation) {
    problems_.add({Severity::warning, file_, 0, stream.source().topic, found, expectation, 1});
    set_.take_unreadable(i);
  }

  const std::string& file_;
  const LogMap& map_;
  const std::vector<RayLayout>& layouts_;
  StreamSet& set_;
  table::DiagnosticGroups& problems_;
  std::string problem_;
  std::string prefix_;
  std::vector<double> values_;
};

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
  MessageTaker taker(file, map, layouts, set, problems);
  std::size_t number = 0;
  bag.for_each(
      wanted,
      [&](const RawMessage& raw) {
        ++number;
        for (std::size_t i = 0; i < streams.size(); ++i) {
          if (streams[i] && streams[i]->topic() == raw.topic) {
            taker.take(raw, number, i, *streams[i]);
          }
        }
        return true;
      },
      problems);
  return true;
}

}  // namespace tcert::recording
