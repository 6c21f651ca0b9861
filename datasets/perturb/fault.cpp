#include "datasets/perturb/fault.hpp"

#include <table/csv_write.hpp>

namespace tcert::perturb {

std::string_view to_string(FaultKind kind) noexcept {
  switch (kind) {
    case FaultKind::dropout:
      return "dropout";
    case FaultKind::latency:
      return "latency";
    case FaultKind::spike:
      return "spike";
    case FaultKind::freeze:
      return "freeze";
    case FaultKind::wide:
      return "wide";
    case FaultKind::bias:
      return "bias";
  }
  return "";
}

bool FaultOptions::any() const noexcept {
  return dropout_good_s > 0.0 || bursts_per_hour > 0.0 || spikes_per_hour > 0.0 ||
         freezes_per_hour > 0.0 || wide_per_hour > 0.0 || biases_per_hour > 0.0 || bias_whole_trial;
}

std::string_view unit_of(const Injection& one, std::span<const Ray> rays) noexcept {
  switch (one.kind) {
    case FaultKind::dropout:
      return "samples";
    case FaultKind::latency:
      return "s";
    case FaultKind::spike:
      return "N";
    case FaultKind::freeze:
    case FaultKind::wide:
      return one.ray && rays[*one.ray].kind == RayKind::bend ? "rad" : "m";
    case FaultKind::bias:
      return "m";
  }
  return "";
}

std::string injections_header() { return "trial_id,kind,stream,ray,start_s,end_s,size,unit\n"; }

void append_injection(std::string& out,
                      const std::string& trial_id,
                      std::string_view stream,
                      const Injection& one,
                      std::span<const Ray> rays) {
  table::append_text(out, trial_id);
  out += ',';
  out += to_string(one.kind);
  out += ',';
  out += stream;
  out += ',';
  if (one.ray) {
    table::append_text(out, rays[*one.ray].name);
  }
  for (const std::int64_t time_ns : {one.start_ns, one.end_ns}) {
    out += ',';
    table::append_seconds(out, time_ns);
  }
  table::append_cell(out, one.size);
  out += ',';
  out += unit_of(one, rays);
  out += '\n';
}

}  // namespace tcert::perturb
