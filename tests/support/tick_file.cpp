#include "support/tick_file.hpp"

#include <istream>
#include <ostream>
#include <stdexcept>
#include <type_traits>

namespace tcert::test_support {
namespace {

/// One description of the file for both directions: `Stream` writes what it is given, or reads it.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}
  template <typename T>
  void value(const T& x) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    out_.write(reinterpret_cast<const char*>(&x), sizeof x);
  }
  template <typename List>
  void size_of(const List& list) {
    value(static_cast<std::uint64_t>(list.size()));
  }

 private:
  std::ostream& out_;
};

class Reader {
 public:
  explicit Reader(std::istream& in) : in_(in) {}
  template <typename T>
  void value(T& x) {
    if (!in_.read(reinterpret_cast<char*>(&x), sizeof x)) {
      throw std::runtime_error("the file of ticks is cut short");
    }
  }
  template <typename List>
  void size_of(List& list) {
    std::uint64_t size = 0;
    value(size);
    list.resize(size);
  }

 private:
  std::istream& in_;
};

template <typename Stream, typename List>
void numbers(Stream& stream, List& list) {
  stream.size_of(list);
  for (auto& x : list) {
    stream.value(x);
  }
}

template <typename Stream, typename P>
void point(Stream& stream, P& p) {
  stream.value(p.x_m);
  stream.value(p.y_m);
}

template <typename Stream, typename R>
void ray(Stream& stream, R& r) {
  numbers(stream, r.name);
  point(stream, r.mount);
  stream.value(r.bearing_rad);
  stream.value(r.reach_m);
  stream.value(r.kind);
  numbers(stream, r.calibration.bend_rad);
  numbers(stream, r.calibration.clearance_m);
}

void region(Writer& stream, const std::optional<Region>& r) {
  const int kind = !r ? 0 : std::holds_alternative<Disc>(*r) ? 1 : 2;
  stream.value(kind);
  if (kind == 1) {
    point(stream, std::get<Disc>(*r).centre);
    stream.value(std::get<Disc>(*r).radius_m);
  } else if (kind == 2) {
    const auto& vertices = std::get<Polygon>(*r).vertices;
    stream.size_of(vertices);
    for (const Point& p : vertices) {
      point(stream, p);
    }
  }
}

void region(Reader& stream, std::optional<Region>& r) {
  int kind = 0;
  stream.value(kind);
  if (kind == 1) {
    Disc disc;
    point(stream, disc.centre);
    stream.value(disc.radius_m);
    r = disc;
  } else if (kind == 2) {
    Polygon polygon;
    stream.size_of(polygon.vertices);
    for (Point& p : polygon.vertices) {
      point(stream, p);
    }
    r = polygon;
  }
}

template <typename Stream, typename T>
void tick(Stream& stream, T& t) {
  stream.value(t.time_ns);
  point(stream, t.pose.position);
  stream.value(t.pose.yaw_rad);
  stream.value(t.stale);
  stream.value(t.segment_start);
}

template <typename Stream, typename File>
void transfer(Stream& stream, File& file) {
  auto& robot = file.robot;
  stream.value(robot.body_width_m);
  stream.value(robot.min_turn_radius_m);
  stream.value(robot.tracking_buffer_m);
  stream.value(robot.curvature_buffer_per_m);
  stream.size_of(robot.rays);
  for (auto& r : robot.rays) {
    ray(stream, r);
  }
  region(stream, file.course.start);
  region(stream, file.course.goal);
  stream.size_of(file.trials);
  for (auto& trial : file.trials) {
    numbers(stream, trial.id);
    stream.size_of(trial.ticks);
    for (auto& t : trial.ticks) {
      tick(stream, t);
    }
    stream.size_of(trial.readings);
    for (auto& reading : trial.readings) {
      stream.value(reading.value);
      stream.value(reading.fsr_n);
    }
  }
}

}  // namespace

void write_tick_file(std::ostream& out, const TickFile& file) {
  Writer writer(out);
  writer.value(file.seed.has_value());
  writer.value(file.seed.value_or(0));
  transfer(writer, file);
}

TickFile read_tick_file(std::istream& in) {
  TickFile file;
  Reader reader(in);
  bool has_seed = false;
  std::uint64_t seed = 0;
  reader.value(has_seed);
  reader.value(seed);
  if (has_seed) {
    file.seed = seed;
  }
  transfer(reader, file);
  const std::size_t rays = file.robot.rays.size();
  for (TickFile::Trial& trial : file.trials) {
    for (std::size_t k = 0; k < trial.ticks.size(); ++k) {
      trial.ticks[k].rays = std::span(trial.readings).subspan(k * rays, rays);
    }
  }
  return file;
}

}  // namespace tcert::test_support
