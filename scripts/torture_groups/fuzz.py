"""Readers, the core's update, proofs and the like under libFuzzer, a target and some seconds an attempt.

Inputs that cover anew are kept below corpus/TARGET and are where the next attempt begins; those that break
a property are kept as any failure. Executions are what is counted."""
import os
import re
import shutil
import subprocess
import time

from .bench import Broken, Run, Skipped
from .hostile import spoiled

SECONDS = 20


def targets(bench):
    return sorted(p.name for p in bench.options.fuzzers.glob("fuzz_*") if os.access(p, os.X_OK) and p.is_file())


def is_libfuzzer(program):
    return b"libFuzzer" in subprocess.run([program, "-help=1"], capture_output=True).stderr


def limited(bench, command, seconds):
    bench.commands.append(" ".join(map(str, command)))
    began = time.monotonic()
    with open(bench.attempt / "said.txt", "wb") as said:
        process = subprocess.Popen(command, stdout=said, stderr=said, cwd=bench.attempt)
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
    bench.memory.setdefault("executions", {}).setdefault(name, 0)
    bench.memory["executions"][name] += bench.executions
    # libFuzzer counts its own memory; that of the process was noted.
    if run.code != 0:
        raise Broken(f"{name}: {run.err[-1500:].decode(errors='replace')}")


def by_spoiled_files(bench, rng, program):
    """Without libFuzzer: the kept corpus, spoiled at random, through the program that replays files."""
    name = program.name.removeprefix("fuzz_")
    kept = sorted((bench.root / "tests/fuzz/corpus" / name).glob("*"))
    inputs = bench.attempt / "inputs"
    inputs.mkdir()
    count = 50 if bench.options.short else 1000
    for k in range(count):
        data = rng.choice(kept).read_bytes() if kept else rng.randbytes(rng.randint(0, 2000))
        (inputs / str(k)).write_bytes(spoiled(rng, data))
    run = limited(bench, [program, inputs], 120)
    bench.executions = count
    if run.code != 0:
        raise Broken(f"{name}, one of these inputs: {run.err[-1500:].decode(errors='replace')}")
    shutil.rmtree(inputs)


def attempt(bench, rng, number):
    known = targets(bench)
    if not known:
        raise Skipped(f"no fuzz targets in {bench.options.fuzzers}: cmake --preset fuzz && cmake --build --preset fuzz")
    program = bench.options.fuzzers / known[number % len(known)]
    key = f"is libFuzzer: {program.name}"
    if key not in bench.memory:
        bench.memory[key] = is_libfuzzer(program)
    (by_libfuzzer if bench.memory[key] else by_spoiled_files)(bench, rng, program)


def short(bench):
    """Replays spoiled inputs through every target that was built, of whatever build."""
    for number in range(max(1, len(targets(bench)))):
        yield lambda rng, number=number: attempt(bench, rng, number)
