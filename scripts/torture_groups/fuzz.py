"""Readers, the core's update, proofs and the like under libFuzzer, a target and some seconds an attempt.

Inputs that cover anew are kept below corpus/TARGET and are where the next attempt begins; those that break
a property are kept as any failure. Executions are what is counted."""
import os
import re
import subprocess
import time

from .bench import Broken, Run, Skipped

SECONDS = 20


def targets(bench):
    return sorted(p.name for p in bench.options.fuzzers.glob("fuzz_*") if os.access(p, os.X_OK) and p.is_file())


def is_libfuzzer(program):
    return b"libFuzzer" in subprocess.run([program, "-help=1"], capture_output=True).stderr


def limited(bench, command, seconds):
    bench.commands.append(" ".join(map(str, command)))
    began = time.monotonic()
    with open(bench.attempt / "said.txt", "wb") as said:
        process = subprocess.Popen(list(map(str, command)), stdout=said, stderr=said, cwd=bench.attempt)
        code = bench.end(process, seconds)
    bench.worst_s = max(bench.worst_s, time.monotonic() - began)
    return Run(bench.commands[-1], code, b"", (bench.attempt / "said.txt").read_bytes(), time.monotonic() - began)


def by_libfuzzer(bench, rng, program):
    name = program.name.removeprefix("fuzz_")
    corpus = bench.place / "corpus" / name
    corpus.mkdir(parents=True, exist_ok=True)
    kept = bench.root / "tests/fuzz/corpus" / name
    run = limited(bench, [program, f"-max_total_time={SECONDS}", f"-seed={rng.randrange(1, 2**31)}", "-rss_limit_mb=3000",
                          "-timeout=20", "-print_final_stats=1", f"-artifact_prefix={bench.attempt}/", corpus,
                          *([kept] if kept.is_dir() else [])], SECONDS + 120)
    executions = re.search(rb"number_of_executed_units: (\d+)", run.err)
    bench.executions = int(executions.group(1)) if executions else 1
    if run.code != 0:
        raise Broken(f"{name}: {run.err[-1500:].decode(errors='replace')}")


def by_edits(bench, rng, program):
    """Without libFuzzer: inputs made of the kept corpus by edits at random, within the program."""
    name = program.name.removeprefix("fuzz_")
    kept = bench.root / "tests/fuzz/corpus" / name
    count = 1000 if bench.options.short else bench.memory.get(f"inputs of {name}", 20000)
    run = limited(bench, [program, "--spoil", rng.randrange(2**32), count, *([kept] if kept.is_dir() else [])], 300)
    bench.executions = count
    if run.code != 0:
        raise Broken(f"{name}, the input that is kept: {run.err[-1500:].decode(errors='replace')}")
    if not bench.options.short:  # about SECONDS the next time
        bench.memory[f"inputs of {name}"] = max(1000, int(count * SECONDS / max(run.seconds, 0.01)))


def attempt(bench, rng, number):
    known = targets(bench)
    if not known:
        raise Skipped(f"no fuzz targets in {bench.options.fuzzers}: cmake --preset fuzz && cmake --build --preset fuzz")
    program = bench.options.fuzzers / known[number % len(known)]
    key = f"is libFuzzer: {program.name}"
    if key not in bench.memory:
        bench.memory[key] = is_libfuzzer(program)
    (by_libfuzzer if bench.memory[key] else by_edits)(bench, rng, program)


def short(bench):
    """Every target that was built, of whatever build."""
    for number in range(max(1, len(targets(bench)))):
        yield lambda rng, number=number: attempt(bench, rng, number)
