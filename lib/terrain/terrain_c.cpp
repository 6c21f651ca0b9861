#include <terrain/terrain_c.h>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <terrain/session.hpp>
#include <terrain/terrain_c_setup.hpp>
#include <utility>

using namespace tcert::terrain;

struct tcert_terrain {
  tcert_terrain(const Grid& grid, ExploreSetup setup, const Told& told)
      : session(grid, std::move(setup), told) {}

  Session session;
  std::vector<Position> way;
};

namespace {

void say(char* why, std::size_t size, const char* text) noexcept {
  if (why != nullptr && size > 0) {
    std::snprintf(why, size, "%s", text);
  }
}

/// Of a caller's struct: no larger than here, and with its size in it.
template <class Struct>
[[nodiscard]] constexpr bool is_known_size(std::size_t size) noexcept {
  return size >= sizeof(std::size_t) && size <= sizeof(Struct);
}

/// Runs `work`; what it throws becomes a status.
template <class Work>
[[nodiscard]] tcert_terrain_status guarded(char* why, std::size_t size, Work work) noexcept {
  try {
    work();
    return TCERT_TERRAIN_OK;
  } catch (const std::bad_alloc&) {
    say(why, size, "not enough memory");
    return TCERT_TERRAIN_ERROR_MEMORY;
  } catch (const std::invalid_argument& error) {
    say(why, size, error.what());
    return TCERT_TERRAIN_ERROR_INPUT;
  } catch (const std::domain_error& error) {
    say(why, size, error.what());
    return TCERT_TERRAIN_ERROR_INPUT;
  } catch (const std::exception& error) {
    say(why, size, error.what());
    return TCERT_TERRAIN_ERROR_INTERNAL;
  }
}

[[nodiscard]] std::int32_t end_of(const std::optional<End>& end) noexcept {
  if (!end) {
    return TCERT_TERRAIN_GOES_ON;
  }
  switch (*end) {
    case End::reached:
      return TCERT_TERRAIN_REACHED;
    case End::explored:
      return TCERT_TERRAIN_EXPLORED;
    case End::exhausted:
      return TCERT_TERRAIN_EXHAUSTED;
    case End::step_limit:
      return TCERT_TERRAIN_LIMIT;
    default:
      return TCERT_TERRAIN_STRANDED;
  }
}

[[nodiscard]] tcert_terrain_decision decision_of(const Decision& decision) noexcept {
  tcert_terrain_decision now{};
  now.struct_size = sizeof now;
  now.step = decision.row.step;
  now.end = end_of(decision.end);
  now.next_x = now.next_y = -1;
  if (!decision.end || decision.end == End::reached) {
    // Without a way the robot is there already.
    const Cell last = nearest_cell(decision.way.empty() ? decision.row.at : decision.way.back());
    now.next_x = last.x;
    now.next_y = last.y;
  }
  now.safe_cells = decision.row.safe;
  now.way_points = decision.way.size();
  now.certificate = decision.row.certificate.value_or(std::numeric_limits<double>::quiet_NaN());
  now.lipschitz = decision.row.lipschitz;
  now.travelled = decision.row.travelled;
  return now;
}

[[nodiscard]] std::vector<double> layer_of(const Layers& layers, std::int32_t kind) {
  switch (kind) {
    case TCERT_TERRAIN_SAFE:
      return {layers.safe.begin(), layers.safe.end()};
    case TCERT_TERRAIN_STANDING:
      return {layers.standing.begin(), layers.standing.end()};
    case TCERT_TERRAIN_LOWER:
      return layers.lower;
    case TCERT_TERRAIN_UPPER:
      return layers.upper;
    case TCERT_TERRAIN_MEAN:
      return layers.mean;
    case TCERT_TERRAIN_SD:
      return layers.sd;
    case TCERT_TERRAIN_CERTIFICATE:
      return layers.certificate;
    default:
      throw std::invalid_argument("no such layer");
  }
}

}  // namespace

std::int32_t tcert_terrain_abi_version(void) noexcept { return TCERT_TERRAIN_ABI_VERSION; }

tcert_terrain_status tcert_terrain_setup_init_sized(tcert_terrain_setup* setup,
                                                    std::size_t struct_size) noexcept {
  if (setup == nullptr) {
    return TCERT_TERRAIN_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_terrain_setup>(struct_size)) {
    return TCERT_TERRAIN_ERROR_VERSION;
  }
  tcert_terrain_setup all = default_setup_in_c();
  all.struct_size = struct_size;
  std::memcpy(setup, &all, struct_size);
  return TCERT_TERRAIN_OK;
}

tcert_terrain_status tcert_terrain_create(const tcert_terrain_setup* setup,
                                          const std::uint8_t* blocked,
                                          tcert_terrain** terrain,
                                          char* why,
                                          std::size_t why_size) noexcept {
  if (setup == nullptr || terrain == nullptr) {
    say(why, why_size, "setup and terrain must not be null");
    return TCERT_TERRAIN_ERROR_ARGUMENT;
  }
  *terrain = nullptr;
  if (!is_known_size<tcert_terrain_setup>(setup->struct_size)) {
    say(why, why_size, "tcert_terrain_setup: its size is that of no header of this library");
    return TCERT_TERRAIN_ERROR_VERSION;
  }
  tcert_terrain_setup known = default_setup_in_c();
  std::memcpy(&known, setup, setup->struct_size);
  return guarded(why, why_size, [&] {
    const Told told{known.lipschitz != 0.0, false, false};
    auto made = std::make_unique<tcert_terrain>(
        Grid{known.rows, known.columns}, setup_of(known, blocked), told);
    *terrain = made.release();
  });
}

void tcert_terrain_destroy(tcert_terrain* terrain) noexcept { delete terrain; }

tcert_terrain_status tcert_terrain_take(tcert_terrain* terrain,
                                        std::int32_t x,
                                        std::int32_t y,
                                        double value,
                                        char* why,
                                        std::size_t why_size) noexcept {
  if (terrain == nullptr) {
    say(why, why_size, "terrain must not be null");
    return TCERT_TERRAIN_ERROR_ARGUMENT;
  }
  return guarded(why, why_size, [&] { terrain->session.take({x, y}, value); });
}

tcert_terrain_status tcert_terrain_plan(tcert_terrain* terrain,
                                        std::int32_t x,
                                        std::int32_t y,
                                        double value,
                                        tcert_terrain_decision* decision,
                                        char* why,
                                        std::size_t why_size) noexcept {
  if (terrain == nullptr || decision == nullptr) {
    say(why, why_size, "terrain and decision must not be null");
    return TCERT_TERRAIN_ERROR_ARGUMENT;
  }
  if (!is_known_size<tcert_terrain_decision>(decision->struct_size)) {
    say(why, why_size, "tcert_terrain_decision: its size is that of no header of this library");
    return TCERT_TERRAIN_ERROR_VERSION;
  }
  return guarded(why, why_size, [&] {
    const Decision& made = terrain->session.plan({x, y}, value);
    terrain->way = made.way;
    tcert_terrain_decision now = decision_of(made);
    now.struct_size = decision->struct_size;
    std::memcpy(decision, &now, decision->struct_size);
  });
}

std::size_t tcert_terrain_way(const tcert_terrain* terrain,
                              double* xy,
                              std::size_t capacity) noexcept {
  if (terrain == nullptr) {
    return 0;
  }
  const std::size_t count = xy == nullptr ? 0 : std::min(capacity, terrain->way.size());
  for (std::size_t k = 0; k < count; ++k) {
    xy[2 * k] = terrain->way[k].x();
    xy[2 * k + 1] = terrain->way[k].y();
  }
  return terrain->way.size();
}

tcert_terrain_status tcert_terrain_layer(const tcert_terrain* terrain,
                                         std::int32_t kind,
                                         double* values) noexcept {
  if (terrain == nullptr || values == nullptr) {
    return TCERT_TERRAIN_ERROR_ARGUMENT;
  }
  return guarded(nullptr, 0, [&] {
    if (terrain->session.explorer() == nullptr) {
      throw std::invalid_argument("there was no plan yet");
    }
    const std::vector<double> layer = layer_of(terrain->session.explorer()->layers(), kind);
    std::copy(layer.begin(), layer.end(), values);
  });
}
