#include "datasets/import/chunk_contents.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <table/diagnostic.hpp>
#include <table/regular_file.hpp>

namespace tcert::recording {

ChunkExpander::ChunkExpander() = default;
ChunkExpander::~ChunkExpander() = default;
ChunkExpander::ChunkExpander(ChunkExpander&&) noexcept = default;

void ChunkExpander::FreeZstd::operator()(ZSTD_DCtx_s* context) const noexcept {
  ZSTD_freeDCtx(context);
}

void ChunkExpander::FreeLz4::operator()(LZ4F_dctx_s* context) const noexcept {
  LZ4F_freeDecompressionContext(context);
}

/// Frame by frame until `out` is full; what lies behind the last frame is padding.
bool ChunkExpander::expand_zstd(std::span<const std::byte> packed, std::span<std::byte> out) {
  if (!zstd_) {
    zstd_.reset(ZSTD_createDCtx());
  }
  while (!out.empty()) {
    const std::size_t frame = ZSTD_findFrameCompressedSize(packed.data(), packed.size());
    if (ZSTD_isError(frame) != 0U) {
      return false;
    }
    const std::size_t written =
        ZSTD_decompressDCtx(zstd_.get(), out.data(), out.size(), packed.data(), frame);
    if (ZSTD_isError(written) != 0U) {
      return false;
    }
    packed = packed.subspan(frame);
    out = out.subspan(written);
  }
  return true;
}

bool ChunkExpander::expand_lz4(std::span<const std::byte> packed, std::span<std::byte> out) {
  if (!lz4_) {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0U) {
      throw table::OutOfResources("there is not enough memory to expand lz4");
    }
    lz4_.reset(context);
  }
  LZ4F_resetDecompressionContext(lz4_.get());
  LZ4F_decompressOptions_t options{};
  options.stableDst = 1;
  std::size_t state = 1;
  while (state != 0 || !out.empty()) {
    std::size_t taken = packed.size();
    std::size_t written = out.size();
    state = LZ4F_decompress(lz4_.get(), out.data(), &written, packed.data(), &taken, &options);
    if (LZ4F_isError(state) != 0U || (taken == 0 && written == 0)) {
      return false;
    }
    packed = packed.subspan(taken);
    out = out.subspan(written);
  }
  return true;
}

std::optional<std::span<const std::byte>> ChunkExpander::expand(const ChunkRecord& chunk,
                                                                std::string& problem) {
  const bool is_zstd = chunk.compression == "zstd";
  if (chunk.compression.empty() || chunk.compression == "none") {
    problem = "its length is not the one that it says";
    return chunk.records.size() == chunk.uncompressed_size ? std::optional(chunk.records)
                                                           : std::nullopt;
  }
  if (!is_zstd && chunk.compression != "lz4") {
    problem = "packed by '" + table::shortened(chunk.compression) + "', which is not read";
    return std::nullopt;
  }
  if (chunk.uncompressed_size > kLargestChunk ||
      !table::is_plausible_expansion(chunk.records.size(),
                                     static_cast<std::size_t>(chunk.uncompressed_size))) {
    problem = std::to_string(chunk.records.size()) + " bytes that say they expand to " +
              std::to_string(chunk.uncompressed_size);
    return std::nullopt;
  }
  packed_bytes_ += chunk.records.size();
  expanded_bytes_ += static_cast<std::size_t>(chunk.uncompressed_size);
  if (!table::is_plausible_expansion(packed_bytes_, expanded_bytes_)) {
    problem =
        "all chunks up to it expand to more than 200 times their length, as those of no log do";
    return std::nullopt;
  }
  const auto out = buffer_.room(static_cast<std::size_t>(chunk.uncompressed_size));
  if (out.empty()) {
    return out;
  }
  if (is_zstd ? expand_zstd(chunk.records, out) : expand_lz4(chunk.records, out)) {
    return out;
  }
  problem = is_zstd ? "its zstd data are damaged" : "its lz4 data are damaged";
  return std::nullopt;
}

std::optional<std::span<const std::byte>> ChunkExpander::expand_zstd_frame(
    std::span<const std::byte> packed, std::string& problem) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN) {
    problem = "its zstd data do not tell their length";
    return std::nullopt;
  }
  ChunkRecord whole;
  whole.uncompressed_size = size;
  whole.compression = "zstd";
  whole.records = packed;
  return expand(whole, problem);
}

void ChunkExpander::release() noexcept {
  packed_bytes_ = 0;
  expanded_bytes_ = 0;
  buffer_.release();
  zstd_.reset();
  lz4_.reset();
}

}  // namespace tcert::recording
