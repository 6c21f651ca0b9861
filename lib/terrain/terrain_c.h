/* clang-format off */
/**
 * \file
 * The planner of granular terrain for C, and for every language that calls C.
 *
 *     tcert_terrain_setup setup;
 *     tcert_terrain_setup_init(&setup);
 *     setup.rows = 600; setup.columns = 400; setup.threshold = 1000; setup.lipschitz = 18.8;
 *     setup.start_x = 230; setup.start_y = 220; setup.has_goal = 1; setup.goal_x = 104; ...
 *     tcert_terrain* ground;
 *     if (tcert_terrain_create(&setup, &ground, why, sizeof why) != TCERT_TERRAIN_OK) ...
 *     for (each cell round the start)
 *       tcert_terrain_take(ground, x, y, feel(x, y), why, sizeof why);
 *     tcert_terrain_decision now = {.struct_size = sizeof now};
 *     x = start_x; y = start_y;
 *     for (;;) {
 *       tcert_terrain_plan(ground, x, y, feel(x, y), &now, why, sizeof why);
 *       if (now.end != TCERT_TERRAIN_GOES_ON) break;
 *       walk(tcert_terrain_way(ground, ...));
 *       x = now.next_x; y = now.next_y;
 *     }
 *     tcert_terrain_destroy(ground);
 *
 * Contract
 *
 * - x counts rows and y columns, from 0; lengths are in cells. Rules are `certified` or `band`:
 *   README.md of the terrain library says what each proves and assumes.
 * - One thread at a time for one tcert_terrain; different ones are independent; nothing global.
 * - A plan takes memory and 5 to 35 ms at 240,000 cells, 0.6 s where a bound of L changes: it is
 *   no call for a real-time tick.
 * - A measurement that cannot be is refused with TCERT_TERRAIN_ERROR_INPUT, says why, and changes
 *   nothing. No exception leaves a function.
 * - A struct begins with its size where the caller was compiled; members are only appended. A
 *   larger one, of a newer caller, is refused.
 */
/* clang-format on */
#ifndef TCERT_TERRAIN_C_H
#define TCERT_TERRAIN_C_H

#include <stddef.h>
#include <stdint.h>

#define TCERT_TERRAIN_ABI_VERSION 1

#if defined(__GNUC__)
#define TCERT_TERRAIN_API __attribute__((visibility("default")))
#else
#define TCERT_TERRAIN_API
#endif

#ifdef __cplusplus
extern "C" {
#define TCERT_TERRAIN_NOEXCEPT noexcept
#else
#define TCERT_TERRAIN_NOEXCEPT
#endif

typedef enum tcert_terrain_status {
  TCERT_TERRAIN_OK = 0,
  TCERT_TERRAIN_ERROR_ARGUMENT = 1, /**< A null pointer where there must be none. */
  TCERT_TERRAIN_ERROR_VERSION = 2,  /**< A struct of a newer header than the library. */
  TCERT_TERRAIN_ERROR_INPUT = 3,    /**< A setup or measurement that cannot be. */
  TCERT_TERRAIN_ERROR_MEMORY = 4,
  TCERT_TERRAIN_ERROR_INTERNAL = 5
} tcert_terrain_status;

enum tcert_terrain_rules { TCERT_TERRAIN_CERTIFIED = 0, TCERT_TERRAIN_BAND = 1 };
enum tcert_terrain_selection {
  TCERT_TERRAIN_BY_RULES = -1, /**< horizon under certified, pareto under band. */
  TCERT_TERRAIN_THESIS = 0,
  TCERT_TERRAIN_LOOK_AHEAD = 1,
  TCERT_TERRAIN_HORIZON = 2,
  TCERT_TERRAIN_PARETO = 3
};
enum tcert_terrain_end {
  TCERT_TERRAIN_GOES_ON = 0,
  TCERT_TERRAIN_REACHED = 1,   /**< The goal is certified and joined: the way leads there. */
  TCERT_TERRAIN_EXPLORED = 2,  /**< No goal, and no cell can make the ground grow. */
  TCERT_TERRAIN_EXHAUSTED = 3, /**< A goal, and no cell within reach can make the ground grow. */
  TCERT_TERRAIN_STRANDED = 4,  /**< The robot does not stand on certified ground. */
  TCERT_TERRAIN_LIMIT = 5      /**< max_steps measurements were taken; no more are. */
};

/** One value a cell, row by row. */
enum tcert_terrain_layer_kind {
  TCERT_TERRAIN_SAFE = 0,       /**< 1 on S_t, 0 elsewhere. */
  TCERT_TERRAIN_STANDING = 1,   /**< 1 where the body stands on it. */
  TCERT_TERRAIN_LOWER = 2,      /**< l_t; NaN where nothing is known, as in all that follow. */
  TCERT_TERRAIN_UPPER = 3,      /**< u_t. */
  TCERT_TERRAIN_MEAN = 4,       /**< Of the model. */
  TCERT_TERRAIN_SD = 5,         /**< Of the model. */
  TCERT_TERRAIN_CERTIFICATE = 6 /**< Of the start and the cell. */
};

typedef struct tcert_terrain_setup {
  size_t struct_size;
  int32_t rows;
  int32_t columns;
  int32_t rules;     /**< tcert_terrain_rules; certified. */
  int32_t selection; /**< tcert_terrain_selection; by rules. */
  int32_t start_x;   /**< Where the robot stands at the first plan. */
  int32_t start_y;
  int32_t has_goal; /**< 0: explore. */
  int32_t goal_x;
  int32_t goal_y;
  int32_t max_steps; /**< Measurements after the first plan. 2000. */
  double threshold;  /**< Ground is safe at values of at least this. */
  /** Per cell; 0, or contradicted by the first measurements: bounded from them (certified). */
  double lipschitz;
  double length_scale; /**< Cells; band: no longer than the terrain's. 30. */
  double confidence;   /**< Of all bounds of a run. 0.95. */
  /** Largest error of a measurement (certified). 0: none, or with noise_sd what all measurements of
   *  the run keep at `confidence`. */
  double noise_bound;
  double noise_sd;          /**< Of a measurement's Gaussian error, not overstated. 0. */
  double prior_gradient_sd; /**< Of earlier ground, with prior_places. 0: none. */
  double prior_places;
  double body_radius; /**< Of a disc; 0: a point, or the box. */
  double body_length; /**< Of a box, with its width; both 0: none. */
  double body_width;
  double body_yaw_rad; /**< From +x towards +y; the robot keeps it. */
} tcert_terrain_setup;

typedef struct tcert_terrain_decision {
  size_t struct_size;
  int32_t step;
  int32_t end;    /**< tcert_terrain_end. */
  int32_t next_x; /**< Where to measure next, or the goal reached; else -1. */
  int32_t next_y;
  uint64_t safe_cells;
  uint64_t way_points; /**< Of tcert_terrain_way. */
  double certificate;  /**< Of the start and the goal; NaN until they are joined. */
  double lipschitz;    /**< In use (certified). */
  double travelled;    /**< Cells, the way included once the goal is reached. */
} tcert_terrain_decision;

typedef struct tcert_terrain tcert_terrain;

TCERT_TERRAIN_API int32_t tcert_terrain_abi_version(void) TCERT_TERRAIN_NOEXCEPT;

/** Fills in the defaults. The macro passes the size where the caller is compiled. */
TCERT_TERRAIN_API tcert_terrain_status tcert_terrain_setup_init_sized(
    tcert_terrain_setup* setup, size_t struct_size) TCERT_TERRAIN_NOEXCEPT;
#define tcert_terrain_setup_init(setup) \
  tcert_terrain_setup_init_sized((setup), sizeof(tcert_terrain_setup))

/**
 * \param blocked rows x columns bytes, not 0 where nobody is to go; or null. Copied.
 * \param why if not null, takes a message of at most why_size bytes on an error, ended by 0.
 */
TCERT_TERRAIN_API tcert_terrain_status tcert_terrain_create(const tcert_terrain_setup* setup,
                                                            const uint8_t* blocked,
                                                            tcert_terrain** terrain,
                                                            char* why,
                                                            size_t why_size) TCERT_TERRAIN_NOEXCEPT;

TCERT_TERRAIN_API void tcert_terrain_destroy(tcert_terrain* terrain) TCERT_TERRAIN_NOEXCEPT;

/** A measurement beside the way; before the first plan: of the cells round the start. */
TCERT_TERRAIN_API tcert_terrain_status tcert_terrain_take(tcert_terrain* terrain,
                                                          int32_t x,
                                                          int32_t y,
                                                          double value,
                                                          char* why,
                                                          size_t why_size) TCERT_TERRAIN_NOEXCEPT;

/** The robot stands at (x, y) and measured it: safe ground at the first plan. One that is refused may
 * be asked for again, when more was measured round the start. */
TCERT_TERRAIN_API tcert_terrain_status tcert_terrain_plan(tcert_terrain* terrain,
                                                          int32_t x,
                                                          int32_t y,
                                                          double value,
                                                          tcert_terrain_decision* decision,
                                                          char* why,
                                                          size_t why_size) TCERT_TERRAIN_NOEXCEPT;

/**
 * The certified way of the last plan, from the first point after where the robot stands.
 * \param xy takes x, y of the first `capacity` points.
 * \return how many points there are.
 */
TCERT_TERRAIN_API size_t tcert_terrain_way(const tcert_terrain* terrain,
                                           double* xy,
                                           size_t capacity) TCERT_TERRAIN_NOEXCEPT;

/** \param values takes rows x columns values. \pre there was a plan */
TCERT_TERRAIN_API tcert_terrain_status tcert_terrain_layer(const tcert_terrain* terrain,
                                                           int32_t kind,
                                                           double* values) TCERT_TERRAIN_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
