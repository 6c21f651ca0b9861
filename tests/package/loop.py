"""The control loop of loop.c in Python, by ctypes. Argument: the shared library."""

import ctypes
import math
import sys
from ctypes import c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_void_p

DISC, RANGE, CLIP, GOAL_REACHED = 1, 1, 1, 1 << 6


def struct(name, *fields):
    return type(name, (ctypes.Structure,), {"_fields_": list(fields)})


def doubles(names):
    return [(name, c_double) for name in names.split()]


Point = struct("Point", *doubles("x_m y_m"))
Ray = struct("Ray", ("name", c_char_p), ("mount", Point), *doubles("bearing_rad reach_m"),
             ("kind", c_int32), ("knots", c_uint32), ("bend_rad", c_void_p), ("clearance_m", c_void_p))
Robot = struct("Robot", ("struct_size", c_uint32), ("ray_count", c_uint32), ("rays", c_void_p),
               *doubles("body_width_m min_turn_radius_m tracking_buffer_m curvature_buffer_per_m"))
Region = struct("Region", ("kind", c_int32), ("vertex_count", c_uint32), ("centre", Point),
                ("radius_m", c_double), ("vertices", c_void_p))
Course = struct("Course", ("struct_size", c_uint32), ("reserved", c_uint32), ("start", Region),
                ("goal", Region))
Parameters = struct(
    "Parameters", ("struct_size", c_uint32),
    *[(name, c_int32) for name in "clearance curvature unknown".split()],
    *doubles("side_angle_rad side_window_m travel_deadband_m swept_cell_m "
             "least_obstacle_m sharpest_corner_rad swept_lag_m curvature_window_m "
             "curvature_min_travel_m min_curvature_per_m contact_spacing_m "
             "contact_literal_spacing_m contact_window_m contact_flatness sigma_contact_m "
             "contact_on_n contact_off_n contact_slack_m edge_length_m merge_radius_m "
             "merge_angle_rad reversal_m max_step_m memory_weight_m memory_cell_m memory_gain "
             "force_cap_n memory_sigma_m memory_half_life_s"),
    ("max_nodes", c_uint32), ("max_edges", c_uint32), ("max_memory_cells", c_uint32),
    ("max_swept_cells", c_uint32), ("reserved_1", c_uint32),
    ("speed_law", c_int32), *doubles("min_speed_mps max_speed_mps beta_per_m"),
    ("guard_mode", c_int32), ("reserved", c_uint32),
    *doubles("replan_margin_m guard_min_force_n guard_force_per_m guard_disturbance"),
    ("tracking_speeds", c_uint32), ("tracking_accelerations", c_uint32),
    ("tracking_disturbances", c_uint32), ("reserved_2", c_uint32),
    ("tracking_speed_mps", c_void_p), ("tracking_acceleration_mps2", c_void_p),
    ("tracking_disturbance", c_void_p), ("tracking_radius_m", c_void_p))
Reading = struct("Reading", *doubles("value force_n"))
Tick = struct("Tick", ("struct_size", c_uint32), ("reading_count", c_uint32), ("readings", c_void_p),
              ("time_ns", c_int64), *doubles("x_m y_m yaw_rad"), ("stale", c_int32),
              ("segment_start", c_int32))
Output = struct(
    "Output", ("struct_size", c_uint32), ("flags", c_uint32), ("time_ns", c_int64),
    *doubles("travel_m left_m right_m width_m turn_radius_m margin_m edge_margin_m memory "
             "corridor_value_m certificate_m series_m"),
    *[(name, c_uint32) for name in
      "contacts new_contacts nodes edges labels_raised issued".split()],
    *doubles("tracking_error_m robust_margin_m force_n force_limit_n speed_mps retreat_speed_mps"),
    ("triggers", c_uint32), ("triggers_began", c_uint32))


def half_width_m(x_m):
    return 0.30 if 2.5 < x_m < 3.0 else 0.45


def main():
    tcert = ctypes.CDLL(sys.argv[1])
    tcert.tcert_flag_text.restype = tcert.tcert_version.restype = c_char_p
    tcert.tcert_create.argtypes = [c_void_p] * 5 + [c_size_t]
    tcert.tcert_update.argtypes = [c_void_p] * 3
    tcert.tcert_destroy.argtypes = [c_void_p]

    square = 1.5707963267948966
    rays = (Ray * 2)(Ray(b"left", Point(0.2, 0.1), square, 0.7, RANGE, 0, None, None),
                     Ray(b"right", Point(0.2, -0.1), -square, 0.7, RANGE, 0, None, None))
    robot = Robot(ctypes.sizeof(Robot), 2, ctypes.addressof(rays), 0.45, 0.35, 0.0, 0.0)
    course = Course(ctypes.sizeof(Course), 0, Region(DISC, 0, Point(0.0, 0.0), 0.5, None),
                    Region(DISC, 0, Point(5.0, 0.0), 0.5, None))
    parameters = Parameters()
    status = tcert.tcert_parameters_init_sized(ctypes.byref(parameters), ctypes.sizeof(parameters))
    assert status == 0, "these structs are not those of the library"
    parameters.speed_law = CLIP
    certifier, why = c_void_p(), ctypes.create_string_buffer(200)
    status = tcert.tcert_create(ctypes.byref(robot), ctypes.byref(course), ctypes.byref(parameters),
                                ctypes.byref(certifier), why, len(why))
    if status != 0:
        sys.exit(why.value.decode())
    now, x_m = Output(ctypes.sizeof(Output)), 0.0
    for k in range(1000):
        side_m = half_width_m(x_m + 0.2) - 0.1
        readings = (Reading * 2)(Reading(math.nan if k == 40 else side_m, 0.0), Reading(side_m, 0.0))
        tick = Tick(ctypes.sizeof(Tick), 2, ctypes.addressof(readings), k * 100_000_000, x_m, 0.0,
                    0.0, 0, 0)
        assert tcert.tcert_update(certifier, ctypes.byref(tick), ctypes.byref(now)) == 0
        if k % 20 == 0:
            print("%5.1f s  x %.9f  m %.9f  V %.9f  v %.9f  %s" %
                  (1e-9 * now.time_ns, x_m, now.margin_m, now.corridor_value_m, now.speed_mps,
                   tcert.tcert_flag_text(now.flags).decode()))
        x_m += now.speed_mps * 0.1
        if now.flags & GOAL_REACHED:
            break
    print("certificate %.17g, issued %d" % (now.certificate_m, now.issued))
    tcert.tcert_destroy(certifier)
    return 0 if now.issued else 1


sys.exit(main())
