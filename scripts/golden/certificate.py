#!/usr/bin/env python3
"""Series of random runs by scripts/reference_certificate.py, for tests/lib/certificate_golden_test.cpp.

The runs are those of tests/support/random_run.cpp, drawn again here; every 25th fresh tick is kept, and
every 15th at which the graph or the certificate changes. Usage: certificate.py > tests/golden/certificate.json"""
import json
import math
import random
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from reference_certificate import COLUMNS, Reference  # noqa: E402

TICKS = 1500
CASES = [{}, {"clearance": "radial"}, {"curvature": "none"}, {"curvature": "contact"}, {"curvature": "contact_literal"},
         {"min_turn_radius_m": 0.0}, {"tracking_buffer_m": 0.04, "curvature_buffer_per_m": 0.3},
         {"edge_length_m": 0.1, "merge_radius_m": 0.3, "merge_angle_rad": 0.6}, {"body_width_m": 0.7, "side_window_m": 0.2},
         {"reversal_m": 0.02, "max_step_m": 0.1}, {"memory_weight_m": 0.5, "memory_half_life_s": 3.0, "memory_cell_m": 0.07},
         {"travel_deadband_m": 0.03, "curvature_window_m": 0.5, "curvature_min_travel_m": 0.2},
         {"contact_on_n": 0.9, "contact_off_n": 0.7, "force_cap_n": 0.9, "memory_sigma_m": 0.08}]


class Mt19937:
    """std::mt19937: the generator of `random` seeded as the standard library of C++ does."""

    def __init__(self, seed):
        state = [seed]
        for i in range(1, 624):
            state.append((1812433253 * (state[-1] ^ (state[-1] >> 30)) + i) & 0xFFFFFFFF)
        self.random = random.Random()
        self.random.setstate((3, (*state, 624), None))

    def bits(self):
        return self.random.getrandbits(32)

    def uniform(self, low, high):
        return low + (high - low) * self.bits() / 4294967296.0

    def one_in(self, n):
        return self.bits() % n == 0


def ray(name, y, bearing, x=0.0):
    return {"name": name, "mount_x_m": x, "mount_y_m": y, "bearing_rad": bearing, "reach_m": 0.8, "kind": "range"}


RAYS = [ray("left", 0.1, math.pi / 2), ray("right", -0.1, -math.pi / 2), ray("ahead", 0.0, 0.0, 0.2)]
COURSE = {k: {"disc": {"x_m": x, "y_m": 0.0, "radius_m": 0.4}} for k, x in (("start", 0.0), ("goal", 1.3))}


def random_run(seed):
    draw = Mt19937(seed)
    x = y = yaw = 0.0
    gear = 1.0
    turn_per_m = draw.uniform(-2.5, 2.5)
    time_ns = draw.bits() % 1000 * 1_000_000
    for _ in range(TICKS):
        turn_per_m = draw.uniform(-2.5, 2.5) if draw.one_in(40) else turn_per_m
        gear = -gear if draw.one_in(60) else gear
        step = 0.0 if draw.one_in(6) else gear * draw.uniform(0.0, 0.06)
        yaw += step * turn_per_m + draw.uniform(-0.002, 0.002)
        x, y = x + step * math.cos(yaw), y + step * math.sin(yaw)
        if draw.one_in(300):
            x, y, yaw = draw.uniform(-1.0, 3.0), draw.uniform(-1.0, 1.0), draw.uniform(-3.0, 3.0)
        time_ns += 100_000_000
        pose = (x + draw.uniform(-0.001, 0.001), y + draw.uniform(-0.001, 0.001), yaw)
        tick = {"time_ns": time_ns, "pose": pose, "stale": draw.one_in(50), "segment_start": draw.one_in(400), "rays": []}
        for _ in RAYS:
            value = math.nan if draw.one_in(100) else 0.05 * (draw.bits() % 18)
            force = math.nan if draw.one_in(3) else 0.2 * (draw.bits() % 6)
            tick["rays"].append((value, force))
        yield tick


def rows(changes, seed):
    reference = Reference({"body_width_m": 0.45, "min_turn_radius_m": 0.35}, RAYS, COURSE, changes)
    last, changed = None, 0
    for k, tick in enumerate(random_run(seed)):
        row = reference.update(tick)
        if row is None:
            continue
        now = (row["certificate_m"], row["edges"])
        changed += now != last
        if k % 25 == 0 or (now != last and changed % 15 == 0):
            yield [k] + [None if math.isinf(row[c]) else float(f"{row[c]:.11g}") for c in COLUMNS]
        last = now


print(json.dumps({"columns": ["tick", *COLUMNS], "cases": [
    {"parameters": changes, "seed": 100 + i, "rows": list(rows(changes, 100 + i))} for i, changes in enumerate(CASES)]}, separators=(",", ":")).replace("{\"parameters", "\n{\"parameters"))
