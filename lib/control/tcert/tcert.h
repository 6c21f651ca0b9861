/**
 * \file
 * The certificate for C, and for every language that calls C: plain structs, no exceptions.
 *
 *     tcert_parameters parameters;
 *     tcert_parameters_init(&parameters);
 *     tcert_certifier* certifier = NULL;
 *     if (tcert_create(&robot, &course, &parameters, &certifier, why, sizeof why) != TCERT_OK) ...
 *     for (;;) {
 *       tcert_output now = {.struct_size = sizeof now};
 *       tcert_update(certifier, &tick, &now);
 *       drive(now.speed_mps);
 *     }
 *     tcert_destroy(certifier);
 *
 * Contract
 *
 * - Threads. Functions of one certifier are called by one thread at a time; different certifiers
 *   are independent. Nothing global is kept.
 * - Lifetime. tcert_create copies all that it is given and takes all memory. tcert_update and
 *   tcert_reset allocate nothing, take no lock, make no system call, read no clock and never fail
 *   on what a sensor says. Readings are only looked at during the call.
 * - Capacity is fixed by max_nodes, max_edges, max_memory_cells and (swept)
 *   max_swept_cells. When nodes, edges or swept cells are used
 *   up, new evidence is ignored and TCERT_CAPACITY_EXCEEDED stays set: the certificate is then
 *   never above that of a run with more. When contact memory that still counts had to give way,
 *   TCERT_MEMORY_EVICTED stays set: the corridor value and the speed may then be too high by at
 *   most memory_weight_m; the certificate does not depend on it.
 * - Units. Metres, radians (counter-clockwise), newtons, seconds; times in ns on one monotonic
 *   clock. NaN means not known; -infinity in a value means that there is no path yet.
 * - Refused input is flagged in the output, never credited. A pose that is not finite or holds a
 *   number beyond 1e9 (m, rad), a time that does not increase, a wrong number of readings:
 * TCERT_BAD_INPUT, the tick is skipped and the speed is 0. A stale tick: TCERT_STALE, likewise. A
 * reading that is NaN or infinite: TCERT_MISSING_RAY, and its side counts as no wider than the
 * body.
 * - Versions. A struct that may grow begins with struct_size, its size where the caller was
 *   compiled. Members are only appended: the smaller struct of an older caller is accepted, and
 *   what it does not have takes its default, or is not written. A larger one, of a caller newer
 *   than the library, is refused by its name with TCERT_ERROR_VERSION. Structs without struct_size
 *   never change. The name of the shared library carries TCERT_ABI_VERSION, which changes only
 *   when this rule is broken.
 */
#ifndef TCERT_TCERT_H
#define TCERT_TCERT_H

#include <stddef.h>
#include <stdint.h>

#define TCERT_ABI_VERSION 1

#if defined(__GNUC__)
#define TCERT_API __attribute__((visibility("default")))
#else
#define TCERT_API
#endif

#ifdef __cplusplus
extern "C" {
#define TCERT_NOEXCEPT noexcept
#else
#define TCERT_NOEXCEPT
#endif

typedef enum tcert_status {
  TCERT_OK = 0,
  TCERT_ERROR_ARGUMENT = 1, /**< A null pointer where there must be none. */
  TCERT_ERROR_VERSION = 2,  /**< A struct of a newer header than the library. */
  TCERT_ERROR_PARAMETER =
      3,                  /**< Robot, course or parameters out of range; the message says which. */
  TCERT_ERROR_MEMORY = 4, /**< Not enough memory. */
  TCERT_ERROR_INTERNAL = 5
} tcert_status;

enum tcert_ray_kind { TCERT_BEND = 0, TCERT_RANGE = 1 };
enum tcert_region_kind { TCERT_NONE = 0, TCERT_DISC = 1, TCERT_POLYGON = 2 };
enum tcert_clearance {
  TCERT_CLEARANCE_WIDTH = 0,
  TCERT_CLEARANCE_RADIAL = 1,
  TCERT_CLEARANCE_SWEPT = 2,
  TCERT_CLEARANCE_WITNESS = 3 /**< Refused: a witness is found after the run. */
};
enum tcert_curvature {
  TCERT_CURVATURE_PATH = 0,
  TCERT_CURVATURE_CONTACT = 1,
  TCERT_CURVATURE_CONTACT_LITERAL = 2,
  TCERT_CURVATURE_NONE = 3
};
enum tcert_footing { TCERT_FOOTING_FELT = 0, TCERT_FOOTING_IGNORED = 1 };
enum tcert_unknown { TCERT_UNKNOWN_OCCUPIED = 0, TCERT_UNKNOWN_FREE = 1 };
enum tcert_speed_law {
  TCERT_SQUASH = 0,
  TCERT_CLIP = 1,
  TCERT_BARRIER =
      2, /**< Filtered by what was felt; tcert_step filters a command with its yaw rate. */
  TCERT_PROFILE = 3 /**< Within what the body can brake before what is not explored. */
};
enum tcert_risk_intensity { TCERT_RISK_GAMMA = 0, TCERT_RISK_LAMBDA = 1 };
enum tcert_fallback_state {
  TCERT_FALLBACK_NORMAL = 0,
  TCERT_FALLBACK_STOP = 1,
  TCERT_FALLBACK_REVERSE = 2,
  TCERT_FALLBACK_REORIENT = 3,
  TCERT_FALLBACK_HALT = 4 /**< For good, until tcert_reset. */
};
enum tcert_guard_mode { TCERT_GUARDS_BY_LAW = 0, TCERT_GUARDS_ACT = 1, TCERT_GUARDS_WATCH = 2 };

/** Of tcert_output::flags. From TCERT_CAPACITY_EXCEEDED to TCERT_MEMORY_EVICTED they stay set until
 * tcert_reset. */
enum tcert_flag {
  TCERT_STALE = 1 << 0,
  TCERT_BAD_INPUT = 1 << 1,
  TCERT_MISSING_RAY = 1 << 2,
  TCERT_BREAK = 1 << 3, /**< The path broke here: a gap, or a step above max_step_m. */
  TCERT_CAPACITY_EXCEEDED = 1 << 4,
  TCERT_START_OUTSIDE = 1 << 5, /**< The first tick lies outside S: never a certificate. */
  TCERT_GOAL_REACHED = 1 << 6,
  TCERT_MEMORY_EVICTED = 1 << 7,
  TCERT_ACROSS_HEADING = 1 << 8 /**< Not lasting: the robot moves off its heading, and its sides
                                     count for less. */
};

/** Of tcert_output::triggers: why forward motion is refused, or would be. */
enum tcert_trigger {
  TCERT_TRIGGER_MARGIN = 1 << 0,      /**< The speed law gives 0. */
  TCERT_TRIGGER_FORCE = 1 << 1,       /**< G2: a tip force above force_limit_n. */
  TCERT_TRIGGER_REPLAN = 1 << 2,      /**< G3: robust_margin_m <= replan_margin_m. */
  TCERT_TRIGGER_NO_BOUND = 1 << 3,    /**< The tracking-error table ends below this speed. */
  TCERT_TRIGGER_NO_EVIDENCE = 1 << 4, /**< The tick is stale or bad. */
  TCERT_TRIGGER_BARRIER = 1 << 5      /**< No command keeps the barrier of what was felt. */
};

typedef struct tcert_point {
  double x_m, y_m;
} tcert_point;

/** One direction in which clearance is felt, fixed to the body: x forward, y left. */
typedef struct tcert_ray {
  const char* name; /**< For messages; may be null. */
  tcert_point mount;
  double bearing_rad;        /**< From the heading. */
  double reach_m;            /**< Longest clearance that it can state; > 0. */
  int32_t kind;              /**< tcert_ray_kind. */
  uint32_t knots;            /**< Of the calibration; bend rays need at least one. */
  const double* bend_rad;    /**< knots values, strictly increasing. */
  const double* clearance_m; /**< knots values, monotone. */
} tcert_ray;

typedef struct tcert_robot {
  uint32_t struct_size;
  uint32_t ray_count;
  const tcert_ray* rays;
  double body_width_m;      /**< > 0. */
  double min_turn_radius_m; /**< >= 0, as are the next two. */
  double tracking_buffer_m;
  double curvature_buffer_per_m;
} tcert_robot;

typedef struct tcert_region {
  int32_t kind;                /**< tcert_region_kind. */
  uint32_t vertex_count;       /**< Of a polygon; at least 3. */
  tcert_point centre;          /**< Of a disc. */
  double radius_m;             /**< Of a disc; > 0. */
  const tcert_point* vertices; /**< Of a polygon; closed implicitly. */
} tcert_region;

/** Without a start, S is the disc of half the body width round the first node; without a goal there
 * is no certificate, only the corridor value. */
typedef struct tcert_course {
  uint32_t struct_size;
  uint32_t reserved; /**< 0. */
  tcert_region start;
  tcert_region goal;
} tcert_course;

/** Every parameter of certificate, speed law, guards, risk field and fallback;
 * tcert_parameters_init sets the defaults. What each means and when to change it: `tcert help
 * parameters`, which has the same names, and tcert/parameters.hpp, speed_law.hpp, guards.hpp. */
typedef struct tcert_parameters {
  uint32_t struct_size;

  int32_t clearance; /**< tcert_clearance. */
  int32_t curvature; /**< tcert_curvature. */
  int32_t unknown;   /**< tcert_unknown. */
  double side_angle_rad;
  double side_window_m;
  double travel_deadband_m;
  double swept_cell_m;
  double least_obstacle_m;
  double sharpest_corner_rad;
  double swept_lag_m;
  double curvature_window_m;
  double curvature_min_travel_m;
  double min_curvature_per_m;
  double contact_spacing_m;
  double contact_literal_spacing_m;
  double contact_window_m;
  double contact_flatness;
  double sigma_contact_m;
  double contact_on_n;
  double contact_off_n;
  double contact_slack_m;
  double edge_length_m;
  double merge_radius_m;
  double merge_angle_rad;
  double reversal_m;
  double max_step_m;
  double memory_weight_m;
  double memory_cell_m;
  double memory_gain;
  double force_cap_n;
  double memory_sigma_m;
  double memory_half_life_s;
  uint32_t max_nodes;
  uint32_t max_edges;
  uint32_t max_memory_cells;
  uint32_t max_swept_cells;
  uint32_t reserved_1; /**< 0. */

  int32_t speed_law; /**< tcert_speed_law. */
  double min_speed_mps;
  double max_speed_mps;
  double beta_per_m;

  int32_t guard_mode; /**< tcert_guard_mode. */
  uint32_t reserved;  /**< 0. */
  double replan_margin_m;
  double guard_min_force_n;
  double guard_force_per_m;
  double guard_disturbance;

  /** The tracking-error table: radii on a full grid, row-major, the disturbance running fastest.
   * Null radii stand for the declared table. */
  uint32_t tracking_speeds;
  uint32_t tracking_accelerations;
  uint32_t tracking_disturbances;
  uint32_t reserved_2; /**< 0. */
  const double* tracking_speed_mps;
  const double* tracking_acceleration_mps2;
  const double* tracking_disturbance;
  const double* tracking_radius_m;

  double accel_mps2;
  double brake_mps2;
  double law_yaw_rate_rps;
  double barrier_gain_per_s;
  double barrier_point_m;

  /** The second axis of the table in the place of the acceleration, then tracking_accelerations of
   * them: the speed just left, and for how long it counts. Null: it is the acceleration. */
  const double* tracking_speed_left_mps;
  const double* tracking_hold_s;

  /** 1: keep a risk field, and state risk_ahead. */
  int32_t keep_risk;
  int32_t risk_intensity; /**< tcert_risk_intensity. */
  double risk_cell_m;
  double risk_error_m2;
  double risk_prior_per_m2;
  double risk_prior_weight;
  double risk_hit_rate;
  double risk_miss_rate;
  double risk_half_life_s;
  double risk_ahead_m;
  uint32_t max_risk_cells;

  uint32_t fallback_halt_after;
  double fallback_stop_s;
  double fallback_reverse_m;
  double fallback_reverse_mps;
  double fallback_reorient_rad;
  double fallback_turn_rate_rps;
  double fallback_within_s;
  /** Rules that are monitored, one a line, `name: formula`, or `watch name: formula` of one that
   * is stated alone and backs nothing out; 32 at most: see `tcert help rules`. Null: none. */
  const char* rules;

  /** Moving obstacles: their top speed, and how old a reading may be. */
  double obstacle_speed_mps;
  double reading_age_s;
  int32_t footing;     /**< tcert_footing. */
  uint32_t reserved_3; /**< 0. */
  double friction;
  double track_width_m;
  double centre_height_m;
  double largest_step_m;
  double largest_slip;
  double footing_scale_m;
} tcert_parameters;

/** Reading of one ray. */
typedef struct tcert_reading {
  double value;   /**< Bend in rad or range in m, by the ray's kind; NaN is missing. A range of
                       nothing within reach, inf of a laser, is to be given as the reach. */
  double force_n; /**< NaN if the ray has no force sensor. */
} tcert_reading;

typedef struct tcert_tick {
  uint32_t struct_size;
  uint32_t reading_count; /**< One per ray of the robot, in its order. */
  const tcert_reading* readings;
  int64_t time_ns; /**< Strictly increasing. */
  double x_m, y_m, yaw_rad;
  int32_t stale;              /**< 1: a required stream is silent, no evidence. */
  int32_t segment_start;      /**< 1: there is a gap before this tick. */
  const double* bearings_rad; /**< Of rays that a joint moves: where each reading was felt, from the
                                   heading, NaN along the ray's own; null if there is no joint. */
  /** What is underfoot, NaN where it is not measured; of an older caller it is not. */
  double pitch_rad, roll_rad;
  double step_m; /**< Height of a step up or down. */
  double slip;   /**< Share of the commanded way that the robot did not move. */
} tcert_tick;

/** What is known after a tick: see CertifiedTick and GuardedTick of the C++ headers. */
typedef struct tcert_output {
  uint32_t struct_size; /**< Set by the caller. */
  uint32_t flags;       /**< tcert_flag, or'ed. */
  int64_t time_ns;
  double travel_m;
  double left_m, right_m; /**< Free width to either side, trailing minimum. */
  double width_m;
  double turn_radius_m;
  double margin_m; /**< m_t. */
  double edge_margin_m;
  double memory;           /**< M_t at the robot, in [0, 1]. */
  double corridor_value_m; /**< V_t. */
  double certificate_m;    /**< T_t. */
  double series_m;         /**< T_t once there is one, V_t before. */
  uint32_t contacts;
  uint32_t new_contacts;
  uint32_t nodes;
  uint32_t edges;
  uint32_t labels_raised;  /**< Work done in the graph at this tick. */
  uint32_t issued;         /**< 1: T_t > 0 now or earlier. */
  double tracking_error_m; /**< r_TE at the speed granted. */
  double robust_margin_m;  /**< V_t less r_TE, twice r_TE where clearance is a width. */
  double force_n;          /**< Largest tip force; NaN if no ray states one. */
  double force_limit_n;
  double speed_mps; /**< Gated and guarded, forward; 0 is halt. */
  double retreat_speed_mps;
  uint32_t triggers;       /**< tcert_trigger, or'ed. */
  uint32_t triggers_began; /**< Those that the tick before did not have. */
  double yaw_rate_rps;     /**< As commanded, but for what the barrier law changes. */
  double risk_ahead; /**< Chance of a collision over risk_ahead_m straight ahead; NaN without a
                          risk field. */
  uint32_t alarms;   /**< 1 << rule, or'ed. */
  uint32_t alarms_began;
  double footing_slack_m; /**< Least margin of slope, step and slip; NaN if none is measured. */
  double valid_for_s;     /**< Where obstacles move: for how long T_t stays above 0; else NaN. */
} tcert_output;

/** What a differential drive takes. */
typedef struct tcert_command {
  double speed_mps;    /**< Along the heading; negative in reverse. */
  double yaw_rate_rps; /**< Counter-clockwise. */
} tcert_command;

/** The edge that decides the certificate. */
typedef struct tcert_bottleneck {
  uint32_t struct_size;
  uint32_t edge;
  double x_m, y_m, yaw_rad;
  double margin_m, width_m, turn_radius_m;
} tcert_bottleneck;

typedef struct tcert_certifier tcert_certifier;

/** TCERT_ABI_VERSION of the library that is loaded. */
TCERT_API uint32_t tcert_abi_version(void) TCERT_NOEXCEPT;
/** "0.1.0". Never null; static. */
TCERT_API const char* tcert_version(void) TCERT_NOEXCEPT;
/** One line for people. Never null; static. */
TCERT_API const char* tcert_status_text(tcert_status status) TCERT_NOEXCEPT;
/** The word of one flag, as in the series; "" for none that is known. Static. */
TCERT_API const char* tcert_flag_text(uint32_t flag) TCERT_NOEXCEPT;

/** Sets every parameter to its default. The macro passes the size where the caller is compiled. */
TCERT_API tcert_status tcert_parameters_init_sized(tcert_parameters* parameters,
                                                   uint32_t struct_size) TCERT_NOEXCEPT;
#define tcert_parameters_init(parameters) \
  tcert_parameters_init_sized((parameters), (uint32_t)sizeof(tcert_parameters))

/** Makes a certifier. On an error *certifier is null and, unless `message` is null, the reason is
 * written there, cut to message_size bytes with its end. */
TCERT_API tcert_status tcert_create(const tcert_robot* robot,
                                    const tcert_course* course,
                                    const tcert_parameters* parameters,
                                    tcert_certifier** certifier,
                                    char* message,
                                    size_t message_size) TCERT_NOEXCEPT;

/** Takes the next tick. Never an error for what the tick says, see the contract. */
TCERT_API tcert_status tcert_update(tcert_certifier* certifier,
                                    const tcert_tick* tick,
                                    tcert_output* output) TCERT_NOEXCEPT;

/** What to command in the place of `wanted` for the next `seconds`, at a tick or between two, with
 * the body at the pose: the barrier law's filter, and the fallback (stop, reverse, re-orient, halt)
 * of an alarm of the last tick. `state`, unless null, is a tcert_fallback_state. What it returns is
 * taken for what the robot is told to drive until the next call: rules and the barrier law go by it
 * at the next tick. Without it they know of no command. A number that is not finite, or beyond
 * 1e9, and seconds below 0 are TCERT_ERROR_ARGUMENT. Only tcert_reset ends TCERT_FALLBACK_HALT. */
TCERT_API tcert_status tcert_step(tcert_certifier* certifier,
                                  const tcert_command* wanted,
                                  double x_m,
                                  double y_m,
                                  double yaw_rad,
                                  double seconds,
                                  tcert_command* command,
                                  int32_t* state) TCERT_NOEXCEPT;

/** The name of a rule, by its bit's place; "" beyond the last. Lives as long as the certifier. */
TCERT_API const char* tcert_rule_name(const tcert_certifier* certifier,
                                      uint32_t rule) TCERT_NOEXCEPT;

/** m_t of heading along each ray at the last fresh tick; writes `count` values, NaN beyond the
 * robot's rays. */
TCERT_API tcert_status tcert_ray_margins(const tcert_certifier* certifier,
                                         double* margins_m,
                                         uint32_t count) TCERT_NOEXCEPT;

/** *found is 1 if S and G are connected, else 0 and the bottleneck is left as it is.
 * O(length of the path). */
TCERT_API tcert_status tcert_find_bottleneck(const tcert_certifier* certifier,
                                             tcert_bottleneck* bottleneck,
                                             int32_t* found) TCERT_NOEXCEPT;

/** Forgets the trial, keeps the memory. O(capacity). */
TCERT_API tcert_status tcert_reset(tcert_certifier* certifier) TCERT_NOEXCEPT;

/** Null is allowed. */
TCERT_API void tcert_destroy(tcert_certifier* certifier) TCERT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
