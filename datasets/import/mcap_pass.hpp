#pragma once
/// \file
/// One pass through the records of an MCAP file's data section, in the order of the file.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <table/diagnostic.hpp>

#include "datasets/import/chunk_contents.hpp"
#include "datasets/import/file_window.hpp"
#include "datasets/import/mcap_record.hpp"

namespace tcert::recording {

/// What a pass shows. A handler that is empty is not called.
struct McapHandlers {
  std::function<void(const SchemaRecord&)> schema;
  std::function<void(const ChannelRecord&)> channel;
  std::function<bool(const MessageRecord&)> message;  ///< False ends the pass.
};

/// A file that is being read, and what is known of it from earlier passes.
struct McapFile {
  FileWindow window;
  std::string name;  ///< In diagnostics.
  ChunkExpander expander = {};
  std::uint64_t told_to = 0;  ///< Problems before this byte have been said, checksums compared.
  bool has_damaged_chunks = false;  ///< Of which the checksum does not fit: all are compared again.
  bool is_summed = false;           ///< The checksum of the whole section has been compared.
};

struct McapPassEnd {
  std::uint64_t messages = 0;  ///< That were met, of any channel.
  bool stopped = false;        ///< By a handler.
  bool complete = false;       ///< To the end of the data section, with nothing left out.
};

/// Reads from the first record to the end of the data section. Chunks that are damaged are left
/// out, a file that is cut off ends at its last whole record; each is said once in the life of
/// `file`, as a warning with its byte offset. Checksums are compared the first time. \throws
/// table::OutOfResources, and what a handler throws.
[[nodiscard]] McapPassEnd pass_through(McapFile& file,
                                       const McapHandlers& handlers,
                                       table::DiagnosticGroups& problems);

}  // namespace tcert::recording
