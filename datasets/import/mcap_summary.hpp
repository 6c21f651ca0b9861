#pragma once
/// \file
/// The end of an MCAP file: where its sections are, and what the summary section says.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/import/file_window.hpp"
#include "datasets/import/mcap_topics.hpp"

namespace tcert::recording {

/// Offsets from the beginning of the file.
struct McapFooter {
  std::uint64_t data_end = 0;       ///< Behind the data section.
  std::uint64_t summary_start = 0;  ///< 0: there is none.
  std::uint64_t summary_end = 0;
  std::uint64_t checked_end = 0;  ///< What the checksum of the summary is taken up to.
  std::uint32_t summary_crc = 0;  ///< 0: none.
};

/// Nothing if the file does not end as one that was closed: with a footer whose offsets lie in the
/// file, and the magic bytes.
[[nodiscard]] std::optional<McapFooter> mcap_footer(FileWindow& window);

/// What a summary section says that holds together.
struct McapSummary {
  McapTopics topics;  ///< With their counts.
};

/// Reads the summary section; memory is that of its topics. Nothing if there is none or it has no
/// statistics, and also, then with a reason in `problem`, if its checksum does not fit, a record is
/// not whole, its counts do not add up, or it counts messages of channels that it does not list.
[[nodiscard]] std::optional<McapSummary> mcap_summary(FileWindow& window, std::string& problem);

}  // namespace tcert::recording
