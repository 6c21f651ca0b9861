#pragma once
/// \file
/// Where a sensor sits on the body, from the transforms that a robot publishes of its parts.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "datasets/import/bag.hpp"
#include "datasets/import/decoder.hpp"
#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// Index of the transform from `parent` to `child` in a message of transforms; any parent if
/// `parent` is empty, the first if both are. Frames are the same with and without a '/' before.
[[nodiscard]] std::optional<std::size_t> index_of_transform(const Value& message,
                                                            const std::string& parent,
                                                            const std::string& child);

/// The parts of the robot, as /tf_static has them.
class StaticTransforms {
 public:
  explicit StaticTransforms(const Bag& bag);

  /// Of /tf_static; empty if the bag has none that can be read.
  [[nodiscard]] std::optional<std::size_t> topic() const noexcept { return topic_; }

  void take(const RawMessage& raw);

  /// Place and heading of `frame` in `base`, over any number of joints between, flat on the ground:
  /// a sensor that is tilted or hangs upside down has none.
  [[nodiscard]] std::optional<ScanOffset> find(const std::string& base,
                                               const std::string& frame) const;

 private:
  struct Joint {
    std::string parent;
    ScanOffset place;
    bool is_flat = true;
  };

  std::optional<std::size_t> topic_;
  std::optional<Decoder> decoder_;
  std::map<std::string, Joint> joints_;  // by child
};

}  // namespace tcert::recording
