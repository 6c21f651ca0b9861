#pragma once
/// \file
/// The audit log of a live run.

#include <cstddef>
#include <string>
#include <string_view>
#include <tcert/runtime.hpp>
#include <tcert/tick.hpp>
#include <vector>

#include "cli/runs/live/patient_output.hpp"

namespace tcert::cli {

/// Rows that are on disk, as far as the system goes, before the next tick is looked at. A disk that
/// is full does not end the run: it is said once, the rows that find no room are counted, and the
/// file never ends in half a row.
class LiveAudit {
 public:
  /// What an earlier run left goes at the first tick. \throws WriteError if the file cannot be
  /// written, is a link or no file, holds anything but an audit log, or another run writes it.
  LiveAudit(std::string path, const GuardParameters& parameters, std::vector<std::string> rules);
  ~LiveAudit();
  LiveAudit(const LiveAudit&) = delete;
  LiveAudit& operator=(const LiveAudit&) = delete;

  void add(const Tick& tick,
           const CertifiedTick& certified,
           const ActedTick& acted,
           StatusLines& status);

  /// False if rows were lost, which is said.
  [[nodiscard]] bool close(StatusLines& status);

 private:
  /// Zero, or why not all of it could be written.
  [[nodiscard]] int append(std::string_view rows) noexcept;

  std::string path_;
  const GuardParameters& parameters_;
  std::vector<std::string> rules_;
  int descriptor_ = -1;
  long long size_ = 0;  ///< Bytes of whole rows.
  bool was_empty_ = false;
  bool failed_ = false;  ///< At some tick, which was said.
  std::size_t lost_ = 0;
  std::string text_;
};

}  // namespace tcert::cli
