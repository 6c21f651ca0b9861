// Throughput of the CSV reader on files like those of a trial, beside counting their lines.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <table/csv_write.hpp>

namespace tcert::table {
namespace {

constexpr std::size_t kRows = 200'000;

/// Rounded to `decimals`, as a logger writes it.
double rounded(double value, double scale) { return std::round(value * scale) / scale; }

Bytes numbers_file(std::size_t columns, double scale) {
  std::string text = "time_s";
  for (std::size_t c = 0; c < columns; ++c) {
    text += ",c" + std::to_string(c);
  }
  text += '\n';
  for (std::size_t row = 0; row < kRows; ++row) {
    append_seconds(text, static_cast<std::int64_t>(row) * 12'048'193);
    for (std::size_t c = 0; c < columns; ++c) {
      const double phase = 0.001 * static_cast<double>(row) + static_cast<double>(c);
      text += ',';
      append_number(text, scale > 0.0 ? rounded(3.0 * std::sin(phase), scale) : std::sin(phase));
    }
    text += '\n';
  }
  return Bytes::copy_of(text);
}

NumberOptions all_columns(std::size_t columns) {
  NumberOptions options;
  for (std::size_t c = 0; c < columns; ++c) {
    options.columns.push_back({"c" + std::to_string(c), true, false});
  }
  return options;
}

void read(benchmark::State& state, std::size_t columns, double scale) {
  const Bytes bytes = numbers_file(columns, scale);
  const NumberOptions options = all_columns(columns);
  for (auto _ : state) {
    DiagnosticGroups problems;
    auto table = read_numbers(bytes, {}, options, problems);
    benchmark::DoNotOptimize(table);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
}

void BM_ReadPose(benchmark::State& state) { read(state, 3, 1e6); }
void BM_ReadTactile(benchmark::State& state) { read(state, 8, 1e4); }
void BM_ReadSeventeenDigits(benchmark::State& state) { read(state, 8, 0.0); }

void BM_SkipAllButOneColumn(benchmark::State& state) {
  const Bytes bytes = numbers_file(8, 1e4);
  for (auto _ : state) {
    DiagnosticGroups problems;
    auto table = read_numbers(bytes, {}, all_columns(1), problems);
    benchmark::DoNotOptimize(table);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
}

/// What `wc -l` does, without reading the file.
void BM_CountLines(benchmark::State& state) {
  const Bytes bytes = numbers_file(8, 1e4);
  for (auto _ : state) {
    benchmark::DoNotOptimize(std::ranges::count(bytes.view(), '\n'));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
}

BENCHMARK(BM_ReadPose)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReadTactile)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReadSeventeenDigits)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SkipAllButOneColumn)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CountLines)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tcert::table
