#include <table/bytes.hpp>

#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <new>
#include <system_error>
#include <table/regular_file.hpp>
#include <utility>

namespace tcert::table {

namespace {

constexpr std::size_t kLongestFile = std::size_t{4} << 30U;
constexpr std::size_t kLargestStep = std::size_t{1} << 30U;  // fits zlib's 32-bit counts

BytesResult failure(std::string problem) { return {std::nullopt, std::move(problem)}; }

/// Room for `size` bytes that come from `source`. \throws OutOfResources.
Bytes room_for(std::size_t size) {
  try {
    return Bytes(size);
  } catch (const std::bad_alloc&) {
    throw OutOfResources("there is not enough memory for a file of " + std::to_string(size) +
                         " bytes");
  }
}

/// Makes room for more output of `packed` bytes; the reason why not, or nothing.
std::string grow(Bytes& out, std::size_t packed) {
  if (out.size() >= kLongestFile) {
    return "its contents are longer than 4 GiB";
  }
  if (!is_plausible_expansion(packed, out.size())) {
    return "its contents are more than 200 times as long as the file, as those of no log are; "
           "expand "
           "it to look into it";
  }
  Bytes larger = room_for(std::min(kLongestFile, std::max<std::size_t>(out.size() * 2, 1U << 16U)));
  std::copy_n(out.data(), out.size(), larger.data());
  out = std::move(larger);
  return {};
}

/// z_stream that is always ended.
class Inflater {
 public:
  Inflater() { ready_ = inflateInit2(&stream, MAX_WBITS + 16) == Z_OK; }
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  [[nodiscard]] bool ready() const noexcept { return ready_; }

  z_stream stream{};

 private:
  bool ready_ = false;
};

BytesResult expand_gzip(Bytes packed) {
  Inflater inflater;
  z_stream& z = inflater.stream;
  if (!inflater.ready()) {
    return failure("zlib cannot start");
  }
  Bytes out = room_for(std::min(kLongestFile, packed.size() * 4));
  std::size_t taken = 0;
  std::size_t written = 0;
  int state = Z_OK;
  while (taken < packed.size() || state == Z_OK) {
    if (written == out.size()) {
      if (std::string problem = grow(out, packed.size()); !problem.empty()) {
        return failure(std::move(problem));
      }
    }
    if (state == Z_STREAM_END) {
      inflateReset(&z);
    }
    const std::size_t input = std::min(kLargestStep, packed.size() - taken);
    const std::size_t room = std::min(kLargestStep, out.size() - written);
    z.next_in = reinterpret_cast<Bytef*>(packed.data() + taken);
    z.avail_in = static_cast<uInt>(input);
    z.next_out = reinterpret_cast<Bytef*>(out.data() + written);
    z.avail_out = static_cast<uInt>(room);
    state = inflate(&z, Z_NO_FLUSH);
    taken += input - z.avail_in;
    written += room - z.avail_out;
    if (state != Z_OK && state != Z_STREAM_END) {
      return failure(state == Z_BUF_ERROR ? "the gzip data are cut short"
                                          : "the gzip data are damaged");
    }
  }
  out.resize(written);
  return {std::move(out), {}};
}

BytesResult expand_zstd(Bytes packed) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                          &ZSTD_freeDStream);
  Bytes out = room_for(std::min(kLongestFile, packed.size() * 4));
  ZSTD_inBuffer input{packed.data(), packed.size(), 0};
  ZSTD_outBuffer output{out.data(), out.size(), 0};
  std::size_t state = 1;
  while (input.pos < input.size || state != 0) {
    if (output.pos == output.size) {
      if (std::string problem = grow(out, packed.size()); !problem.empty()) {
        return failure(std::move(problem));
      }
      output.dst = out.data();
      output.size = out.size();
    }
    const std::size_t before = input.pos + output.pos;
    state = ZSTD_decompressStream(stream.get(), &output, &input);
    if (ZSTD_isError(state) != 0U) {
      return failure("the zstd data are damaged");
    }
    if (state != 0 && input.pos + output.pos == before && output.pos < output.size) {
      return failure("the zstd data are cut short");
    }
  }
  out.resize(output.pos);
  return {std::move(out), {}};
}

}  // namespace

Bytes::Bytes(std::size_t size)
    : size_(size),
      capacity_(size),
      data_(std::make_unique_for_overwrite<char[]>(  // NOLINT(modernize-avoid-c-arrays)
          size + kPadding)) {
  pad();
}

void Bytes::pad() noexcept {
  std::memset(data_.get() + size_, 0, kPadding);
  data_[size_] = '\n';
}

Bytes Bytes::copy_of(std::string_view text) {
  Bytes bytes;
  bytes.assign(text);
  return bytes;
}

void Bytes::resize(std::size_t size) {
  if (size > capacity_) {
    Bytes larger(size);
    std::copy_n(data_.get(), size_, larger.data_.get());
    *this = std::move(larger);
    return;
  }
  size_ = size;
  pad();
}

void Bytes::assign(std::string_view text) {
  if (text.size() > capacity_) {
    *this = Bytes(text.size());
  }
  size_ = text.size();
  std::copy_n(text.data(), text.size(), data_.get());
  pad();
}

Compression compression_of(std::string_view bytes) noexcept {
  if (bytes.starts_with("\x1F\x8B")) {
    return Compression::gzip;
  }
  return bytes.starts_with("\x28\xB5\x2F\xFD") ? Compression::zstd : Compression::none;
}

BytesResult decompress(Bytes packed, Compression compression) {
  switch (compression) {
    case Compression::gzip:
      return expand_gzip(std::move(packed));
    case Compression::zstd:
      return expand_zstd(std::move(packed));
    case Compression::none:
      break;
  }
  return {std::move(packed), {}};
}

BytesResult read_raw_file(const std::filesystem::path& path) {
  std::string problem;
  const int descriptor = open_regular_file(path, problem);
  if (descriptor < 0) {
    return failure(std::move(problem));
  }
  struct Close {
    int descriptor;
    ~Close() { ::close(descriptor); }
  };
  const Close close{descriptor};
  struct stat status {};
  ::fstat(descriptor, &status);
  const auto length = static_cast<std::size_t>(status.st_size);
  if (length > kLongestFile) {
    return failure("it is longer than 4 GiB");
  }
  Bytes bytes = room_for(length);
  std::size_t size = 0;
  while (size < length) {
    const ssize_t taken = ::read(descriptor, bytes.data() + size, length - size);
    if (taken < 0 && errno != EINTR) {
      return failure(std::generic_category().message(errno));
    }
    if (taken == 0) {
      break;
    }
    size += taken > 0 ? static_cast<std::size_t>(taken) : 0;
  }
  bytes.resize(size);
  return {std::move(bytes), {}};
}

BytesResult read_file(const std::filesystem::path& path) {
  BytesResult result = read_raw_file(path);
  if (!result.bytes) {
    return result;
  }
  const Compression compression = compression_of(result.bytes->view());
  return decompress(std::move(*result.bytes), compression);
}

}  // namespace tcert::table
