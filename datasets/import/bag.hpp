#pragma once
/// \file
/// Recordings of ROS and Foxglove (MCAP, rosbag2) as topics and messages, one format or another.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::recording {

/// A topic of a bag: all its channels of the same name, type and encoding.
struct Topic {
  std::string name;      ///< "/odom"
  std::string type;      ///< canonical_type(): "nav_msgs/msg/Odometry"; of JSON the schema's name.
  std::string encoding;  ///< Of its messages: "cdr", "ros1", "json", "protobuf", ...
  std::string definition;  ///< Text of the type, or empty where the file has none.
  std::string
      definition_encoding;   ///< "ros2msg", "ros1msg", "ros2idl", "jsonschema", ... or empty.
  std::size_t messages = 0;  ///< 0 also if it is not known before reading.
};

/// A message as it lies in the file. `data` is valid during the call that shows it only.
struct RawMessage {
  std::size_t topic = 0;        ///< Index into topics().
  std::int64_t log_ns = 0;      ///< When it was recorded.
  std::int64_t publish_ns = 0;  ///< When it was sent; log_ns where the format does not tell.
  std::span<const std::byte> data;
};

/// Takes a message; false ends the pass.
using MessageVisitor = std::function<bool(const RawMessage&)>;

/// A bag opened for reading. One pass at a time; memory is that of the largest chunk, whatever the
/// length of the file. Nothing is thrown for what the file holds. Not safe for concurrent use.
class Bag {
 public:
  virtual ~Bag() = default;
  Bag() = default;
  Bag(const Bag&) = delete;
  Bag& operator=(const Bag&) = delete;
  Bag(Bag&&) = delete;
  Bag& operator=(Bag&&) = delete;

  /// In the order in which the file names them; the same from opening to the end.
  [[nodiscard]] virtual const std::vector<Topic>& topics() const = 0;

  /// Shows the messages of the `wanted` topics (indices into topics()) in the order of the file,
  /// which need not be that of either time. What is wrong with the file (cut off, a checksum that
  /// does not fit, ...) is added to `problems` with its byte offset, once in the life of the bag:
  /// what open_mcap() or an earlier pass has said is not said again. A damaged part is left out and
  /// said so (warning); the messages shown before it stay valid.
  virtual void for_each(std::span<const std::size_t> wanted,
                        const MessageVisitor& visit,
                        table::DiagnosticGroups& problems) = 0;
};

/// An MCAP file (mcap.dev/spec): chunks plain, zstd or lz4, or none. Topics and counts are those of
/// its summary section; without one that holds together the file is read once for them. A file that
/// is cut off is read to its last whole chunk, and a warning says so.
/// \returns nullptr, with an error in `problems`, iff no message of it can be read.
/// \throws table::OutOfResources.
[[nodiscard]] std::unique_ptr<Bag> open_mcap(const std::filesystem::path& path,
                                             table::DiagnosticGroups& problems);

enum class BagKind { none, mcap, sqlite, folder };

/// What `path` is by its first bytes, never by its name: a folder is one if it is
/// that of one recording: with a metadata.yaml of rosbag2, or with .db3 or .mcap files whose names
/// differ in their numbers alone ("run_0.db3", "run_1.db3"). `none` also if it cannot be read.
[[nodiscard]] BagKind bag_kind(const std::filesystem::path& path);

/// Whatever bag_kind() says:
///
/// - an MCAP file, as open_mcap();
/// - the database of a rosbag2 (.db3), opened for reading alone: a write-ahead log that a recorder
///   left beside it is honoured, and nothing is written beside it;
/// - a folder with several such files, in the order of its metadata.yaml or, without one, of their
///   names, as one bag. One that cannot be read is left out (warning) unless it is the only one.
///
/// \returns nullptr, with an error in `problems`, iff no message of it can be read.
/// \throws table::OutOfResources.
[[nodiscard]] std::unique_ptr<Bag> open_bag(const std::filesystem::path& path,
                                            table::DiagnosticGroups& problems);

/// True if `bytes`, the first of a file, are those of an MCAP file, of an SQLite database.
[[nodiscard]] bool begins_as_mcap(std::string_view bytes) noexcept;
[[nodiscard]] bool begins_as_sqlite(std::string_view bytes) noexcept;

}  // namespace tcert::recording
