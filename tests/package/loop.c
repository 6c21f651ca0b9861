/* The control loop of loop.cpp in C: a robot in a corridor with a gate in it. */

#include <math.h>
#include <stdio.h>
#include <tcert/tcert.h>

#define TICK_S 0.1
#define MOUNT_M 0.2

/* The simulated world: half the free width at x. */
static double half_width_m(double x_m) { return x_m > 2.5 && x_m < 3.0 ? 0.30 : 0.45; }

int main(void) {
  const tcert_ray rays[2] = {
      {"left", {MOUNT_M, 0.1}, 1.5707963267948966, 0.7, TCERT_RANGE, 0, NULL, NULL},
      {"right", {MOUNT_M, -0.1}, -1.5707963267948966, 0.7, TCERT_RANGE, 0, NULL, NULL}};
  tcert_robot robot = {0};
  tcert_course course = {0};
  tcert_parameters parameters;
  tcert_certifier* certifier = NULL;
  tcert_output now = {0};
  tcert_status status;
  char why[200];
  double x_m = 0.0;
  int k;

  robot.struct_size = sizeof robot;
  robot.ray_count = 2;
  robot.rays = rays;
  robot.body_width_m = 0.45;
  robot.min_turn_radius_m = 0.35;
  course.struct_size = sizeof course;
  course.start.kind = TCERT_DISC;
  course.start.radius_m = 0.5;
  course.goal.kind = TCERT_DISC;
  course.goal.centre.x_m = 5.0;
  course.goal.radius_m = 0.5;
  tcert_parameters_init(&parameters);
  parameters.speed_law = TCERT_CLIP;

  status = tcert_create(&robot, &course, &parameters, &certifier, why, sizeof why);
  if (status != TCERT_OK) {
    fprintf(stderr, "%s: %s\n", tcert_status_text(status), why);
    return 2;
  }
  now.struct_size = sizeof now;
  for (k = 0; k < 1000 && (now.flags & TCERT_GOAL_REACHED) == 0; ++k) {
    const double side_m = half_width_m(x_m + MOUNT_M) - 0.1;
    tcert_reading readings[2] = {{0.0, 0.0}, {0.0, 0.0}};
    tcert_tick tick = {0};
    readings[0].value = k == 40 ? NAN : side_m; /* the left ray misses one reading */
    readings[1].value = side_m;
    tick.struct_size = sizeof tick;
    tick.reading_count = 2;
    tick.readings = readings;
    tick.time_ns = k * (int64_t)100000000;
    tick.x_m = x_m;

    if (tcert_update(certifier, &tick, &now) != TCERT_OK) {
      return 2; /* only for what a program does wrong, never for what a sensor says */
    }
    if (k % 20 == 0) {
      printf("%5.1f s  x %.9f  m %.9f  V %.9f  v %.9f  %s\n",
             1e-9 * (double)now.time_ns,
             x_m,
             now.margin_m,
             now.corridor_value_m,
             now.speed_mps,
             tcert_flag_text(now.flags));
    }
    x_m += now.speed_mps * TICK_S;
  }
  printf("certificate %.17g, issued %d\n", now.certificate_m, now.issued ? 1 : 0);
  tcert_destroy(certifier);
  return now.issued ? 0 : 1;
}
