// The series of trials by the core alone, one after the other on stdout, as `certify` writes each:
//   core_series [--c] FILE       FILE of export_ticks; --c: through the C interface
//   core_series --swept FILE     with clearance=swept
//   core_series --steady FILE    no output: updates between two marks, for a tracer of system calls

#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/guards.hpp>

#include "reports/series.hpp"
#include "support/c_words.hpp"
#include "support/tick_file.hpp"

namespace {

using namespace tcert;
using test_support::TickFile;

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

CertificateParameters reading(ClearanceReading clearance) {
  CertificateParameters parameters;
  parameters.clearance = clearance;
  return parameters;
}

void print_by_cpp(const TickFile& file, const SeriesFormat& format, ClearanceReading clearance) {
  Certifier certifier(file.robot, file.course, reading(clearance));
  std::string text;
  for (const TickFile::Trial& trial : file.trials) {
    certifier.reset();
    text = series_header(format, file.robot);
    for (const Tick& tick : trial.ticks) {
      append_series_row(text, tick, certifier.update(tick), {}, format);
    }
    print(text);
  }
}

bool print_by_c(const TickFile& file, const SeriesFormat& format) {
  test_support::CSetup setup(file.robot, file.course);
  tcert_certifier* certifier = nullptr;
  if (setup.create(certifier) != TCERT_OK) {
    std::fprintf(stderr, "%s\n", setup.message.data());
    return false;
  }
  std::vector<tcert_reading> readings;
  std::string text;
  for (const TickFile::Trial& trial : file.trials) {
    tcert_reset(certifier);
    text = series_header(format, file.robot);
    for (const Tick& tick : trial.ticks) {
      const tcert_tick felt = test_support::to_c(tick, readings);
      tcert_output out = test_support::empty_output();
      if (tcert_update(certifier, &felt, &out) != TCERT_OK) {
        return false;
      }
      append_series_row(text, tick, test_support::certified(out), {}, format);
    }
    print(text);
  }
  tcert_destroy(certifier);
  return true;
}

/// Both interfaces and the swept area, every trial, with guards; nothing else happens between the
/// marks.
bool run_steadily(const TickFile& file) {
  Certifier certifier(file.robot, file.course, {});
  Certifier swept(file.robot, file.course, reading(ClearanceReading::swept));
  Guards guards({file.robot, {}, {}, {}, TrackingErrorTable()});
  test_support::CSetup setup(file.robot, file.course);
  tcert_certifier* by_c = nullptr;
  if (setup.create(by_c) != TCERT_OK) {
    return false;
  }
  std::vector<tcert_reading> readings(file.robot.rays.size());
  std::size_t ticks = 0;
  double sum = 0.0;
  [[maybe_unused]] auto marked = ::write(STDOUT_FILENO, "begin\n", 6);
  for (const TickFile::Trial& trial : file.trials) {
    certifier.reset();
    swept.reset();
    tcert_reset(by_c);
    for (const Tick& tick : trial.ticks) {
      sum += guards.update(tick, certifier.update(tick)).speed_mps;
      const tcert_tick felt = test_support::to_c(tick, readings);
      tcert_output out = test_support::empty_output();
      tcert_update(by_c, &felt, &out);
      sum += out.speed_mps;
      sum += swept.update(tick).corridor_value_m > 0.0 ? 1e-9 : 0.0;
      ++ticks;
    }
  }
  marked = ::write(STDOUT_FILENO, "end\n", 4);
  std::printf(
      "%zu ticks, each by both interfaces and by the swept area; sum of speeds %g\n", ticks, sum);
  tcert_destroy(by_c);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc == 3 ? argv[1] : "";
  if (argc < 2 || argc > 3 ||
      (argc == 3 && mode != "--c" && mode != "--swept" && mode != "--steady")) {
    std::fprintf(stderr, "core_series [--c | --swept | --steady] FILE\n");
    return 2;
  }
  std::ifstream stream(argv[argc - 1], std::ios::binary);
  const TickFile file = test_support::read_tick_file(stream);
  if (mode == "--steady") {
    return run_steadily(file) ? 0 : 1;
  }
  SeriesFormat format;
  if (file.seed) {
    format.synthetic = SyntheticLabel{*file.seed};
  }
  if (mode == "--c") {
    return print_by_c(file, format) ? 0 : 1;
  }
  print_by_cpp(file, format, mode == "--swept" ? ClearanceReading::swept : ClearanceReading::width);
  return 0;
}
