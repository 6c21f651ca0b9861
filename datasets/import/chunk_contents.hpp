#pragma once
/// \file
/// The records of a chunk, expanded.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "datasets/import/file_window.hpp"
#include "datasets/import/mcap_record.hpp"

struct ZSTD_DCtx_s;
struct LZ4F_dctx_s;

namespace tcert::recording {

/// Chunks, packed or not, are refused above this many bytes; recorders make them some megabytes.
inline constexpr std::size_t kLargestChunk = std::size_t{1} << 30U;

/// Expands one chunk after the other into the same memory. Movable.
class ChunkExpander {
 public:
  ChunkExpander();
  ~ChunkExpander();
  ChunkExpander(ChunkExpander&& other) noexcept;
  ChunkExpander& operator=(ChunkExpander&&) = delete;
  ChunkExpander(const ChunkExpander&) = delete;
  ChunkExpander& operator=(const ChunkExpander&) = delete;

  /// The records of `chunk`, valid until the next call (those of one that is not packed as long as
  /// the chunk itself); nothing, with the reason, if they cannot be had: damaged, packed by an
  /// unknown method, not of the size that the chunk says, larger than kLargestChunk, or not
  /// table::is_plausible_expansion() by itself or with all since release(). Its checksum is the
  /// caller's affair. \throws table::OutOfResources.
  [[nodiscard]] std::optional<std::span<const std::byte>> expand(const ChunkRecord& chunk,
                                                                 std::string& problem);

  /// The contents of a zstd frame that tells their length; as expand().
  [[nodiscard]] std::optional<std::span<const std::byte>> expand_zstd_frame(
      std::span<const std::byte> packed, std::string& problem);

  /// Ends a pass: gives the memory back, which the next expand() takes again.
  void release() noexcept;

 private:
  bool expand_zstd(std::span<const std::byte> packed, std::span<std::byte> out);
  bool expand_lz4(std::span<const std::byte> packed, std::span<std::byte> out);

  struct FreeZstd {
    void operator()(ZSTD_DCtx_s* context) const noexcept;
  };
  struct FreeLz4 {
    void operator()(LZ4F_dctx_s* context) const noexcept;
  };
  Buffer buffer_;
  std::size_t packed_bytes_ = 0;
  std::size_t expanded_bytes_ = 0;
  std::unique_ptr<ZSTD_DCtx_s, FreeZstd> zstd_;
  std::unique_ptr<LZ4F_dctx_s, FreeLz4> lz4_;
};

}  // namespace tcert::recording
