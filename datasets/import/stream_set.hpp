#pragma once
/// \file
/// The streams of one trial on their way from a foreign log into the files of a bundle.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "datasets/import/log_map.hpp"
#include "datasets/import/ray_layout.hpp"
#include "datasets/import/sample_order.hpp"
#include "datasets/import/stream_file.hpp"
#include "datasets/import/stream_values.hpp"

namespace tcert::recording {

/// Streams are counted: 0 is the pose, then those of rays in the order of the map, then control.
[[nodiscard]] std::size_t number_of_streams(const LogMap& map) noexcept;
[[nodiscard]] const StreamSource& stream_at(const LogMap& map, std::size_t stream);
/// "pose", "rays", "rays[1]", "control": the key of the map.
[[nodiscard]] std::string key_of(const LogMap& map, std::size_t stream);

struct StreamResult {
  StreamUse use;
  RangeUse ranges;
};

/// Puts each stream in order and writes pose.csv, tactile.csv and control.csv. One stream of rays
/// is written as it comes; several are held until finish(), which merges them by time.
class StreamSet {
 public:
  /// `window_ns`: a sample that is later than that comes of a clock that was set back. Files appear
  /// in `folder`. All three outlive the set.
  StreamSet(const LogMap& map,
            const std::vector<RayLayout>& layouts,
            std::filesystem::path folder,
            std::int64_t window_ns);
  StreamSet(const StreamSet&) = delete;
  StreamSet& operator=(const StreamSet&) = delete;
  ~StreamSet();

  /// A row of a stream. `values`: x, y and yaw; of rays the value and the force of each; the speed,
  /// the yaw rate and the latency; NaN where there is none. A row without any is empty; one without
  /// a time, or with a part of a pose, cannot be read. \throws table::WriteError.
  void take(std::size_t stream,
            std::optional<std::int64_t> time_ns,
            std::span<const double> values,
            std::size_t place);

  /// A row that cannot be read at all.
  void take_unreadable(std::size_t stream);

  /// Writes what is left; one result a stream. \throws table::WriteError.
  [[nodiscard]] std::vector<StreamResult> finish();

 private:
  struct Stream;

  static void take_rays(Stream& stream, std::span<const double> values);
  void merge_rays();

  const LogMap& map_;
  const std::vector<RayLayout>& layouts_;
  std::filesystem::path folder_;
  std::vector<std::unique_ptr<Stream>> streams_;
  StreamFile tactile_;
};

}  // namespace tcert::recording
