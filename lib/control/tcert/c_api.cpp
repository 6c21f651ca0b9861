#include <tcert/tcert.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <tcert/c_conversions.hpp>
#include <tcert/flag_word.hpp>
#include <tcert/runtime.hpp>
#include <vector>

struct tcert_certifier {
  tcert::Runtime runtime;
  std::vector<tcert::RayReading> readings;  // one more than rays, so that a wrong number shows
};

using namespace tcert;
using namespace tcert::c_interface;

namespace {

void say(char* message, std::size_t size, const char* text) noexcept {
  if (message == nullptr || size == 0) {
    return;
  }
  const std::size_t length = std::min(std::strlen(text), size - 1);
  std::memcpy(message, text, length);
  message[length] = '\0';
}

}  // namespace

std::uint32_t tcert_abi_version(void) noexcept { return TCERT_ABI_VERSION; }

const char* tcert_version(void) noexcept { return TCERT_VERSION; }

const char* tcert_status_text(tcert_status status) noexcept {
  switch (status) {
    case TCERT_OK:
      return "done";
    case TCERT_ERROR_ARGUMENT:
      return "a null pointer where there must be none";
    case TCERT_ERROR_VERSION:
      return "a struct_size that is not set, or of a header that is newer than the library";
    case TCERT_ERROR_PARAMETER:
      return "robot, course or parameters out of range";
    case TCERT_ERROR_MEMORY:
      return "not enough memory";
    case TCERT_ERROR_INTERNAL:
      return "internal error";
  }
  return "unknown status";
}

const char* tcert_flag_text(std::uint32_t flag) noexcept { return flag_word(flag); }

tcert_status tcert_parameters_init_sized(tcert_parameters* parameters,
                                         std::uint32_t struct_size) noexcept {
  if (parameters == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_parameters>(struct_size)) {
    return TCERT_ERROR_VERSION;
  }
  parameters->struct_size = struct_size;
  give(default_parameters(), *parameters);
  return TCERT_OK;
}

tcert_status tcert_create(const tcert_robot* robot,
                          const tcert_course* course,
                          const tcert_parameters* parameters,
                          tcert_certifier** certifier,
                          char* message,
                          std::size_t message_size) noexcept {
  if (certifier != nullptr) {
    *certifier = nullptr;
  }
  if (robot == nullptr || course == nullptr || parameters == nullptr || certifier == nullptr) {
    say(message, message_size, tcert_status_text(TCERT_ERROR_ARGUMENT));
    return TCERT_ERROR_ARGUMENT;
  }
  tcert_status status = TCERT_ERROR_INTERNAL;
  try {
    const tcert_parameters whole = whole_parameters(*parameters);
    const Robot known = to_robot(*robot);
    *certifier = new tcert_certifier{Runtime(to_course(*course), to_actions(whole, known)),
                                     std::vector<RayReading>(known.rays.size() + 1)};
    say(message, message_size, "");
    return TCERT_OK;
  } catch (const WrongSize& error) {
    status = TCERT_ERROR_VERSION;
    say(message, message_size, error.what());
  } catch (const std::invalid_argument& error) {
    status = TCERT_ERROR_PARAMETER;
    say(message, message_size, error.what());
  } catch (const std::bad_alloc&) {
    status = TCERT_ERROR_MEMORY;
    say(message, message_size, tcert_status_text(status));
  } catch (const std::exception& error) {
    say(message, message_size, error.what());
  } catch (...) {
    say(message, message_size, tcert_status_text(status));
  }
  return status;
}

tcert_status tcert_update(tcert_certifier* certifier,
                          const tcert_tick* tick,
                          tcert_output* output) noexcept {
  if (certifier == nullptr || tick == nullptr || output == nullptr ||
      (tick->readings == nullptr && tick->reading_count > 0)) {
    return TCERT_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_tick>(tick->struct_size) ||
      !is_known_size<tcert_output>(output->struct_size)) {
    return TCERT_ERROR_VERSION;
  }
  tcert_tick without_footing{};
  without_footing.pitch_rad = without_footing.roll_rad = kMissing;
  without_footing.step_m = without_footing.slip = kMissing;
  const tcert_tick whole = completed(*tick, without_footing);
  std::vector<RayReading>& readings = certifier->readings;
  const std::size_t count = std::min<std::size_t>(whole.reading_count, readings.size());
  for (std::size_t k = 0; k < count; ++k) {
    readings[k] = {whole.readings[k].value,
                   whole.readings[k].force_n,
                   whole.bearings_rad == nullptr ? kMissing : whole.bearings_rad[k]};
  }
  const Tick felt{whole.time_ns,
                  {{whole.x_m, whole.y_m}, whole.yaw_rad},
                  std::span(readings).first(count),
                  whole.stale != 0,
                  whole.segment_start != 0,
                  {whole.pitch_rad, whole.roll_rad, whole.step_m, whole.slip}};
  give(to_output(certifier->runtime.update(felt)), *output);
  return TCERT_OK;
}

tcert_status tcert_step(tcert_certifier* certifier,
                        const tcert_command* wanted,
                        double x_m,
                        double y_m,
                        double yaw_rad,
                        double seconds,
                        tcert_command* command,
                        std::int32_t* state) noexcept {
  if (certifier == nullptr || wanted == nullptr || command == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  for (const double value : {wanted->speed_mps, wanted->yaw_rate_rps, x_m, y_m, yaw_rad, seconds}) {
    if (!(std::abs(value) <= kLargestPose)) {
      return TCERT_ERROR_ARGUMENT;
    }
  }
  if (seconds < 0.0) {
    return TCERT_ERROR_ARGUMENT;
  }
  const Command taken = certifier->runtime.step(
      {wanted->speed_mps, wanted->yaw_rate_rps}, {{x_m, y_m}, yaw_rad}, seconds);
  *command = {taken.speed_mps, taken.yaw_rate_rps};
  if (state != nullptr) {
    *state = static_cast<std::int32_t>(certifier->runtime.actions().fallback().state());
  }
  return TCERT_OK;
}

const char* tcert_rule_name(const tcert_certifier* certifier, std::uint32_t rule) noexcept {
  if (certifier == nullptr) {
    return "";
  }
  const auto& rules = certifier->runtime.actions().monitor().rules();
  return rule < rules.size() ? rules[rule].name.c_str() : "";
}

tcert_status tcert_ray_margins(const tcert_certifier* certifier,
                               double* margins_m,
                               std::uint32_t count) noexcept {
  if (certifier == nullptr || (margins_m == nullptr && count > 0)) {
    return TCERT_ERROR_ARGUMENT;
  }
  const auto known = certifier->runtime.certifier().ray_margins();
  for (std::size_t k = 0; k < count; ++k) {
    margins_m[k] = k < known.size() ? known[k] : kMissing;
  }
  return TCERT_OK;
}

tcert_status tcert_find_bottleneck(const tcert_certifier* certifier,
                                   tcert_bottleneck* bottleneck,
                                   std::int32_t* found) noexcept {
  if (certifier == nullptr || bottleneck == nullptr || found == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_bottleneck>(bottleneck->struct_size)) {
    return TCERT_ERROR_VERSION;
  }
  const auto narrowest = certifier->runtime.certifier().bottleneck();
  *found = narrowest ? 1 : 0;
  if (narrowest) {
    const tcert_bottleneck whole{sizeof whole,
                                 narrowest->edge,
                                 narrowest->pose.position.x_m,
                                 narrowest->pose.position.y_m,
                                 narrowest->pose.yaw_rad,
                                 narrowest->margin_m,
                                 narrowest->width_m,
                                 narrowest->turn_radius_m};
    give(whole, *bottleneck);
  }
  return TCERT_OK;
}

tcert_status tcert_reset(tcert_certifier* certifier) noexcept {
  if (certifier == nullptr) {
    return TCERT_ERROR_ARGUMENT;
  }
  certifier->runtime.reset();
  return TCERT_OK;
}

void tcert_destroy(tcert_certifier* certifier) noexcept { delete certifier; }
