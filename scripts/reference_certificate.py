#!/usr/bin/env python3
"""The certificate by code of its own, from lib/README.md: slow, with nothing kept that can be computed again.

Windows are lists of all ticks, the graph is searched from scratch at every tick, contact memory is a
table of cells. Readings `width` and `radial`, every curvature reading, unknown space occupied, any capacity
that is not used up. As a program it holds the series of 'tcert certify' against its own:

    reference_certificate.py BUNDLE RESULTS [KEY=VALUE ...]

BUNDLE has bundle.json; RESULTS was made from it by 'certify --ticks', with the parameters that are named.
A line a trial with the largest difference; exit code 1 if one is above 1e-7."""
import bisect
import csv
import json
import math
import sys
from pathlib import Path

INF, NAN = math.inf, math.nan
BACK, FRONT = 0, 1
DEFAULTS = {
    "clearance": "width", "curvature": "path", "side_angle_rad": math.pi / 6, "side_window_m": 0.0, "travel_deadband_m": 0.01,
    "curvature_window_m": 0.25, "curvature_min_travel_m": 0.10, "min_curvature_per_m": 1e-3, "contact_spacing_m": 0.15,
    "contact_literal_spacing_m": 0.02, "contact_window_m": 1.0, "contact_flatness": 0.02, "sigma_contact_m": 0.003,
    "contact_on_n": 0.5, "contact_off_n": 0.3, "contact_slack_m": 0.01, "edge_length_m": 0.25, "merge_radius_m": 0.15,
    "merge_angle_rad": math.pi / 9, "reversal_m": 0.05, "max_step_m": 0.25, "memory_weight_m": 0.05, "memory_cell_m": 0.1,
    "memory_gain": 0.1, "force_cap_n": 5.0, "memory_sigma_m": 0.15, "memory_half_life_s": 20.0}
COLUMNS = ("travel_m", "left_m", "right_m", "width_m", "turn_radius_m", "margin_m", "edge_margin_m", "memory",
           "corridor_value_m", "certificate_m", "contacts", "new_contacts", "nodes", "edges")

dot = lambda a, b: a[0] * b[0] + a[1] * b[1]
sub = lambda a, b: (a[0] - b[0], a[1] - b[1])
unit = lambda yaw: (math.cos(yaw), math.sin(yaw))
turn = lambda a, b: math.remainder(b - a, 2 * math.pi)
exceeds = lambda length, limit: length > limit * (1 + 1e-9)
reaches = lambda length, limit: length >= limit * (1 - 1e-9)


def place(pose, local):
    """A point of the body's frame in that of the log."""
    c, s = unit(pose[2])
    return (pose[0] + c * local[0] - s * local[1], pose[1] + s * local[0] + c * local[1])


def inside(region, p):
    if region is None:
        return False
    if "disc" in region:
        d = region["disc"]
        return (p[0] - d["x_m"]) ** 2 + (p[1] - d["y_m"]) ** 2 <= d["radius_m"] ** 2
    v = region["polygon"]
    crossings = [1 for a, b in zip(v, v[-1:] + v[:-1]) if (a[1] > p[1]) != (b[1] > p[1]) and
                 p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])]
    return len(crossings) % 2 == 1


def calibrated(ray, bend):
    x, y = ray["calibration"]["bend_rad"], ray["calibration"]["clearance_m"]
    i = bisect.bisect_right(x, bend)
    if i in (0, len(x)):
        return y[0] if i == 0 else y[-1]
    return y[i - 1] + (bend - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1])


class Ray:
    def __init__(self, given, side_angle_rad):
        self.given = given
        self.mount = (given.get("mount_x_m", 0.0), given.get("mount_y_m", 0.0))
        self.bearing, self.bends = given["bearing_rad"], given["kind"] == "bend"
        self.reach = given["reach_m"]
        self.longest = min(self.reach, max(given["calibration"]["clearance_m"])) if self.bends else self.reach
        within = side_angle_rad + 1e-9
        self.side = 1 if abs(turn(math.pi / 2, self.bearing)) <= within else -1 if abs(turn(-math.pi / 2, self.bearing)) <= within else 0
        self.touching = False
        self.triple = []  # the last contacts, far enough apart

    def clearance(self, value):
        if not math.isfinite(value):
            return NAN
        return min(max(calibrated(self.given, value) if self.bends else value, 0.0), self.reach)

    def across(self, clearance):
        """Lateral reach of what the ray states."""
        return (-self.mount[1] if self.side < 0 else self.mount[1]) + clearance * abs(math.sin(self.bearing))


def triple_radius(triple, p):
    """Radius of the path along three contacts (point, lateral, left of the path, travel) of a wall."""
    a, b, c = (t[0] for t in triple)
    sides = (math.dist(b, c), math.dist(a, c), math.dist(a, b))
    longest, area2 = max(sides), abs(dot(sub(b, a), (sub(c, a)[1], -sub(c, a)[0])))
    literal = p["curvature"] == "contact_literal"
    least = p["contact_flatness"] * longest
    least = least if literal else max(least, 3 * p["sigma_contact_m"])
    if area2 == 0 or area2 / longest < least:
        return INF
    radius = math.prod(sides) / (2 * area2)
    if literal:
        return radius
    d = 2 * (a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]))
    squares = [q[0] ** 2 + q[1] ** 2 for q in (a, b, c)]
    centre = (sum(squares[i] * ((a, b, c)[(i + 1) % 3][1] - (a, b, c)[(i + 2) % 3][1]) for i in range(3)) / d,
              sum(squares[i] * ((a, b, c)[(i + 2) % 3][0] - (a, b, c)[(i + 1) % 3][0]) for i in range(3)) / d)
    _, lateral, left, _ = triple[1]
    same_side = (dot(sub(centre, b), left) > 0) == (lateral > 0)
    return radius + abs(lateral) if same_side else radius - abs(lateral)


class Graph:
    """Nodes (pose, heading, in S, in G) and edges between sides of nodes, with the best margins so far."""

    def __init__(self):
        self.nodes, self.edges, self.seeds = [], {}, {}

    def record(self, a, b, felt, certified):
        key = tuple(sorted((a, b)))
        old = self.edges.get(key, (-INF, -INF))
        self.edges[key] = (max(old[0], felt), max(old[1], certified))

    def widest(self, which, sided, sources):
        """Labels by relaxing all edges until nothing rises."""
        label = dict(sources)
        rises = True
        while rises:
            rises = False
            for (a, b), margins in self.edges.items():
                for start, end in ((a, b), (b, a)):
                    here = start if sided else start[0]
                    there = (end[0], 1 - end[1]) if sided else end[0]
                    value = min(label.get(here, -INF), margins[which])
                    if value > label.get(there, -INF):
                        label[there] = value
                        rises = True
        return label


class Reference:
    def __init__(self, robot, rays, course, changes=None):
        self.p = DEFAULTS | (changes or {})
        self.robot = {"tracking_buffer_m": 0.0, "curvature_buffer_per_m": 0.0} | robot
        self.robot |= {k: v for k, v in self.p.items() if k in self.robot}
        self.rays = [Ray(r, self.p["side_angle_rad"]) for r in rays]
        self.start, self.goal = course.get("start"), course.get("goal")
        self.half = self.robot["body_width_m"] / 2
        self.needed = self.robot["body_width_m"] + 2 * self.robot["tracking_buffer_m"]
        self.graph = Graph()
        self.began = self.gap = self.entered_goal = False
        self.last_time = self.node = None
        self.travel = 0.0
        self.memory = {}
        self.value = -INF
        self.ever_outside = False
        self.restart_windows()

    def restart_windows(self):
        self.sides, self.motion, self.yaw = [], [], None
        self.across = 0.0
        for ray in self.rays:
            ray.triple = []

    # --- proxies ---------------------------------------------------------------------------------
    def follow(self, pose, in_start):
        """(way, turn, way across the heading) over the window of curvature."""
        if self.yaw is None:
            self.unwrapped, self.stepped, self.stepped_m = 0.0, pose, self.travel
        else:
            self.unwrapped += turn(self.yaw, pose[2])
            if self.travel > self.stepped_m:
                half = turn(self.stepped[2], pose[2]) / 2
                step, mean = sub(pose, self.stepped), unit(self.stepped[2] + half)
                along, beside = abs(dot(mean, step)), abs(mean[0] * step[1] - mean[1] * step[0])
                if math.hypot(*step) > 2 * abs(half) * self.half:
                    self.across += math.hypot(*step) * math.sin(max(0.0, math.atan2(beside, along) - abs(half)))
                self.stepped, self.stepped_m = pose, self.travel
        self.yaw = pose[2]
        if in_start:
            self.motion = []
        if not self.motion or self.motion[-1][0] < self.travel:
            self.motion.append((self.travel, self.unwrapped, self.across))
        then = next(m for m in self.motion if not exceeds(self.travel - m[0], self.p["curvature_window_m"]))
        return self.travel - then[0], self.unwrapped - then[1], self.across - then[2]

    def proxies(self, tick, in_start, time_s):
        p, pose = self.p, tick["pose"]
        way, turned, across = self.follow(pose, in_start)
        along = 1.0
        if reaches(way, p["curvature_min_travel_m"]) and exceeds(across, math.sin(math.radians(10)) * way):
            along = math.sqrt(1 - min(across / way, 1.0) ** 2)
        felt = {1: INF, -1: INF}
        contacts = new_contacts = 0
        for ray, (value, force) in zip(self.rays, tick["rays"]):
            clearance = ray.clearance(value)
            if ray.side:
                stated = self.half if math.isnan(clearance) else ray.across(clearance)
                counts = along * stated if reaches(along, math.cos(math.radians(30))) else min(stated, self.half)
                felt[ray.side] = min(felt[ray.side], counts)
            if math.isnan(force):
                touches = clearance < ray.longest - p["contact_slack_m"]
            else:
                touches = force >= p["contact_off_n" if ray.touching else "contact_on_n"]
            contacts += touches
            new_contacts += touches and not ray.touching
            ray.touching = touches
            if touches and not math.isnan(clearance):
                self.touch(ray, pose, clearance, force, time_s)
        sides = [self.half if math.isinf(felt[s]) else felt[s] for s in (1, -1)]
        self.sides.append((self.travel, *sides))
        window = p["side_window_m"] or self.robot["body_width_m"]
        recent = [s for s in self.sides if not exceeds(self.travel - s[0], window)]
        left, right = min(s[1] for s in recent), min(s[2] for s in recent)
        width = 2 * min(left, right) if p["clearance"] == "radial" else left + right
        radius = 1 / p["min_curvature_per_m"]
        if p["curvature"] != "none" and not in_start:
            if reaches(way, p["curvature_min_travel_m"]):
                radius = 1 / max(abs(turned) / way, p["min_curvature_per_m"])
            if p["curvature"] != "path":
                radius = self.by_contacts(radius)
        return left, right, width, radius, contacts, new_contacts

    def by_contacts(self, path_radius):
        smallest = path_radius
        for ray in self.rays:
            if len(ray.triple) == 3 and not exceeds(self.travel - ray.triple[0][3], self.p["contact_window_m"]):
                candidate = triple_radius(ray.triple, self.p)
                alike = 0 < candidate <= 2 * path_radius and 2 * candidate >= path_radius
                if self.p["curvature"] == "contact_literal" or alike:
                    smallest = min(smallest, candidate)
        return smallest

    def touch(self, ray, pose, clearance, force, time_s):
        p = self.p
        u = unit(ray.bearing)
        local = (ray.mount[0] + clearance * u[0], ray.mount[1] + clearance * u[1])
        point = place(pose, local)
        share = 1.0 if math.isnan(force) else min(max(force, 0.0), p["force_cap_n"]) / p["force_cap_n"]
        cell, sigma = p["memory_cell_m"], p["memory_sigma_m"]
        span = range(-int(3 * sigma / cell) - 1, int(3 * sigma / cell) + 2)
        ix, iy = math.floor(point[0] / cell), math.floor(point[1] / cell)
        for x, y in ((ix + i, iy + j) for i in span for j in span):
            d2 = ((x + 0.5) * cell - point[0]) ** 2 + ((y + 0.5) * cell - point[1]) ** 2
            if d2 <= (3 * sigma) ** 2:
                m = self.remembered((x, y), time_s)
                self.memory[x, y] = (m + (1 - m) * p["memory_gain"] * share * math.exp(-d2 / (2 * sigma * sigma)), time_s)
        spacing = p["contact_literal_spacing_m" if p["curvature"] == "contact_literal" else "contact_spacing_m"]
        if not ray.triple or reaches(math.dist(ray.triple[-1][0], point), spacing):
            c, s = unit(pose[2])
            ray.triple = (ray.triple + [(point, local[1], (-s, c), self.travel)])[-3:]

    def remembered(self, cell, time_s):
        value, since = self.memory.get(cell, (0.0, time_s))
        return value * 2.0 ** ((since - time_s) / self.p["memory_half_life_s"])

    def memory_under_body(self, position, time_s):
        cell = self.p["memory_cell_m"]
        near = [c for c in self.memory if ((c[0] + 0.5) * cell - position[0]) ** 2 +
                ((c[1] + 0.5) * cell - position[1]) ** 2 <= self.half ** 2]
        return max((self.remembered(c, time_s) for c in near), default=0.0)

    # --- the walk --------------------------------------------------------------------------------
    def lay_node(self, e):
        self.graph.nodes.append((e["pose"], unit(e["pose"][2]), e["in_start"] and not self.ever_outside, e["in_goal"]))
        return len(self.graph.nodes) - 1

    def leave(self, node, side, first, turning, along):
        self.node, self.left_by, self.node_travel = node, side, first["travel"]
        self.ahead, self.progress, self.furthest = along >= 0, 0.0, 0.0
        self.pending, self.changed = [first], turning

    def start_component(self, e):
        node = self.lay_node(e)
        self.graph.seeds[node] = self.value
        self.leave(node, FRONT, e, (), 1.0)

    def crossing(self, n, e):
        """(squared distance, side entered, slack of the change) if the last step crosses the node's line."""
        pose, heading, _, _ = self.graph.nodes[n]
        before, after = (dot(sub(q["pose"], pose), heading) for q in (self.before, e))
        if (before < 0) == (after < 0):
            return None
        share = before / (before - after)
        off = tuple(a + share * (b - a) - c for a, b, c in zip(self.before["pose"], e["pose"], pose[:2]))
        c, s = unit(e["pose"][2])
        to_left = -(off[0] * -s + off[1] * c) > 0
        free = min(q["left" if to_left else "right"] for q in self.pending)
        reach = min(self.p["merge_radius_m"], max(self.half, free - self.half))
        turned = abs(turn(pose[2], e["pose"][2]))
        askew = min(turned, math.pi - turned)
        offset = math.hypot(*off)
        if exceeds(offset, reach) or exceeds(askew, self.p["merge_angle_rad"]):
            return None
        slack = INF
        if self.p["curvature"] != "none":
            length = self.p["edge_length_m"]
            curvature = (offset + math.hypot(offset, length * math.tan(askew))) / (2 * length ** 2) + 1 / e["radius"]
            slack = 1 / (curvature + self.robot["curvature_buffer_per_m"]) - self.robot["min_turn_radius_m"]
        return dot(off, off), BACK if before < 0 else FRONT, slack

    def close(self, to, turning=()):
        felt = min(e["margin"] for e in self.pending)
        self.graph.record((self.node, self.left_by), to, felt, min([felt, *self.changed, *turning]))

    def close_at_new_node(self, e, entered, left):
        node = self.lay_node(e)
        self.close((node, entered))
        self.leave(node, left, e, (), 1.0 if left == FRONT else -1.0)

    def advance(self, e):
        self.pending.append(e)
        along = dot(sub(e["pose"], self.before["pose"]), unit(e["pose"][2]))
        self.progress += along if self.ahead else -along
        self.furthest = max(self.furthest, self.progress)
        found = [(c[0], n, c) for n in range(len(self.graph.nodes)) if n != self.node and (c := self.crossing(n, e))]
        own = None if found else self.crossing(self.node, e)
        entered = BACK if self.ahead else FRONT
        if found or own:
            _, node, (_, side, slack) = min(found) if found else (0.0, self.node, own)
            if found:
                self.close((node, side), (slack,))
            self.leave(node, 1 - side, self.before, (slack,), along)
            self.node_travel = e["travel"]
            self.pending.append(e)
        elif reaches(self.furthest - self.progress, self.p["reversal_m"]):
            self.close_at_new_node(e, entered, entered)
        elif reaches(e["travel"] - self.node_travel, self.p["edge_length_m"]):
            self.close_at_new_node(e, entered, 1 - entered)
        if e["in_goal"] and not self.entered_goal:
            self.entered_goal = True
            if not self.graph.nodes[self.node][3]:
                entered = BACK if self.ahead else FRONT
                self.close_at_new_node(e, entered, 1 - entered)

    def certificate(self):
        nodes = self.graph.nodes
        sources = {(n, side): INF for n, node in enumerate(nodes) if node[2] for side in (BACK, FRONT)}
        label = self.graph.widest(1, True, sources)
        best = max((label.get((n, side), -INF) for n, node in enumerate(nodes) if node[3] for side in (BACK, FRONT)), default=-INF)
        if self.robot["min_turn_radius_m"] == 0:
            label = self.graph.widest(1, False, {n: INF for n, node in enumerate(nodes) if node[2]})
            best = max(best, min(0.0, max((label.get(n, -INF) for n, node in enumerate(nodes) if node[3]), default=-INF)))
        return best

    def reached(self):
        sources = self.graph.seeds | {n: INF for n, node in enumerate(self.graph.nodes) if node[2]}
        return self.graph.widest(0, False, sources).get(self.node, -INF)

    # --- a tick ----------------------------------------------------------------------------------
    def update(self, tick):
        """The columns of a fresh tick; None of one that is no evidence."""
        self.gap = self.gap or tick["segment_start"]
        pose = tick["pose"]
        if not all(abs(v) <= 1e9 for v in pose) or (self.last_time is not None and tick["time_ns"] <= self.last_time):
            return None
        self.last_time = tick["time_ns"]
        if tick["stale"]:
            return None
        broken = self.began and (self.gap or exceeds(math.dist(self.last_position, pose[:2]), self.p["max_step_m"]))
        if not self.began:
            self.first_time, self.counted = tick["time_ns"], pose[:2]
            self.start = self.start or {"disc": {"x_m": pose[0], "y_m": pose[1], "radius_m": self.half}}
        elif broken:
            self.counted = pose[:2]
            self.restart_windows()
        elif reaches(math.dist(self.counted, pose[:2]), self.p["travel_deadband_m"]):
            self.travel += math.dist(self.counted, pose[:2])
            self.counted = pose[:2]
        in_start, time_s = inside(self.start, pose), 1e-9 * (tick["time_ns"] - self.first_time)
        left, right, width, radius, contacts, new_contacts = self.proxies(tick, in_start, time_s)
        slack = 1 / (1 / radius + self.robot["curvature_buffer_per_m"]) - self.robot["min_turn_radius_m"]
        memory = self.memory_under_body(pose, time_s)
        e = {"pose": pose, "travel": self.travel, "margin": min(width - self.needed, slack), "left": left, "right": right,
             "radius": radius, "in_start": in_start, "in_goal": inside(self.goal, pose)}
        if not self.began:
            self.ever_outside = not in_start
            self.start_component(e)
            self.began = True
            self.entered_goal = e["in_goal"]
        elif broken:
            self.start_component(e)
            self.entered_goal = self.entered_goal or e["in_goal"]
        else:
            self.advance(e)
        edge_margin = min(q["margin"] for q in self.pending)
        self.value = min(self.reached(), edge_margin - self.p["memory_weight_m"] * memory)
        self.before, self.gap, self.last_position = e, False, pose[:2]
        return dict(zip(COLUMNS, (self.travel, left, right, width, radius, e["margin"], edge_margin, memory, self.value,
                                  self.certificate(), contacts, new_contacts, len(self.graph.nodes), len(self.graph.edges))))


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        yield from csv.DictReader(line for line in file if not line.startswith("#"))


number = lambda cell: float(cell) if cell not in ("", "NA") else NAN


def ticks_of(path, rays):
    """Ticks as 'certify --ticks' writes them."""
    for row in rows_of(path):
        whole, _, part = row["time_s"].partition(".")
        yield {"time_ns": int(whole) * 10**9 + int((part + "0" * 9)[:9]),
               "pose": tuple(number(row[k]) for k in ("x_m", "y_m", "yaw_rad")),
               "rays": [(number(row[f"{r['name']}_{'bend_rad' if r['kind'] == 'bend' else 'range_m'}"]),
                         number(row.get(f"{r['name']}_fsr_n", ""))) for r in rays],
               "stale": row["stale"] == "1", "segment_start": row["segment_start"] == "1"}


def differences(bundle, results, changes=None):
    """{trial: largest difference of any column at any tick}; infinite where one knows and the other does not."""
    info = json.loads((Path(bundle) / "bundle.json").read_text())
    largest = {}
    for path in sorted((Path(results) / "ticks").glob("*.csv")):
        reference = Reference(info["robot"], info["rays"], info.get("course", {}), changes)
        worst = 0.0
        for tick, row in zip(ticks_of(path, info["rays"]), rows_of(Path(results) / "series" / path.name), strict=True):
            found = reference.update(tick)
            for column in COLUMNS if found else ():
                stated = -INF if row[column] == "" else float(row[column])
                if stated != found[column]:
                    worst = max(worst, abs(stated - found[column]))
        largest[path.stem] = worst
    return largest


def main(bundle, results, *changes):
    words = dict(change.split("=", 1) for change in changes)
    found = differences(bundle, results, {k: v if k in ("clearance", "curvature") else float(v) for k, v in words.items()})
    for trial, worst in found.items():
        print(f"{trial}  {worst:.1e}")
    return int(not found or any(not worst <= 1e-7 for worst in found.values()))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
