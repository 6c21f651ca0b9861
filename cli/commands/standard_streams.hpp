#pragma once
/// \file
/// The descriptors 0, 1 and 2, as other code takes them for granted.

namespace tcert::cli {

/// Opens on /dev/null those of them that the process was started without: else the first file that
/// is opened gets the number of stdout or stderr, and words or rows land in it. To be called before
/// anything else is opened.
void open_standard_streams() noexcept;

}  // namespace tcert::cli
