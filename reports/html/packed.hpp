#pragma once
/// \file
/// Text as a web page can carry and unpack it.

#include <string>
#include <string_view>

namespace tcert {

/// Standard alphabet, padded, one line (RFC 4648).
[[nodiscard]] std::string base64(std::string_view bytes);

/// zlib stream (RFC 1950) of the text, as base64: what DecompressionStream('deflate') reads. The
/// same text gives the same bytes with the same zlib. \throws std::runtime_error if zlib fails.
[[nodiscard]] std::string packed(std::string_view text);

}  // namespace tcert
