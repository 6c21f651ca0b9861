#pragma once
/// \file
/// The files of one trial, read one after another. Internal to trial_reader.cpp.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/bundle_files.hpp"
#include "datasets/stream_clock.hpp"
#include "datasets/trial_reader.hpp"

namespace tcert {

/// A file of the trial: rows with a value, in file order until its clock is settled.
struct Stream {
  table::NumberTable table;
  std::string file;
  bool rises = true;                        ///< Each time is after the one before, as in most logs.
  std::vector<std::int64_t> set_back_ns{};  ///< Where its path breaks since its clock was set back.
};

/// How the file `name` ("pose.csv"), found as `file`, is read.
[[nodiscard]] table::CsvOptions csv_of_stream(const Bundle& bundle,
                                              const std::string& name,
                                              const std::string& file);

/// Collects the problems of all files.
class StreamReader {
 public:
  StreamReader(const Bundle& bundle, const TrialRow& trial, const ReadOptions& options);

  /// True if the trial has the file `name`.
  [[nodiscard]] bool has(const std::string& name) const;

  /// Numbers of the file `name`, which the trial must have; empty if it is rejected.
  [[nodiscard]] std::optional<Stream> read(const std::string& name, table::NumberOptions columns);

  /// Puts the rows of streams that share one clock in order: they step back alike or not at all.
  /// What is wrong is reported.
  void settle_clocks(std::span<Stream* const> streams, EqualTimes equal_times);

  /// Gaps of a settled stream, each a warning, and where its clock was set back, in order of time.
  [[nodiscard]] std::vector<std::int64_t> breaks_of(const Stream& stream,
                                                    PathBreaks path = PathBreaks::here);

  /// "logs/<trial_id>/<name>".
  [[nodiscard]] std::string path_of(const std::string& name) const { return folder_ + name; }

  void report(table::Diagnostic diagnostic);
  void report(table::DiagnosticGroups& problems);

  /// True if the streams share their steps back, so that settle_clocks() can place all rows.
  [[nodiscard]] bool step_alike(std::span<Stream* const> streams) const;

  /// Makes warnings of the errors of the file `name`, without which the trial can do; true if there
  /// was any.
  bool forgive(const std::string& name);

  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] bool has_error() const noexcept { return table::has_error(diagnostics_); }
  [[nodiscard]] std::vector<table::Diagnostic> take_diagnostics();

 private:
  void settle_stamps(const table::Bytes& bytes,
                     const table::CsvOptions& csv,
                     Stream& stream,
                     table::DiagnosticGroups& problems) const;

  const Bundle& bundle_;
  BundleFiles files_;
  std::string folder_;
  ReadOptions options_;
  std::vector<table::Diagnostic> diagnostics_;
  std::size_t bytes_ = 0;
};

}  // namespace tcert
