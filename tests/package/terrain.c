/* A robot that feels its ground, in C: the ground is a formula, the planner is libtcert_terrain. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <terrain/terrain_c.h>

/* Firm round the middle of the map, soft in a pit beside the way. No slope exceeds 0.9 a cell. */
static double feel(int x, int y) {
  const double pit = 20.0 - sqrt((x - 30.0) * (x - 30.0) + (y - 16.0) * (y - 16.0));
  return 10.0 - 0.2 * fabs(y - 20.0) - (pit > 0.0 ? 0.6 * pit : 0.0);
}

static void require(tcert_terrain_status status, const char* why) {
  if (status != TCERT_TERRAIN_OK) {
    fprintf(stderr, "%s\n", why);
    exit(1);
  }
}

int main(void) {
  tcert_terrain_setup setup;
  tcert_terrain* ground = NULL;
  char why[200] = "";
  tcert_terrain_setup_init(&setup);
  setup.rows = 60;
  setup.columns = 40;
  setup.threshold = 2.0;
  setup.lipschitz = 0.9;
  setup.length_scale = 10.0;
  setup.start_x = 5;
  setup.start_y = 20;
  setup.has_goal = 1;
  setup.goal_x = 55;
  setup.goal_y = 22;
  setup.body_radius = 1.0;
  require(tcert_terrain_create(&setup, NULL, &ground, why, sizeof why), why);
  for (int x = 3; x <= 7; ++x) {
    for (int y = 18; y <= 22; ++y) {
      const int d2 = (x - 5) * (x - 5) + (y - 20) * (y - 20);
      if (d2 > 0 && d2 <= 4) {
        require(tcert_terrain_take(ground, x, y, feel(x, y), why, sizeof why), why);
      }
    }
  }
  int x = setup.start_x;
  int y = setup.start_y;
  double length = 0.0;
  for (;;) {
    tcert_terrain_decision now = {.struct_size = sizeof now};
    require(tcert_terrain_plan(ground, x, y, feel(x, y), &now, why, sizeof why), why);
    double* way = malloc(2 * sizeof(double) * (size_t)(now.way_points + 1));
    tcert_terrain_way(ground, way, (size_t)now.way_points);
    double at_x = x;
    double at_y = y;
    for (size_t k = 0; k < now.way_points; ++k) {
      length += hypot(way[2 * k] - at_x, way[2 * k + 1] - at_y);
      at_x = way[2 * k];
      at_y = way[2 * k + 1];
      if (feel((int)lround(at_x), (int)lround(at_y)) < setup.threshold) {
        fprintf(stderr, "soft ground at %g, %g\n", at_x, at_y);
        return 1;
      }
    }
    free(way);
    if (now.end != TCERT_TERRAIN_GOES_ON) {
      printf("end %d after %d measurements, %.1f cells of way, certificate %.3f\n",
             now.end,
             now.step + 1,
             length,
             now.certificate);
      tcert_terrain_destroy(ground);
      return now.end == TCERT_TERRAIN_REACHED ? 0 : 1;
    }
    x = now.next_x;
    y = now.next_y;
  }
}
