// How fast recordings are read, in how much memory: bag_speed [MB ...] (200 and 2000 if none is
// given). Writes an MCAP of laser scans (1,080 ranges and intensities, 40 Hz) and odometry (200 Hz)
// for each size and packing into the temporary folder, reads it in a process of its own for each
// measurement, and says MB (of unpacked file) per second of CPU, and the peak of resident memory.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zstd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/decoder.hpp"
#include "datasets/import/file_window.hpp"
#include "datasets/import/mcap_record.hpp"
#include "support/cdr_bytes.hpp"
#include "support/mcap_writer.hpp"

namespace {

using namespace tcert;
using namespace tcert::recording;
using test_support::CdrBytes;

constexpr int kBeams = 1080;
constexpr int kOdometryPerScan = 5;
constexpr std::size_t kScans = 256;  // that differ
constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;

void put_header(CdrBytes& cdr, std::size_t number, const char* frame) {
  cdr.put(static_cast<std::int32_t>(1'700'000'000 + number / 200));
  cdr.put(static_cast<std::uint32_t>(number % 200 * 5'000'000)).text(frame);
}

std::string scan(std::size_t number, std::mt19937& random) {
  std::normal_distribution<float> noise(0.0F, 0.01F);
  CdrBytes cdr;
  put_header(cdr, number * kOdometryPerScan, "laser");
  for (const float value : {-2.36F, 2.36F, 0.00436F, 0.0F, 0.025F, 0.05F, 30.0F}) {
    cdr.put(value);
  }
  cdr.put(static_cast<std::uint32_t>(kBeams));
  for (int i = 0; i < kBeams; ++i) {
    const float range =
        3.0F + 2.0F * std::sin(0.01F * static_cast<float>(i) + 0.1F * static_cast<float>(number));
    cdr.put(std::round((range + noise(random)) * 1000.0F) / 1000.0F);
  }
  cdr.put(static_cast<std::uint32_t>(kBeams));
  for (int i = 0; i < kBeams; ++i) {
    cdr.put(static_cast<float>(random() % 4096));
  }
  return cdr.bytes();
}

std::string odometry(std::size_t number) {
  CdrBytes cdr;
  put_header(cdr, number, "odom");
  cdr.text("base_link");
  const double phase = 0.001 * static_cast<double>(number);
  for (const double value : {std::sin(phase),
                             std::cos(phase),
                             0.0,
                             0.0,
                             0.0,
                             std::sin(phase / 2),
                             std::cos(phase / 2)}) {
    cdr.put(value);
  }
  for (int i = 0; i < 36; ++i) {
    cdr.put(i % 7 == 0 ? 0.01 : 0.0);
  }
  for (int i = 0; i < 6 + 36; ++i) {
    cdr.put(i == 0 ? 0.5 : 0.0);
  }
  return cdr.bytes();
}

/// Bytes of the file without packing.
std::size_t write_bag(const std::filesystem::path& path,
                      std::size_t bytes,
                      const std::string& compression) {
  std::ofstream out(path, std::ios::binary);
  test_support::McapWriter writer(out, {true, compression, kChunkBytes});
  writer.schema(1,
                "sensor_msgs/msg/LaserScan",
                "ros2msg",
                builtin_definition("sensor_msgs/msg/LaserScan").value_or(""));
  writer.schema(2,
                "nav_msgs/msg/Odometry",
                "ros2msg",
                builtin_definition("nav_msgs/msg/Odometry").value_or(""));
  writer.channel(1, 1, "/scan", "cdr");
  writer.channel(2, 2, "/odom", "cdr");
  std::mt19937 random(1);
  std::vector<std::string> scans(kScans);
  for (std::size_t i = 0; i < kScans; ++i) {
    scans[i] = scan(i, random);
  }
  std::size_t written = 0;
  for (std::size_t number = 0; written < bytes; ++number) {
    const bool is_scan = number % (kOdometryPerScan + 1) == 0;
    const std::string data =
        is_scan ? scans[number / (kOdometryPerScan + 1) % kScans] : odometry(number);
    writer.message(is_scan ? 1 : 2, number * 4'000'000, number * 4'000'000, data);
    written += data.size() + 31;
  }
  writer.finish();
  return written;
}

struct Measurement {
  double cpu_s = 0.0;
  double peak_mb = 0.0;
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Runs `work` in a process of its own, `times` times, and takes the fastest.
Measurement measured(const std::function<void()>& work, int times = 3) {
  Measurement best;
  for (int i = 0; i < times; ++i) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      std::_Exit(0);
    }
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    if (status != 0) {
      std::fputs("a measurement failed\n", stderr);
      std::exit(1);
    }
    const double cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    if (i == 0 || cpu_s < best.cpu_s) {
      best = {cpu_s, static_cast<double>(usage.ru_maxrss) / 1024.0};
    }
  }
  return best;
}

void require(bool holds) {
  if (!holds) {
    std::_Exit(1);
  }
}

void read_bag(const std::filesystem::path& path, bool decodes) {
  table::DiagnosticGroups problems;
  const auto bag = open_mcap(path, problems);
  require(bag != nullptr);
  std::vector<std::size_t> wanted(bag->topics().size());
  std::iota(wanted.begin(), wanted.end(), 0);
  std::vector<Value> values(wanted.size());
  std::vector<Decoder> decoders;
  std::string problem;
  for (const Topic& topic : bag->topics()) {
    decoders.push_back(Decoder::of(topic, problem).value());
  }
  std::size_t messages = 0;
  bag->for_each(
      wanted,
      [&](const RawMessage& message) {
        ++messages;
        return !decodes || decoders[message.topic](message.data, values[message.topic], problem);
      },
      problems);
  require(messages == bag->topics()[0].messages + bag->topics()[1].messages);
  require(problems.take().empty());
}

/// What zstd alone needs for the same chunks.
void expand_chunks(const std::filesystem::path& path) {
  std::string problem;
  auto window = FileWindow::open(path, problem);
  require(window.has_value());
  std::vector<char> out(2 * kChunkBytes);
  ZSTD_DCtx* context = ZSTD_createDCtx();
  for (std::uint64_t at = kMcapMagic.size(); at + kRecordHeadBytes < window->size();) {
    const auto head = record_head(window->at(at, kRecordHeadBytes));
    if (!head || head->opcode == Opcode::data_end) {
      break;
    }
    const auto record = window->at(at, kRecordHeadBytes + head->length);
    if (head->opcode == Opcode::chunk) {
      const auto chunk = chunk_record(record.subspan(kRecordHeadBytes));
      require(ZSTD_decompressDCtx(
                  context, out.data(), out.size(), chunk->records.data(), chunk->records.size()) ==
              chunk->uncompressed_size);
    }
    at += kRecordHeadBytes + head->length;
  }
  ZSTD_freeDCtx(context);
}

void show(const char* what, std::size_t bytes, const Measurement& result) {
  std::printf("  %-22s %7.0f MB/s   %6.1f MB of memory\n",
              what,
              static_cast<double>(bytes) / 1e6 / result.cpu_s,
              result.peak_mb);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::size_t> sizes_mb;
  for (int i = 1; i < argc; ++i) {
    sizes_mb.push_back(std::strtoul(argv[i], nullptr, 10));
  }
  if (sizes_mb.empty()) {
    sizes_mb = {200, 2000};
  }
  const auto path =
      std::filesystem::temp_directory_path() / ("tcert_bag_speed_" + std::to_string(::getpid()));
  for (const char* compression : {"", "zstd", "lz4"}) {
    for (const std::size_t mb : sizes_mb) {
      const std::size_t bytes = write_bag(path, mb * 1'000'000, compression);
      std::printf("%zu MB, chunks %s, %.0f MB on disk\n",
                  mb,
                  *compression == '\0' ? "not packed" : compression,
                  static_cast<double>(std::filesystem::file_size(path)) / 1e6);
      show("read", bytes, measured([&] { read_bag(path, false); }));
      show("read and decode", bytes, measured([&] { read_bag(path, true); }));
      if (std::string_view(compression) == "zstd") {
        show("zstd alone", bytes, measured([&] { expand_chunks(path); }));
      }
      std::filesystem::remove(path);
    }
  }
  return 0;
}
