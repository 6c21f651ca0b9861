#!/usr/bin/env python3
"""Checks witnesses against the log by code of its own: nothing of the tool is used.

    check_witness.py BUNDLE WITNESS.json ...

BUNDLE is a folder with bundle.json and logs/ (CSV with the tool's own columns, no clock repaired).
From the log it builds the free cells near the paths, of the trial and of its edges, measures the
paths, and compares with what the witness states, as lib/witness/README.md describes; nodes are taken
as stated. A line a witness; exit code 1 if one falls.
"""
import bisect, csv, hashlib, itertools, json, math, os, sys
from decimal import Decimal

INF, NAN = math.inf, math.nan
MOST_CELLS, MOST_WORK = 3 * 10**7, 10**8


class Refused(Exception):
    """Why a witness does not stand."""


def require(holds, why):
    if not holds:
        raise Refused(why)


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


def digest(folder):
    """Of the log's files, as certificates.csv has it: over a line "<sha256>  <path>" a file."""
    paths = sorted(os.path.relpath(os.path.join(place, name), folder) for place, _, names in os.walk(folder) for name in names)
    lines = ""
    for path in paths:
        with open(os.path.join(folder, path), "rb") as file:
            lines += f"{hashlib.sha256(file.read()).hexdigest()}  {path}\n"
    return hashlib.sha256(lines.encode()).hexdigest()


def clearance(ray, keys, row):
    if ray["kind"] == "range":
        v = row.get(ray["name"] + "_range_m", NAN)
        v = INF if v in keys.get("no_return", ()) else v
        v = ray["reach_m"] if v == INF else NAN if v < max(0, keys.get("range_min_m", 0)) or v > keys.get("range_max_m", INF) else v
    else:
        v, (x, y) = row.get(ray["name"] + "_bend_rad", NAN), (ray["calibration"][k] for k in ("bend_rad", "clearance_m"))
        i = bisect.bisect_right(x, v)
        v = NAN if not math.isfinite(v) else y[0] if i == 0 else y[-1] if i == len(x) else y[i - 1] + (v - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1])
    return v if math.isnan(v) else min(max(v, 0.0), ray["reach_m"])


def samples(folder, info, proof):
    """[[pose, clearances, broken, bearings]]: touches with a pose, glitches taken out."""
    gap, rays, out = info.get("max_gap_s", 1.0) * 1e9, proof["rays"], []
    merged = os.path.exists(os.path.join(folder, "ticks.csv"))
    touches = list(table(os.path.join(folder, "ticks.csv" if merged else "tactile.csv")))
    poses = touches if merged else list(table(os.path.join(folder, "pose.csv")))
    times = [t for t, _ in poses]
    starts = sorted(b for s in (times, [t for t, _ in touches]) for a, b in zip(s, s[1:]) if b - a > gap)
    bridge, broken, seen = 0 if merged else proof["rule"]["pose_bridge_s"], True, 0
    for t, row in touches:
        b = [row.get(r["name"] + "_bearing_rad", NAN) for r in rays]
        c = [NAN if abs(a) > 6.3 else clearance(r, k, row) for r, k, a in zip(rays, info["rays"], b)]
        b = [a if abs(a) <= 6.3 else r["bearing_rad"] for r, a in zip(rays, b)]
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
        out.append([((x, y), yaw), c, broken, b])
        broken = False
    for k, ray in enumerate(rays):
        read = [s for s in out if not math.isnan(s[1][k])]
        low = []
        for a, b, c in zip(read, read[1:], read[2:]):
            least = min(a[1][k], c[1][k])
            tips = [add(mount(s[0], ray), least, unit(s[0][1] + s[3][k])) for s in (a, c)]
            low += [b] if b[1][k] < least - proof["rule"]["lost_share"] * math.dist(*tips) - 0.006 else []
        for s in low:
            s[1][k] = NAN
    return out


def mount(pose, ray):
    u, x, y = unit(pose[1]), ray.get("mount_x_m", 0), ray.get("mount_y_m", 0)
    return (pose[0][0] + u[0] * x - u[1] * y, pose[0][1] + u[1] * x + u[0] * y)


def overlap(a, b):
    """Whether two regions have a point in common."""
    if "disc" in a and "disc" in b:
        return math.dist(*((r["disc"]["x_m"], r["disc"]["y_m"]) for r in (a, b))) <= a["disc"]["radius_m"] + b["disc"]["radius_m"]
    if "disc" in a:
        a, b = b, a
    edges = lambda v: list(zip(v, v[-1:] + v[:-1]))
    if "disc" in b:
        centre = (b["disc"]["x_m"], b["disc"]["y_m"])
        return inside(a, centre) or any(to_segment(centre, p, q) <= b["disc"]["radius_m"] for p, q in edges(a["polygon"]))
    side = lambda p, q, r: cross(add(q, -1, p), add(r, -1, p)) > 0
    crossing = lambda p, q, r, s: side(p, q, r) != side(p, q, s) and side(r, s, p) != side(r, s, q)
    return inside(a, b["polygon"][0]) or inside(b, a["polygon"][0]) or any(crossing(*e, *f) for e in edges(a["polygon"]) for f in edges(b["polygon"]))


# --- the free cells ------------------------------------------------------------------------------
class Cells:
    """Cells within a distance of the paths: {row: {column: free}}."""

    def __init__(self, h, chords):
        """Of chords (from, to, distance)."""
        self.h, self.rows = h, {}
        work = sum((math.dist(a, b) / h + 2) * (2 * reach / h + 2) for a, b, reach in chords)
        area = sum((math.dist(a, b) + 2 * reach) * reach for a, b, reach in chords)
        require(work < MOST_WORK and area / h / h < MOST_CELLS, "its path has too many cells near it")
        for a, b, reach in chords:
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
        """Marks what the disc covers: of each row what lies between the ends of its chord there."""
        h = self.h
        for iy in range(math.floor((c[1] - r) / h), math.floor((c[1] + r) / h) + 1):
            off = max(c[1] - iy * h, (iy + 1) * h - c[1])
            if off < r:
                half, row = math.sqrt(r * r - off * off), self.rows.get(iy, {})
                for ix in range(math.floor((c[0] - half) / h) + 1, math.floor((c[0] + half) / h)):
                    if ix in row:
                        row[ix] = True


def inside(region, p):
    if "disc" in region:
        d = region["disc"]
        return math.dist(p, (d["x_m"], d["y_m"])) <= d["radius_m"]
    v = region["polygon"]
    return sum((a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) for a, b in zip(v, v[-1:] + v[:-1])) % 2 == 1


def mark_region(cells, region):
    h = cells.h
    if "disc" in region:
        x, y, r = (region["disc"][k] for k in ("x_m", "y_m", "radius_m"))
        return cells.box((x - r, y - r), (x + r, y + r), lambda left, low: max(x - left, left + h - x) ** 2 + max(y - low, low + h - y) ** 2 <= r * r)
    v = region["polygon"]
    edges = list(zip(v, v[-1:] + v[:-1]))
    middle = lambda x, y: (x + h / 2, y + h / 2)
    cells.box((min(p[0] for p in v), min(p[1] for p in v)), (max(p[0] for p in v), max(p[1] for p in v)), lambda x, y: inside(region, middle(x, y)) and min(to_segment(middle(x, y), a, b) for a, b in edges) > h / math.sqrt(2))


def sweep(cells, run, k, ray, rule, body_radius):
    """What ray k has passed: strips between its positions, remembered 64 positions back."""
    h, chain, side, last_c = cells.h, [], 0, 0.0  # chain: (mount, u, middle, near, far)
    gap = body_radius - math.hypot(ray.get("mount_x_m", 0), ray.get("mount_y_m", 0))
    for pose, readings, broken, bearings in run:
        m, u, c = mount(pose, ray), unit(pose[1] + bearings[k]), readings[k]
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

        # A cell that only touches the strip's border is looked at too.
        xs, ys, e = [q[0] for q in quad], [q[1] for q in quad], 1e-6 * h
        cells.box((min(xs) - e, min(ys) - e), (max(xs) + e, max(ys) + e), passed)


def marked_as_stated(cells, free):
    """Whether the cells near the path are free where `free` says so, run by run, and nowhere else."""
    lines = "".join(" ".join(map(str, runs)) + "\n" for runs in free["runs"])
    if free["sha256"] != hashlib.sha256(lines.encode()).hexdigest():
        return False
    for iy, row in cells.rows.items():
        inside_box = 0 <= iy - free["first_y"] < free["rows"]
        ends = list(itertools.accumulate(free["runs"][iy - free["first_y"]])) if inside_box else []
        if any(found != (bisect.bisect_right(ends, ix - free["first_x"]) % 2 == 1 and bisect.bisect_right(ends, ix - free["first_x"]) < len(ends)) for ix, found in row.items()):
            return False
    return True


# --- the path ------------------------------------------------------------------------------------
heading = lambda p, end: math.atan2(p["to"][1] - p["from"][1], p["to"][0] - p["from"][0]) + end * p["turn_rad"] / 2


def measure(robot, pieces):
    """Chords (from, to, bulge), and the largest curvature; an exception if it is no path."""
    chords, curvature, spare = [], 0.0, 0.0
    for p, after in zip(pieces, pieces[1:] + [None]):
        bend, chord = abs(p["turn_rad"]), math.dist(p["from"], p["to"])
        require(len(p["from"]) == len(p["to"]) == 2 and 0 < chord < INF and bend <= 3, "a piece has no length, or turns too far")
        length = chord * (bend / 2) / math.sin(bend / 2) if bend else chord
        kink = abs(turn(heading(p, 1), heading(after, -1))) if after else 0.0
        require(after is None or p["to"] == after["from"], "two pieces do not meet")
        require(kink <= 1e-6 or robot["min_turn_radius_m"] == 0, "the path has a corner")
        curvature = max(curvature, INF if kink > 1e-6 else (bend + spare + kink) / length)
        spare = 0 if kink > 1e-6 else kink
        n = int(max(1, math.ceil(length / 0.1), math.ceil(math.sqrt(length * bend / 4e-4))))
        points = [p["from"]] + [add(p["from"], chord * (math.sin(i / n * bend / 2) / math.sin(bend / 2) if bend else i / n), unit(heading(p, -1) + i / n * p["turn_rad"] / 2)) for i in range(1, n)] + [p["to"]]
        chords += [(a, b, length * bend / (8 * n * n)) for a, b in zip(points, points[1:])]
    return chords, curvature


def states_nothing(one):
    """Whether all that a path would prove is null."""
    return all(one[name] is None for name in ("margin_m", "clearance_m", "turn_radius_m", "bottleneck"))


def measured_edges(proof):
    """(what is stated, chords, curvature) of every edge that has a path, from waypoint to waypoint."""
    if "edges" not in proof:
        return
    nodes, radius = proof["edges"]["nodes"], proof["edges"]["merge_radius_m"]
    require(0 <= radius < INF, "its merge radius is none")
    for n in nodes:
        at, place = n["pose"][:2], n["waypoint"][:2]
        near = math.dist(at, place) <= radius or any(inside(r, at) and inside(r, place) for r in (proof["start"], proof["goal"]))
        require(near, "a waypoint lies too far from its node")
    for e in proof["edges"]["paths"]:
        if not e["path"]:
            require(states_nothing(e), "an edge states what no path of it proves")
            continue
        ends = []
        for end, way in (e["from"], 0), (e["to"], math.pi):
            require(0 <= end["node"] < len(nodes) and end["side"] in ("front", "back"), "an edge has no such end")
            x, y, yaw = nodes[end["node"]]["waypoint"]
            ends.append(([x, y], yaw + way + (0 if end["side"] == "front" else math.pi)))
        first, last = e["path"][0], e["path"][-1]
        leads = first["from"] == ends[0][0] and last["to"] == ends[1][0] and abs(turn(heading(first, -1), ends[0][1])) <= 1e-7 and abs(turn(heading(last, 1), ends[1][1])) <= 1e-7
        require(leads, "an edge does not lead from waypoint to waypoint")
        yield (e, *measure(proof["robot"], e["path"]))


def compare(stated, chords, curvature, cells, robot):
    """The margin, if it is as stated."""
    reach = stated["clearance_m"] + 2 * cells.h
    least = nearest(chords, cells, reach)
    require(least > 0, "the path leaves the free cells")
    radius, buffer = 1 / curvature if curvature else INF, robot["curvature_buffer_per_m"]
    slack = 1 / (curvature + buffer) if curvature + buffer else INF
    near = min(to_segment(stated["bottleneck"], a, b) for a, b, _ in chords)
    require(len(stated["bottleneck"]) == 2 and near < 0.06, "its bottleneck does not lie on its path")
    margin = min(2 * least - robot["body_width_m"] - 2 * robot["tracking_buffer_m"], slack - robot["min_turn_radius_m"])
    stated_radius = INF if stated["turn_radius_m"] is None else stated["turn_radius_m"]
    for name, found, claim in ("margin_m", margin, stated["margin_m"]), ("clearance_m", least, stated["clearance_m"]), ("turn_radius_m", radius, stated_radius):
        require(found == claim or abs(found - claim) < 1e-9 * max(1, abs(claim)), f"it states {name} {claim}, measured are {found}")
    return margin


def to_cell(a, b, x, y, h):
    box = lambda p: math.hypot(max(x - p[0], 0, p[0] - x - h), max(y - p[1], 0, p[1] - y - h))
    corners = [(x, y), (x + h, y), (x, y + h), (x + h, y + h)]
    sides = [cross(add(b, -1, a), add(c, -1, a)) for c in corners]
    meets = min(sides) <= 0 <= max(sides) and max(a[0], b[0]) >= x and min(a[0], b[0]) <= x + h and max(a[1], b[1]) >= y and min(a[1], b[1]) <= y + h
    return 0.0 if meets else min(box(a), box(b), *(to_segment(c, a, b) for c in corners))


def nearest(chords, cells, least):
    """Distance of the chords to the nearest cell that is not free, if that is below `least`."""
    h = cells.h
    for a, b, bulge in chords:
        low, high = (min(a[i], b[i]) - least - h for i in (0, 1)), (max(a[i], b[i]) + least + h for i in (0, 1))
        (x0, y0), (x1, y1) = (math.floor(v / h) for v in low), (math.floor(v / h) for v in high)
        for iy in range(y0, y1 + 1):
            row = cells.blocked.get(iy, ())
            for ix in row[bisect.bisect_left(row, x0) : bisect.bisect_right(row, x1)]:
                least = min(least, to_cell(a, b, ix * h, iy * h, h) - bulge)
    return least


def check(bundle, proof):
    with open(os.path.join(bundle, "bundle.json"), encoding="utf-8") as file:
        info = json.load(file)
    require(proof["format"] == "tcert-witness" and proof["version"] == 1, "it is not of format tcert-witness, version 1")
    rule, robot = proof["rule"], proof["robot"]
    require(all(0 <= v < INF for v in (*rule.values(), *robot.values())) and rule["cell_m"] >= 1e-4, "its rule or its robot has a value that is none")
    require(proof["log_sha256"] == digest(os.path.join(bundle, "logs", proof["trial_id"])), "it is of another log")
    keys = ("name", "kind", "mount_x_m", "mount_y_m", "bearing_rad", "reach_m", "calibration")
    same = lambda a, b, names: all(a.get(k, 0) == b.get(k, 0) for k in names)
    require(len(proof["rays"]) == len(info["rays"]) and all(same(a, b, keys) for a, b in zip(proof["rays"], info["rays"])), "it states other rays than the bundle")
    run = samples(os.path.join(bundle, "logs", proof["trial_id"]), info, proof)
    (x, y), radius = run[0][0][0], proof["robot"]["body_width_m"] / 2
    start = info["course"].get("start", {"disc": {"x_m": x, "y_m": y, "radius_m": radius}})
    require(proof["start"] == start and proof["goal"] == info["course"]["goal"], "it states another course")
    require(not overlap(start, proof["goal"]), "S and G overlap")
    edges, found = list(measured_edges(proof)), []
    if proof["path"]:
        require(inside(start, proof["path"][0]["from"]) and inside(proof["goal"], proof["path"][-1]["to"]), "it does not lead from S to G")
        found.append((proof, *measure(robot, proof["path"])))
    else:
        require("edges" in proof and states_nothing(proof), "it has no path, or states what none proves")
    h = rule["cell_m"]
    cells = Cells(h, [(a, b, stated["clearance_m"] + 2 * h) for stated, chords, _ in found + edges for a, b, _ in chords])
    for region in (proof["start"], proof["goal"]):
        mark_region(cells, region)
    marked = None
    for (at, _), *_ in run:
        if marked is None or math.dist(marked, at) > 0.004:
            marked = at
            cells.disc(at, robot["body_width_m"] / 2)
    for k, ray in enumerate(proof["rays"]):
        sweep(cells, run, k, ray, rule, robot["body_width_m"] / 2)
    cells.blocked = {iy: sorted(ix for ix, free in row.items() if not free) for iy, row in cells.rows.items()}
    margins = [compare(*one, cells, robot) for one in found + edges]
    require(marked_as_stated(cells, proof["free"]), "it states other free cells near the path")
    other = [f"{k} {v:g}" for k, v in robot.items() if v != info["robot"].get(k, 0)]
    whole = f"{margins[0]:.6f} m" if found else "no path from S to G"
    return whole + (f", {len(edges)} edges, waypoints within {proof['edges']['merge_radius_m']:g} m" if "edges" in proof else "") + (" for another robot than the bundle's: " + ", ".join(other) if other else "")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    fallen = False
    for path in sys.argv[2:]:
        try:
            with open(path, encoding="utf-8") as file:
                print(f"{path}: stands, {check(sys.argv[1], json.load(file))}", flush=True)
        except (Refused, RecursionError, AttributeError, KeyError, IndexError, TypeError, ValueError, ArithmeticError, OSError) as error:
            print(f"{path}: {error or type(error).__name__}", flush=True)
            fallen = True
    sys.exit(1 if fallen else 0)


if __name__ == "__main__":
    main()
