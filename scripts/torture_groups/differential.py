"""The tool's answers beside those of other programs: Python references of certificate, witness and terrain,
and R, on data that are drawn anew each time."""
import csv
import json
import math
import random
import shutil
import subprocess
import sys

from .bench import Skipped, require

R_SCRIPT = r"""
suppressMessages(library(survival))
d <- read.csv(commandArgs(TRUE)[1], stringsAsFactors = TRUE)
say <- function(name, values) cat(name, sprintf("%.17g", values), "\n")
g <- glm(y ~ a + b, binomial, d, control = glm.control(epsilon = 1e-14, maxit = 100))
say("glm", c(coef(g), sqrt(diag(vcov(g)))))
c <- coxph(Surv(t, y) ~ a + b, d, control = coxph.control(eps = 1e-12, iter.max = 100))
say("cox", c(coef(c), sqrt(diag(vcov(c)))))
s <- survfit(Surv(t, y) ~ 1, d)
k <- summary(s, times = c(0.5, 1, 2), extend = TRUE)
say("km", k$surv)
say("concordance", concordance(Surv(t, y) ~ a, d)$concordance)
r <- rank(d$a); n <- sum(d$y); m <- sum(!d$y)
say("roc", (sum(r[d$y == 1]) - n * (n + 1) / 2) / (n * m))
"""


def reference(bench):
    sys.path.insert(0, str(bench.root / "scripts"))
    import reference_certificate
    return reference_certificate


PARAMETERS = {"clearance": ["radial"], "curvature": ["contact", "contact_literal", "none"], "edge_length_m": [0.1, 0.5],
              "merge_radius_m": [0.05, 0.3], "merge_angle_rad": [0.1, 0.6], "reversal_m": [0.02, 0.2], "side_window_m": [0.1, 1.0],
              "curvature_window_m": [0.12, 0.6], "memory_weight_m": [0.0, 0.3], "memory_half_life_s": [2.0],
              "travel_deadband_m": [0.002, 0.03], "contact_on_n": [0.7], "side_angle_rad": [0.1], "body_width_m": [0.3, 0.6],
              "min_turn_radius_m": [0.0, 0.6], "tracking_buffer_m": [0.03], "curvature_buffer_per_m": [0.2]}


def certificate(bench, rng):
    """Every column of the series, tick by tick, of a corpus and parameters that are drawn."""
    changes = {k: rng.choice(PARAMETERS[k]) for k in rng.sample(sorted(PARAMETERS), rng.choice((0, 1, 3, 5)))}
    seed = rng.randrange(1, 10**9)
    place = bench.attempt
    source = ["drive", "--worlds", "1", "--policies", rng.choice(("M1", "M2", "M3", "CB-V"))] if rng.random() < 0.3 else \
        ["simulate", "--trials", "2"]
    bench.make(*source, "--seed", seed, "--output", "corpus", "--quiet")
    words = [w for k, v in changes.items() for w in ("--set", f"{k}={v}")]
    bench.run("certify", "corpus", "--ticks", "--output", "out", *words, "--quiet").ended_well({0, 3})
    found = reference(bench).differences(place / "corpus", place / "out", changes)
    require(found and all(worst <= 1e-7 for worst in found.values()),
            f"series and reference differ by {found}, seed {seed}, {changes}")


def widest_path(bench, rng):
    """T of certificates.csv is at most, and by felt margins alone exactly, what a search of edges gives."""
    bench.make("simulate", "--trials", "6", "--seed", rng.randrange(1, 10**9), "--output", "corpus", "--quiet")
    bench.make("certify", "corpus", "--set", "curvature=none", "--output", "out", "--quiet")
    info = json.loads((bench.attempt / "corpus/bundle.json").read_text())
    ends = [info["course"][k]["disc"] for k in ("start", "goal")]
    for row in reference(bench).rows_of(bench.attempt / "out/certificates.csv"):
        edges = list(reference(bench).rows_of(bench.attempt / "out/edges" / f"{row['trial_id']}.csv"))
        place = {e[end]: (float(e[f"{end}_x_m"]), float(e[f"{end}_y_m"])) for e in edges for end in "ab"}
        tied = [{n for n, p in place.items() if math.dist(p, (d["x_m"], d["y_m"])) <= d["radius_m"]} for d in ends]
        label = dict.fromkeys(tied[0], math.inf)
        for _ in edges:
            for e in edges:
                for a, b in ((e["a"], e["b"]), (e["b"], e["a"])):
                    label[b] = max(label.get(b, -math.inf), min(label.get(a, -math.inf), float(e["margin_m"])))
        sideless = max((label.get(n, -math.inf) for n in tied[1]), default=-math.inf)
        stated = float(row["certificate_m"]) if row["certificate_m"] else -math.inf
        require(stated <= sideless + 1e-12, f"{row['trial_id']}: T = {stated} is above every path, {sideless}")


def witness(bench, rng):
    """Witnesses of a fresh corpus stand by the checker in Python."""
    bench.make("simulate", "--trials", "4", "--seed", rng.randrange(1, 10**9), "--output", "corpus", "--quiet")
    bench.make("certify", "corpus", "--witness", "--output", "out", "--quiet")
    proofs = sorted((bench.attempt / "out/witness").glob("*.json"))
    run = subprocess.run([sys.executable, bench.root / "scripts/check_witness.py", "corpus", *proofs], cwd=bench.attempt,
                         capture_output=True)
    require(run.returncode == 0, f"a witness falls: {(run.stdout + run.stderr)[-600:].decode()}")


def terrain(bench, rng):
    """Ground that is certified is the union of discs round measurements, and it is safe."""
    rows, columns = rng.randint(8, 30), rng.randint(8, 30)
    kind = rng.choice(("gaussian", "matern52", "matern32"))
    bench.make("simulate", "terrain", "--rows", rows, "--columns", columns, "--kind", kind, "--seed", rng.randrange(1, 10**9),
               "--output", "ground.csv", "--quiet")
    lines = [line for line in (bench.attempt / "ground.csv").read_text().splitlines() if not line.startswith(("#", "SYNTHETIC"))]
    ground = [[float(v) for v in line.split(",")] for line in lines]
    require(len(ground) == rows and all(len(line) == columns for line in ground), "the terrain has another size")
    cells = [(x, y) for x in range(rows) for y in range(columns)]
    slope = max(abs(ground[a[0]][a[1]] - ground[b[0]][b[1]]) / math.dist(a, b)
                for a in cells for b in rng.sample(cells, min(len(cells), 60)) if a != b)
    steepest = max([slope] + [abs(ground[x][y] - ground[u][v]) / math.dist((x, y), (u, v)) for x, y in cells
                              for u, v in ((x + 1, y), (x, y + 1), (x + 1, y + 1), (x + 1, y - 1)) if u < rows and 0 <= v < columns])
    start = rng.choice(cells)
    threshold = ground[start[0]][start[1]] - rng.uniform(1, 12) * steepest
    run = bench.run("explore", "ground.csv", "--start", f"{start[0]},{start[1]}", "--lipschitz", 1.5 * steepest, "--threshold", threshold,
                    "--mode", "explore", "--max-steps", rng.choice((0, 1, 5, 20)), "--start-radius", "1", "--rasters", "csv",
                    "--output", "out", "--quiet").ended_well()
    if not (bench.attempt / "out").exists():
        return
    table = lambda path: list(csv.DictReader(l for l in path.read_text().splitlines() if not l.startswith("#")))
    measured = [(int(r["x"]), int(r["y"]), float(r["value"])) for r in table(bench.attempt / "out/measurements.csv")]
    used = max([1.5 * steepest] + [float(r["lipschitz"]) for r in table(bench.attempt / "out/series.csv")])
    require(used <= 1.5 * steepest * (1 + 1e-9), f"L was raised to {used} though nothing contradicts {1.5 * steepest}")
    for x, y, value in measured:
        require(value == ground[x][y], f"({x}, {y}) was felt as {value}, and is {ground[x][y]}")
    safe = {(int(float(r["x"])), int(float(r["y"]))) for r in table(bench.attempt / "out/rasters/safe.csv") if float(r["value"]) == 1}
    for x, y in cells:
        bound = max(value - used * math.dist((x, y), (u, v)) for u, v, value in measured)
        if abs(bound - threshold) > 1e-6 * max(1, abs(threshold)):
            require(((x, y) in safe) == (bound >= threshold), f"({x}, {y}) is {'' if (x, y) in safe else 'not '}certified; "
                    f"the bound is {bound}, the threshold {threshold}: {run.command}")
        require((x, y) not in safe or ground[x][y] >= threshold - 1e-9, f"unsafe ground is certified at ({x}, {y})")


def drawn_table(rng, path):
    n = rng.choice((30, 80, 300))
    effect = rng.uniform(-1, 1)
    with open(path, "w") as out:
        out.write("a,b,t,y\n")
        for _ in range(n):
            a, b = rng.gauss(0, 1), rng.choice(("p", "q", "r"))
            if rng.random() < 0.2:
                a = round(a)  # ties
            t = rng.expovariate(math.exp(0.5 * effect * a)) + 0.1
            y = rng.random() < 1 / (1 + math.exp(-effect * a - 0.3 * (b == "q")))
            out.write(f"{a!r},{b},{round(t, rng.choice((1, 6)))},{int(y)}\n")


def against_r(bench, rng):
    """Coefficients, standard errors, curves, C and AUC of a drawn table, as R has them."""
    if not shutil.which("Rscript"):
        raise Skipped("no R")
    drawn_table(rng, bench.attempt / "table.csv")
    (bench.attempt / "ask.R").write_text(R_SCRIPT)
    run = subprocess.run(["Rscript", "--vanilla", "ask.R", "table.csv"], cwd=bench.attempt, capture_output=True, text=True)
    if run.returncode != 0:
        raise Skipped("R has no package survival") if "no package called" in run.stderr else OSError(run.stderr[-400:])
    answers = {line.split()[0]: [float(v) for v in line.split()[1:]] for line in run.stdout.splitlines()}

    def fit(kind, formula, *words):
        done = bench.run("fit", kind, "--data", "table.csv", "--formula", formula, "--format", "json", "--quiet", *words)
        done.ended_well({0})
        return json.loads(done.out)

    def column(table, name):
        return [row[name] for row in table]

    for kind, formula in (("glm", "y ~ a + b"), ("cox", "Surv(t, y) ~ a + b")):
        rows = fit(kind, formula)["coefficients"]
        near(column(rows, "estimate") + column(rows, "std.error"), answers[kind], kind, 1e-5)
    near([fit("concordance", "Surv(t, y) ~ a")["concordance"][0]["estimate"]], answers["concordance"], "concordance", 1e-10)
    auc = fit("roc", "y ~ a")["auc"][0]["estimate"]
    near([auc], answers["roc"], "roc", 1e-10)
    curve = fit("km", "Surv(t, y) ~ 1", "--times", "0.5,1,2")
    near(column(curve["times"], "estimate"), answers["km"], "km", 1e-10)


def near(ours, theirs, what, tolerance):
    require(len(ours) == len(theirs), f"{what}: {len(ours)} numbers, R has {len(theirs)}")
    if None in ours:  # runs to infinity; R stops somewhere on the way
        return require(max(map(abs, theirs)) > 5, f"{what}: no estimate where R has {theirs}")
    for a, b in zip(ours, theirs):
        require(abs(a - b) <= tolerance * max(1.0, abs(b)), f"{what}: {a}, R has {b}")


KINDS = (certificate, terrain, widest_path, against_r, certificate, witness)


def attempt(bench, rng, number):
    KINDS[number % len(KINDS)](bench, rng)


def short(bench):
    for number in range(12):
        yield lambda rng, number=number: attempt(bench, rng, number)
