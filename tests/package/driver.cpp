// A policy as a process of its own: it reads what `tcert drive` says a robot senses, and answers
// each line with a command. It drives as M3 does, gated by the certificate as it goes. With the
// path of a socket, that of `tcert drive --listen unix:PATH`; without, of --stdio.

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <sstream>
#include <string>
#include <tcert/certifier.hpp>
#include <tcert/policy.hpp>
#include <tcert/speed_gate.hpp>
#include <vector>

namespace {

using tcert::kMissing;

// The robot of these trials; a real one would be read from the line "# robot".
tcert::Robot robot() {
  const tcert::Calibration calibration{{0.0, 0.15, 0.35, 0.6, 0.9, 1.2},
                                       {0.45, 0.40, 0.32, 0.22, 0.10, 0.0}};
  tcert::Robot robot;
  robot.body_width_m = 0.45;
  robot.min_turn_radius_m = 0.35;
  robot.rays = {
      {"left", {0.16, 0.12}, 1.5707963267948966, 0.45, tcert::RayKind::bend, calibration},
      {"right", {0.16, -0.12}, -1.5707963267948966, 0.45, tcert::RayKind::bend, calibration},
      {"front", {0.22, 0.0}, 0.0, 0.45, tcert::RayKind::bend, calibration}};
  return robot;
}

// Cells of a line of CSV; an empty one is missing.
std::vector<double> cells_of(const std::string& line) {
  std::vector<double> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) {
    cells.push_back(cell.empty() ? kMissing : std::stod(cell));
  }
  cells.resize(24, kMissing);
  return cells;
}

tcert::policies::CourseLine read_course(std::string& header) {
  tcert::policies::CourseLine line;
  while (std::getline(std::cin, header) && header.starts_with("# ")) {
    std::istringstream words(header.substr(2));
    std::string word;
    words >> word;
    if (word == "box") {
      words >> line.low.x_m >> line.low.y_m >> line.high.x_m >> line.high.y_m;
    } else if (word == "lane") {
      std::size_t lobe = 0;
      std::size_t lane = 0;
      words >> lobe >> lane;
      line.lobes.resize(std::max(line.lobes.size(), lobe + 1));
      auto& points = line.lobes[lobe].lanes.emplace_back();
      for (tcert::Point p; words >> p.x_m >> p.y_m;) {
        points.push_back(p);
      }
    }
  }
  return line;
}

// Lets standard input and output be a connection.
bool talk_to(const char* path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path, sizeof address.sun_path - 1);
  const int end = socket(AF_UNIX, SOCK_STREAM, 0);
  return connect(end, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
         dup2(end, STDIN_FILENO) >= 0 && dup2(end, STDOUT_FILENO) >= 0;
}

}  // namespace

int main(int count, char** words) {
  if (count > 1 && !talk_to(words[1])) {
    std::perror(words[1]);
    return 1;
  }
  std::string header;
  tcert::policies::PolicySetup setup;
  setup.robot = robot();
  setup.line = read_course(header);
  tcert::policies::Policy policy(tcert::policies::PolicyKind::m3, setup);
  tcert::Certifier certifier(setup.robot, {}, setup.certificate);
  const tcert::SpeedLaw law;

  std::array<tcert::RayReading, 3> readings;
  tcert::CertifiedTick certified;
  tcert::policies::Command command{kMissing, 0.0};
  std::string line;
  for (long step = 0; std::getline(std::cin, line); ++step) {
    const std::vector<double> cells = cells_of(line);
    // time_s, x_m, y_m, yaw_rad, three rays with value, force and bearing, two commands, two flags.
    tcert::policies::Senses senses;
    senses.tick.time_ns = std::llround(cells[0] * 1e9);
    senses.tick.pose = {{cells[1], cells[2]}, cells[3]};
    for (std::size_t k = 0; k < readings.size(); ++k) {
      readings[k] = {cells[4 + 3 * k], cells[5 + 3 * k], cells[6 + 3 * k]};
    }
    senses.tick.rays = readings;
    senses.tick.stale = cells[15] == 1.0;
    senses.tick.segment_start = cells[16] == 1.0;
    senses.goal = {cells[17], cells[18]};
    senses.travel_m = cells[19];
    senses.speed_mps = cells[20];
    if (!std::isnan(cells[22])) {
      senses.bump = tcert::policies::Bump{cells[21], cells[22]};
    }
    senses.commanded_mps = command.speed_mps;
    if (step % 5 == 0) {  // at 10 Hz, of control steps at 50
      certified = certifier.update(senses.tick);
    }
    command =
        tcert::policies::gated(policy.step(senses), law, certified.margin_m, setup.parameters);
    std::printf("%.17g,%.17g\n", command.speed_mps, command.yaw_rate_rps);
    std::fflush(stdout);
  }
  return 0;
}
