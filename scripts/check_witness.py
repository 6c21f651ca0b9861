#!/usr/bin/env python3
"""Checks witnesses against the log by code of its own: nothing of the tool is used.

    check_witness.py BUNDLE WITNESS.json ...

BUNDLE is a folder with bundle.json and logs/ (CSV with the tool's own columns, no clock repaired).
From the log it builds the free cells near the path, measures the path, and compares with what the
witness states, as lib/witness/README.md describes. A line a witness; exit code 1 if one falls.
"""
import bisect, csv, json, math, os, sys
from decimal import Decimal

INF, NAN = math.inf, math.nan
dot = lambda a, b: a[0] * b[0] + a[1] * b[1]
cross = lambda a, b: a[0] * b[1] - a[1] * b[0]
add = lambda a, s, b: (a[0] + s * b[0], a[1] + s * b[1])
extent = lambda u: abs(u[0]) + abs(u[1])
unit = lambda angle: (math.cos(angle), math.sin(angle))
turn = lambda a, b: math.remainder(b - a, 2 * math.pi)


def to_segment(p, a, b):
    way = add(b, -1, a)
    n = dot(way, way)
    return math.dist(p, add(a, min(1, max(0, dot(add(p, -1, a), way) / n)) if n else 0, way))


# --- the log -------------------------------------------------------------------------------------
def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            yield int(Decimal(row["time_s"]) * 10**9), {k: float(v) if v and v != "NA" else NAN for k, v in row.items()}


def clearance(ray, keys, row):
    if ray["kind"] == "range":
        v = row.get(ray["name"] + "_range_m", NAN)
        v = INF if v in keys.get("no_return", ()) else v
        v = ray["reach_m"] if v == INF else NAN if v < max(0, keys.get("range_min_m", 0)) or v > keys.get("range_max_m", INF) else v
    else:
        v, (x, y) = row.get(ray["name"] + "_bend_rad", NAN), ray["calibration"].values()
        i = bisect.bisect_right(x, v)
        v = NAN if not math.isfinite(v) else y[0] if i == 0 else y[-1] if i == len(x) else y[i - 1] + (v - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1])
    return v if math.isnan(v) else min(max(v, 0.0), ray["reach_m"])


def samples(folder, info, proof):
    """[[pose, clearances, broken]]: touches with a pose, glitches taken out."""
    gap, rays, out = info.get("max_gap_s", 1.0) * 1e9, proof["rays"], []
    merged = os.path.exists(os.path.join(folder, "ticks.csv"))
    touches = list(table(os.path.join(folder, "ticks.csv" if merged else "tactile.csv")))
    poses = touches if merged else list(table(os.path.join(folder, "pose.csv")))
    times = [t for t, _ in poses]
    starts = sorted(b for s in (times, [t for t, _ in touches]) for a, b in zip(s, s[1:]) if b - a > gap)
    bridge, broken, seen = 0 if merged else proof["rule"]["pose_bridge_s"], True, 0
    for t, row in touches:
        c = [clearance(r, k, row) for r, k in zip(rays, info["rays"])]
        broken = broken or bisect.bisect_right(starts, t) > seen
        seen = bisect.bisect_right(starts, t)
        i = bisect.bisect_right(times, t) - 1
        if i < 0 or merged and all(map(math.isnan, c)):
            continue
        x, y, yaw = (poses[i][1][k] for k in ("x_m", "y_m", "yaw_rad"))
        if times[i] != t:
            if i + 1 == len(times) or any(times[i] < b <= times[i + 1] for b in starts) or (times[i + 1] - times[i]) * 1e-9 > bridge:
                continue
            share, q = ((t - times[i]) * 1e-9) / ((times[i + 1] - times[i]) * 1e-9), poses[i + 1][1]
            x, y, yaw = x + share * (q["x_m"] - x), y + share * (q["y_m"] - y), yaw + share * turn(yaw, q["yaw_rad"])
        out.append([((x, y), yaw), c, broken])
        broken = False
    for k, ray in enumerate(rays):
        read = [s for s in out if not math.isnan(s[1][k])]
        low = []
        for a, b, c in zip(read, read[1:], read[2:]):
            least = min(a[1][k], c[1][k])
            tips = [add(mount(s[0], ray), least, unit(s[0][1] + ray["bearing_rad"])) for s in (a, c)]
            low += [b] if b[1][k] < least - proof["rule"]["lost_share"] * math.dist(*tips) - 0.006 else []
        for s in low:
            s[1][k] = NAN
    return out


def mount(pose, ray):
    u, x, y = unit(pose[1]), ray.get("mount_x_m", 0), ray.get("mount_y_m", 0)
    return (pose[0][0] + u[0] * x - u[1] * y, pose[0][1] + u[1] * x + u[0] * y)


# --- the free cells ------------------------------------------------------------------------------
class Cells:
    """Cells within a distance of the path: {row: {column: free}}."""

    def __init__(self, h, chords, reach):
        self.h, self.rows = h, {}
        for a, b, _ in chords:
            for k in range(n := max(1, math.ceil(math.dist(a, b) / h)) + 1):
                p = add(a, k / max(1, n - 1), add(b, -1, a))
                for iy in range(math.floor((p[1] - reach) / h), math.floor((p[1] + reach) / h) + 1):
                    off = max(iy * h - p[1], 0, p[1] - (iy + 1) * h)
                    half = math.sqrt(max(0, reach * reach - off * off))
                    self.rows.setdefault(iy, []).append((math.floor((p[0] - half) / h), math.floor((p[0] + half) / h)))
        for iy, runs in self.rows.items():
            self.rows[iy], end = {}, -INF
            for first, last in sorted(runs):
                self.rows[iy].update(dict.fromkeys(range(int(max(first, end)), last + 1), False))
                end = max(end, last + 1)

    def box(self, low, high, test):
        h = self.h
        for iy in range(math.floor(low[1] / h), math.floor(high[1] / h) + 1):
            row = self.rows.get(iy, {})
            for ix in range(math.floor(low[0] / h), math.floor(high[0] / h) + 1):
                if row.get(ix) is False and test(ix * h, iy * h):
                    row[ix] = True

    def disc(self, c, r):
        self.box((c[0] - r, c[1] - r), (c[0] + r, c[1] + r), lambda x, y: math.hypot(max(c[0] - x, x + self.h - c[0]), max(c[1] - y, y + self.h - c[1])) < r)


def inside(region, p):
    if "disc" in region:
        d = region["disc"]
        return math.dist(p, (d["x_m"], d["y_m"])) <= d["radius_m"]
    v = region["polygon"]
    return sum((a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) for a, b in zip(v, v[-1:] + v[:-1])) % 2 == 1


def mark_region(cells, region):
    h = cells.h
    if "disc" in region:
        return cells.disc((region["disc"]["x_m"], region["disc"]["y_m"]), region["disc"]["radius_m"])
    v = region["polygon"]
    edges = list(zip(v, v[-1:] + v[:-1]))
    middle = lambda x, y: (x + h / 2, y + h / 2)
    cells.box((min(p[0] for p in v), min(p[1] for p in v)), (max(p[0] for p in v), max(p[1] for p in v)), lambda x, y: inside(region, middle(x, y)) and min(to_segment(middle(x, y), a, b) for a, b in edges) > h / math.sqrt(2))


def sweep(cells, run, k, ray, rule, body_radius):
    """What ray k has passed: strips between its positions, remembered 64 positions back."""
    h, chain, side, last_c = cells.h, [], 0, 0.0  # chain: (mount, u, middle, near, far)
    gap = body_radius - math.hypot(ray.get("mount_x_m", 0), ray.get("mount_y_m", 0))
    for pose, readings, broken in run:
        m, u, c = mount(pose, ray), unit(pose[1] + ray["bearing_rad"]), readings[k]
        chain = [] if broken else chain
        if math.isnan(c):
            continue
        c = max(0.0, c - rule["reading_bound_m"])
        if chain:
            m0, u0 = chain[-1][:2]
            least, way = min(c, last_c), add(m, -1, m0)
            d = max(math.hypot(*way), math.hypot(*add(way, least, add(u, -1, u0))))
            if d < 0.001:
                continue
        if not chain or d > rule["least_obstacle_m"] or dot(u, u0) < 0.5:
            chain, side, last_c = [(m, u, u, 0, 0)], 0, c
            continue
        both = add(u, 1, u0)
        mid = (both[0] / math.hypot(*both), both[1] / math.hypot(*both))
        cosine, offset, lost = dot(u, mid), dot(way, mid), rule["lost_share"] * d
        near, far = max(0.0, offset) + (0 if gap >= lost else lost), least * cosine + min(0.0, offset) - lost
        sine = cross(u, u0)
        pivot = cross(u, way) / sine if sine else -1
        pivot = cosine * pivot if pivot >= 0 else INF
        spans = (near, min(far, 0.95 * pivot)), (max(near, 1.05 * pivot), far)
        near, far = spans[0] if spans[0][1] - spans[0][0] >= spans[1][1] - spans[1][0] else spans[1]
        if not far > near:
            if d >= 0.03:
                chain, side, last_c = [(m, u, u, 0, 0)], 0, c
            continue
        quad = [add(m0, near / cosine, u0), add(m0, far / cosine, u0), add(m, (far - offset) / cosine, u), add(m, (near - offset) / cosine, u)]
        now = -1 if cross(u0, (quad[2][0] + quad[3][0] - quad[1][0] - quad[0][0], quad[2][1] + quad[3][1] - quad[1][1] - quad[0][1])) < 0 else 1
        if now != side:
            if side and d < 0.012:
                continue
            chain, side = chain[-1:], now
        chain = (chain + [(m, u, mid, dot(mid, m0) + near, dot(mid, m0) + far)])[-64:]
        last_c = c

        def passed(x, y):
            p, half = (x + h / 2, y + h / 2), h / 2
            ahead = lambda s: side * cross(s[1], add(p, -1, s[0]))
            if ahead(chain[-1]) + half * extent(chain[-1][1]) > 0 or ahead(chain[-2]) + half * extent(chain[-2][1]) <= 0:
                return False
            for s, before in zip(chain[:0:-1], chain[-2::-1]):
                depth, margin = dot(s[2], p), half * extent(s[2])
                if depth - margin < s[3] or depth + margin > s[4]:
                    return False
                if ahead(before) >= half * extent(before[1]):
                    return True
            return False

        xs, ys = [q[0] for q in quad], [q[1] for q in quad]
        cells.box((min(xs), min(ys)), (max(xs), max(ys)), passed)


# --- the path ------------------------------------------------------------------------------------
def measure(proof):
    """Chords (from, to, bulge), and the largest curvature; an exception if it is no path."""
    robot, chords, curvature, spare, pieces = proof["robot"], [], 0.0, 0.0, proof["path"]
    heading = lambda p, end: math.atan2(p["to"][1] - p["from"][1], p["to"][0] - p["from"][0]) + end * p["turn_rad"] / 2
    assert inside(proof["start"], pieces[0]["from"]) and inside(proof["goal"], pieces[-1]["to"]), "it does not lead from S to G"
    for p, after in zip(pieces, pieces[1:] + [None]):
        bend, chord = abs(p["turn_rad"]), math.dist(p["from"], p["to"])
        assert 0 < chord < INF and bend <= 3, "a piece has no length, or turns too far"
        length = chord * (bend / 2) / math.sin(bend / 2) if bend else chord
        kink = abs(turn(heading(p, 1), heading(after, -1))) if after else 0.0
        assert after is None or p["to"] == after["from"], "two pieces do not meet"
        assert kink <= 1e-6 or robot["min_turn_radius_m"] == 0, "the path has a corner"
        curvature = max(curvature, INF if kink > 1e-6 else (bend + spare + kink) / length)
        spare = 0 if kink > 1e-6 else kink
        n = int(max(1, math.ceil(length / 0.1), math.ceil(math.sqrt(length * bend / 4e-4))))
        points = [p["from"]] + [add(p["from"], chord * (math.sin(i / n * bend / 2) / math.sin(bend / 2) if bend else i / n), unit(heading(p, -1) + i / n * p["turn_rad"] / 2)) for i in range(1, n)] + [p["to"]]
        chords += [(a, b, length * bend / (8 * n * n)) for a, b in zip(points, points[1:])]
    return chords, curvature


def to_cell(a, b, x, y, h):
    box = lambda p: math.hypot(max(x - p[0], 0, p[0] - x - h), max(y - p[1], 0, p[1] - y - h))
    corners = [(x, y), (x + h, y), (x, y + h), (x + h, y + h)]
    sides = [cross(add(b, -1, a), add(c, -1, a)) for c in corners]
    meets = min(sides) <= 0 <= max(sides) and max(a[0], b[0]) >= x and min(a[0], b[0]) <= x + h and max(a[1], b[1]) >= y and min(a[1], b[1]) <= y + h
    return 0.0 if meets else min(box(a), box(b), *(to_segment(c, a, b) for c in corners))


def check(bundle, proof):
    with open(os.path.join(bundle, "bundle.json"), encoding="utf-8") as file:
        info = json.load(file)
    same = lambda stated, given: all(given.get(k, 0) == v for k, v in stated.items())
    assert len(proof["rays"]) == len(info["rays"]) and all(map(same, proof["rays"], info["rays"])), "it states other rays than the bundle"
    run = samples(os.path.join(bundle, "logs", proof["trial_id"]), info, proof)
    (x, y), radius = run[0][0][0], proof["robot"]["body_width_m"] / 2
    start = info["course"].get("start", {"disc": {"x_m": x, "y_m": y, "radius_m": radius}})
    assert same(proof["start"], start) and same(proof["goal"], info["course"]["goal"]), "it states another course"
    chords, curvature = measure(proof)
    h, robot, rule = proof["rule"]["cell_m"], proof["robot"], proof["rule"]
    reach = proof["clearance_m"] + 2 * h
    cells = Cells(h, chords, reach)
    for region in (proof["start"], proof["goal"]):
        mark_region(cells, region)
    marked = None
    for (at, _), _, _ in run:
        if marked is None or math.dist(marked, at) > 0.004:
            marked = at
            cells.disc(at, robot["body_width_m"] / 2)
    for k, ray in enumerate(proof["rays"]):
        sweep(cells, run, k, ray, rule, robot["body_width_m"] / 2)
    least = reach
    for iy, row in cells.rows.items():
        for ix in (ix for ix, free in row.items() if not free):
            for a, b, bulge in chords:
                if abs(ix * h - a[0]) < least + 0.2 and abs(iy * h - a[1]) < least + 0.2:
                    least = min(least, to_cell(a, b, ix * h, iy * h, h) - bulge)
    assert least > 0, "the path leaves the free cells"
    slack = 1 / (curvature + robot["curvature_buffer_per_m"]) if curvature + robot["curvature_buffer_per_m"] else INF
    margin = min(2 * least - robot["body_width_m"] - 2 * robot["tracking_buffer_m"], slack - robot["min_turn_radius_m"])
    assert abs(margin - proof["margin_m"]) < 1e-9, f"it states {proof['margin_m']} m, measured are {margin} m"
    return margin


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    fallen = False
    for path in sys.argv[2:]:
        try:
            with open(path, encoding="utf-8") as file:
                print(f"{path}: stands, {check(sys.argv[1], json.load(file)):.6f} m", flush=True)
        except (AssertionError, KeyError, IndexError, TypeError, ValueError, ArithmeticError, OSError) as error:
            print(f"{path}: {error or type(error).__name__}", flush=True)
            fallen = True
    sys.exit(1 if fallen else 0)


if __name__ == "__main__":
    main()
