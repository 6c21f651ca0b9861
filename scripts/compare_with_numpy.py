"""The published update done directly: refit, predict every cell, sets, expanders by all pairs.

Per update, as specified: K + noise factorised anew; mean and deviation of all cells from the full
cells x n kernel matrix; S = {l > h}; candidates wider than the maximisers; candidates by distance to
the goal, each tested against every cell outside S until 40 expanders are found.
"""
import json
import resource
import sys
import time

import numpy as np

ROWS, COLUMNS, H, BETA, LIPSCHITZ, EXPANDERS = 600, 400, 1000.0, 3.0, 0.003, 40
VARIANCE, LENGTH, NOISE = 2.0, 30.0, 1.0


def kernel(a, b):
    d2 = (a[:, None, 0] - b[None, :, 0]) ** 2 + (a[:, None, 1] - b[None, :, 1]) ** 2
    return VARIANCE * np.exp(-0.5 * d2 / LENGTH**2)


def step(cells, x, y, goal):
    factor = np.linalg.cholesky(kernel(x, x) + NOISE * np.eye(len(x)))
    cross = kernel(cells, x)
    weights = np.linalg.solve(factor.T, np.linalg.solve(factor, y))
    mean = cross @ weights
    v = np.linalg.solve(factor, cross.T)
    deviation = np.sqrt(np.maximum(VARIANCE - (v**2).sum(0), 1e-15))
    lower, upper = mean - BETA * deviation, mean + BETA * deviation
    width = upper - lower
    safe = lower > H
    if not safe.any():
        return None
    maximisers = safe & (upper >= lower[safe].max())
    candidates = np.flatnonzero(safe & ~maximisers & (width > width[maximisers].max()))
    order = candidates[np.argsort(((cells[candidates] - goal) ** 2).sum(1))]
    outside = cells[~safe]
    found = []
    for c in order:
        d = np.sqrt(((outside - cells[c]) ** 2).sum(1))
        if (upper[c] - LIPSCHITZ * d >= H).any():
            found.append(c)
            if len(found) == EXPANDERS:
                break
    return max(found, key=lambda c: width[c]) if found else None


def main():
    n = int(sys.argv[1])
    ours = json.load(open(sys.argv[2]))
    random = np.random.RandomState(0)
    gi, gj = np.meshgrid(np.arange(ROWS), np.arange(COLUMNS), indexing="ij")
    cells = np.c_[gi.ravel(), gj.ravel()].astype(float)
    x = np.c_[random.randint(0, ROWS, n), random.randint(0, COLUMNS, n)].astype(float)
    y = 1000.0 + 300.0 * np.sin(x[:, 0] / 70.0) * np.cos(x[:, 1] / 70.0)
    direct = {}
    for at in sorted({50, n // 2, n}):
        wall, cpu = time.perf_counter(), time.process_time()
        step(cells, x[:at], y[:at], np.array([300.0, 200.0]))
        direct[at] = (1e3 * (time.perf_counter() - wall), 1e3 * (time.process_time() - cpu))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print("rules,n,median_ms,p99_ms,median_cpu_ms,p99_cpu_ms,model_mb,peak_mb")
    for run in (run for run in ours if "rules" in run):
        for b in run["blocks"]:
            print(
                f"{run['rules']},{b['n']},{b['median_ms']},{b['p99_ms']},{b['median_cpu_ms']},"
                f"{b['p99_cpu_ms']},{run['model_mb']},{run['peak_mb']}"
            )
    for at, (wall, cpu) in direct.items():
        print(f"numpy direct,{at},{wall:.0f},,{cpu:.0f},,,{memory:.0f}")
    last = ours[0]["blocks"][-1]
    print(
        f"# at n = {n}: {direct[n][0] / last['median_ms']:.0f} times faster by the clock, "
        f"{direct[n][1] / last['median_cpu_ms']:.0f} times by processor time"
    )


main()
