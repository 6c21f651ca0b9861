#include "datasets/perturb/perturb_stream.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <table/cell_reading.hpp>
#include <tcert/elementary.hpp>
#include <utility>

#include "datasets/bundle_fields.hpp"
#include "datasets/perturb/perturbed_row.hpp"
#include "datasets/tick_columns.hpp"

namespace tcert::perturb {
namespace {

constexpr std::size_t kParts = 3;  // of a ray: its value, its force, its bearing
enum Part : std::size_t { value_part, force_part, bearing_part };

/// Cells of one ray in a row.
using RayCells = std::array<std::string, kParts>;

/// Where in a row the cells of a ray are, as far as the file has them.
using RayColumns = std::array<std::optional<std::size_t>, kParts>;

/// A fault that is going on.
struct ActiveFault {
  Injection* fault = nullptr;
  std::optional<RayCells> held{};  ///< Of a freeze, once there was a reading to hold.
};

class StreamPerturbation {
 public:
  StreamPerturbation(const StreamText& stream,
                     const table::CsvHeader& header,
                     const BundleInfo& info,
                     double wide_share,
                     std::vector<Injection>& faults)
      : stream_(stream),
        header_(header),
        info_(info),
        wide_share_(wide_share),
        faults_(faults),
        arrival_(header.find(kArrivalColumn)),
        adds_arrival_(!arrival_ && std::ranges::any_of(faults,
                                                       [](const Injection& one) {
                                                         return one.kind == FaultKind::latency;
                                                       })),
        row_(header.dialect) {
    for (const Ray& ray : info.robot.rays) {
      rays_.push_back({header.find(value_column(ray)),
                       header.find(force_column(ray)),
                       header.find(bearing_column(ray))});
    }
    said_.resize(rays_.size());
  }

  PerturbedText run() {
    const std::string_view text = stream_.bytes.view();
    const char* done = text.data();
    copy_header(done);
    const std::size_t time_column = header_.find("time_s").value();
    table::CsvCursor cursor = header_.data;
    while (table::skip_to_record(cursor)) {
      out_.text.append(done, cursor.at);  // comments and blank lines
      done = cursor.at;
      const bool is_whole = row_.read(cursor, header_.names.size());  // not a last line that is cut
      if (const auto time_ns = row_.seconds(time_column); is_whole && time_ns) {
        time_ns_ = *time_ns;
        take_row({done, static_cast<std::size_t>(cursor.at - done)});
      }
      done = cursor.at;
    }
    out_.text.append(done, text.data() + text.size());
    return std::move(out_);
  }

 private:
  /// Everything up to the first row, with a new column at its end if there is to be one.
  void copy_header(const char*& done) {
    const char* end = header_.data.at;
    if (adds_arrival_) {
      const char* line_end = end;
      while (line_end != done && (line_end[-1] == '\n' || line_end[-1] == '\r')) {
        --line_end;
      }
      out_.text.append(done, line_end);
      out_.text += header_.dialect.separator;
      out_.text += kArrivalColumn;
      done = line_end;
    }
    out_.text.append(done, end);
    done = end;
  }

  void take_row(std::string_view raw) {
    update_active();
    const bool is_lost = meet_dropouts();
    if (!is_lost || stream_.is_merged) {
      change_rays();
      state_arrival();
      row_.write(raw, out_.text);
      remember();
    }
    out_.samples += 1;
  }

  void update_active() {
    std::erase_if(active_, [&](const ActiveFault& one) { return one.fault->end_ns <= time_ns_; });
    for (; next_ < faults_.size() && faults_[next_].start_ns <= time_ns_; ++next_) {
      if (faults_[next_].end_ns > time_ns_) {
        active_.push_back({&faults_[next_]});
      }
    }
  }

  bool meet_dropouts() {
    const auto lost = std::ranges::find_if(
        active_, [](const ActiveFault& one) { return one.fault->kind == FaultKind::dropout; });
    const bool is_end = time_ns_ == stream_.first_ns || time_ns_ == stream_.last_ns;
    if (lost == active_.end() || (is_end && !stream_.is_merged)) {
      return false;
    }
    if (stream_.is_merged && !blank_rays()) {
      return false;
    }
    meet(*lost->fault);
    lost->fault->size = static_cast<double>(lost->fault->samples);
    return true;
  }

  /// True if there was anything.
  bool blank_rays() {
    bool any = false;
    for (const RayColumns& ray : rays_) {
      for (const auto& column : ray) {
        if (column && !row_.is_missing(*column)) {
          row_.blank(*column);
          any = true;
        }
      }
    }
    return any;
  }

  void change_rays() {
    for (ActiveFault& one : active_) {
      if (!one.fault->ray) {
        continue;
      }
      const std::size_t ray = *one.fault->ray;
      switch (one.fault->kind) {
        case FaultKind::spike:
          add_spike(*one.fault, rays_[ray]);
          break;
        case FaultKind::freeze:
          hold(one, ray);
          break;
        case FaultKind::wide:
          stick(*one.fault, ray);
          break;
        case FaultKind::bias:
          add_bias(*one.fault, ray);
          break;
        case FaultKind::dropout:
        case FaultKind::latency:
          break;
      }
    }
  }

  void add_spike(Injection& fault, const RayColumns& ray) {
    const std::optional<double> force = row_.number(ray[force_part]);
    if (force) {
      const double share = static_cast<double>(time_ns_ - fault.start_ns) /
                           static_cast<double>(fault.end_ns - fault.start_ns);
      row_.set(*ray[force_part], *force + fault.size * elementary::sin(std::numbers::pi * share));
      meet(fault);
    }
  }

  void hold(ActiveFault& one, std::size_t ray) {
    const RayColumns& columns = rays_[ray];
    const std::optional<double> value = row_.number(columns[value_part]);
    if (!one.held && (said_[ray] || value)) {
      one.held = said_[ray] ? *said_[ray] : cells_of(ray);
      one.fault->size =
          table::read_cell((*one.held)[value_part], header_.dialect.decimal_point).value;
    }
    if (!one.held || !value) {
      return;
    }
    for (std::size_t part = 0; part < kParts; ++part) {
      const std::string& held = (*one.held)[part];
      if (columns[part] && !table::is_missing_cell(held) && !row_.is_missing(*columns[part])) {
        row_.set_text(*columns[part], held);
      }
    }
    meet(*one.fault);
  }

  void stick(Injection& fault, std::size_t ray) {
    const RayColumns& columns = rays_[ray];
    if (!row_.number(columns[value_part])) {
      return;
    }
    const Ray& of = info_.robot.rays[ray];
    const double clearance_m = wide_share_ * longest_clearance(of);
    fault.size = of.kind == RayKind::bend ? calibrated_bend(of.calibration, clearance_m)
                                          : std::min(clearance_m, keys_of(ray).range_max_m);
    row_.set(*columns[value_part], fault.size);
    if (row_.number(columns[force_part])) {
      row_.set(*columns[force_part], 0.0);
    }
    meet(fault);
  }

  void add_bias(Injection& fault, std::size_t ray) {
    const std::optional<std::size_t> column = rays_[ray][value_part];
    const std::optional<double> value = row_.number(column);
    const Ray& of = info_.robot.rays[ray];
    if (!value) {
      return;
    }
    double biased = *value;
    if (of.kind == RayKind::bend) {
      const auto [least, most] = std::ranges::minmax(of.calibration.clearance_m);
      const double clearance = calibrated_clearance(of.calibration, *value);
      const double wanted = std::clamp(clearance + fault.size, least, most);
      biased = wanted == clearance ? *value : calibrated_bend(of.calibration, wanted);
    } else if (*value < of.reach_m && *value >= 0.0 && !says_nothing(ray, *value)) {
      biased = std::clamp(*value + fault.size, keys_of(ray).range_min_m, of.reach_m);
      biased = says_nothing(ray, biased) ? *value : biased;
    }
    if (biased != *value) {
      row_.set(*column, biased);
      meet(fault);
    }
  }

  [[nodiscard]] RangeKeys keys_of(std::size_t ray) const {
    return ray < info_.range_keys.size() ? info_.range_keys[ray] : RangeKeys{};
  }

  /// True of a range that its ray declares to be none.
  [[nodiscard]] bool says_nothing(std::size_t ray, double value) const {
    return is_no_return(keys_of(ray).no_return, value);
  }

  void state_arrival() {
    std::int64_t arrival_ns = time_ns_;
    for (ActiveFault& one : active_) {
      if (one.fault->kind == FaultKind::latency) {
        arrival_ns = std::max(arrival_ns, one.fault->end_ns);
        meet(*one.fault);
      }
    }
    if (adds_arrival_) {
      row_.append_seconds(arrival_ns);
    } else if (arrival_ns > time_ns_) {
      row_.set_seconds(*arrival_, std::max(row_.seconds(*arrival_).value_or(time_ns_), arrival_ns));
    }
  }

  /// What the rays said at last, for freezes to come.
  void remember() {
    for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
      if (row_.number(rays_[ray][value_part])) {
        said_[ray] = cells_of(ray);
      }
    }
  }

  [[nodiscard]] RayCells cells_of(std::size_t ray) const {
    RayCells cells;
    for (std::size_t part = 0; part < kParts; ++part) {
      if (rays_[ray][part]) {
        cells[part] = row_.text(*rays_[ray][part]);
      }
    }
    return cells;
  }

  void meet(Injection& fault) {
    ++fault.samples;
    row_.touch();
  }

  const StreamText& stream_;
  const table::CsvHeader& header_;
  const BundleInfo& info_;
  double wide_share_;
  std::vector<Injection>& faults_;
  std::optional<std::size_t> arrival_;
  bool adds_arrival_;
  std::vector<RayColumns> rays_;
  std::vector<std::optional<RayCells>> said_;
  std::vector<ActiveFault> active_;
  std::size_t next_ = 0;
  std::int64_t time_ns_ = 0;
  PerturbedRow row_;
  PerturbedText out_;
};

}  // namespace

PerturbedText perturb_stream(const StreamText& stream,
                             const BundleInfo& info,
                             double wide_share,
                             std::vector<Injection>& faults) {
  table::DiagnosticGroups problems;
  const auto header = table::find_header(
      stream.bytes.view(), stream.csv, table::required_names(stream.columns), problems);
  if (!header) {
    return {};
  }
  return StreamPerturbation(stream, *header, info, wide_share, faults).run();
}

}  // namespace tcert::perturb
