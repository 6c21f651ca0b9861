"""Kills what writes: before each call that names a file or brings it to the disk, and at random times.

Whatever ended it, afterwards what is there is whole, the same command gives the bytes of an undisturbed
run, nothing is left over and nothing else is there, and 'verify' says that it stands."""
import os
import shutil
import signal
import time

from .bench import Broken, Skipped, digest, leftovers, require, require_same
from .material import COMMANDS, SHORT_COMMANDS, Job, inputs, results


def require_whole(job, out, when):
    """A result that is there is whole; of a tree each part is."""
    there, reference = out / job.file, job.reference() / job.file
    if not there.exists():
        return
    parts = there.iterdir() if job.is_tree else [there]
    for part in parts:
        whole = reference / part.name if job.is_tree else reference
        require(digest(part) == digest(whole), f"half a result: {part.name}, {when}")


def look(bench, job, out, when, with_verify):
    """What must be so after the kill, and after the command was run again."""
    require_whole(job, out, when)
    if job.only_new:
        shutil.rmtree(out / job.file, ignore_errors=True)
        for kept in out.glob(".record.*.kept.tmp"):  # for people to look at
            shutil.rmtree(kept)
    job.prepare(out)
    job.run(out).ended_well(job.good)
    require(digest(out / job.file) == digest(job.reference() / job.file), f"another result, {when}")
    left = leftovers(out, bench.attempt / "tmp", bench.attempt / "cache")
    require(not left, f"left over: {left[:3]}, {when}")
    require_same({job.file: 0, job.file + ".manifest.json": 0} | dict.fromkeys(os.listdir(out), 0),
                 {job.file: 0, job.file + ".manifest.json": 0}, f"something else, {when}")
    if with_verify and job.has_manifest:
        run = bench.run("verify", out / job.file, *job.inputs(), "--quiet", seconds=120)
        require(run.code == 0, f"it does not stand, {when}: {run.words()}")


def calls_of(bench, job):
    """How many calls there are to be killed at."""
    key = f"calls of {job.file}"
    if key not in bench.memory:
        counted, out = bench.attempt / "calls", bench.attempt / "counted"
        out.mkdir()
        job.prepare(out)
        job.run(out, env={"LD_PRELOAD": bench.options.kill_at, "TCERT_CALLS_TO": str(counted)}).ended_well(job.good)
        bench.memory[key] = int(counted.read_text())
        shutil.rmtree(out)
        shutil.rmtree(bench.attempt / "cache")
    return bench.memory[key]


def at_call(bench, job, out, call):
    run = job.run(out, env={"LD_PRELOAD": bench.options.kill_at, "TCERT_KILL_AT": str(call)})
    require(run.code == -signal.SIGKILL or run.code in job.good, f"another end than by the kill: {run.words()}")


def at_time(bench, job, out, rng):
    """A signal at a time drawn from how long the command takes; SIGTERM and SIGINT are asked for, not forced."""
    key = f"time of {job.file}"
    if key not in bench.memory:
        began = time.monotonic()
        scratch = bench.attempt / "timed"
        scratch.mkdir()
        job.prepare(scratch)
        job.run(scratch).ended_well(job.good)
        bench.memory[key] = time.monotonic() - began
        shutil.rmtree(scratch)
        shutil.rmtree(bench.attempt / "cache", ignore_errors=True)
    which = rng.choice((signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT))
    ticks = bench.attempt / "ticks.csv"
    ticks.write_bytes(job.ticks)
    wait = rng.random() * bench.memory[key]
    with open(ticks, "rb") as stdin, open(os.devnull, "wb") as nowhere:
        process = bench.start(job.arguments(out), cwd=job.results, stdin=stdin, stdout=nowhere, stderr=nowhere)
        time.sleep(wait)
        process.send_signal(which)
        bench.end(process, 30)
    return f"{which.name} after {wait:.3f} s"


def verify_itself(bench, rng):
    """The scratch folder of 'verify'."""
    folder = results(bench) / "tree"
    with open(os.devnull, "wb") as nowhere:
        process = bench.start(["verify", folder, "--quiet"], stdout=nowhere, stderr=nowhere)
        time.sleep(rng.random() * 0.5)
        process.send_signal(rng.choice((signal.SIGKILL, signal.SIGTERM)))
        bench.end(process, 30)
    bench.make("verify", folder, *inputs(bench), "--quiet")
    left = leftovers(bench.attempt) + os.listdir(bench.attempt / "tmp")
    require(not left, f"left over: {left[:3]}")


def attack(bench, job, rng, call, there):
    if call is not None and not bench.options.kill_at:
        raise Skipped("no library that kills at a call (--kill-at)")
    out = bench.attempt / "out"
    out.mkdir()
    job.reference()
    if call is not None:
        calls_of(bench, job)
    job.prepare(out)
    if there and not job.only_new:
        job.run(out).ended_well(job.good)
    (bench.attempt / "cache").mkdir(exist_ok=True)
    if call is None:
        when = at_time(bench, job, out, rng)
        look(bench, job, out, when, with_verify=rng.random() < 0.2)
    else:
        at_call(bench, job, out, call)
        look(bench, job, out, f"killed at call {call}", with_verify=call <= 1 or rng.random() < 0.1)


def attempt(bench, rng, number):
    if number % 12 == 11:
        return verify_itself(bench, rng)
    name, option, rest = COMMANDS[rng.randrange(len(COMMANDS))]
    if name == "page.html" and not bench.options.has_page:
        raise Skipped("a build without the page")
    job = Job(bench, (name, option, rest))
    at_a_call = number % 2 == 0
    call = rng.randint(1, calls_of(bench, job)) if at_a_call and bench.options.kill_at else None
    if at_a_call and call is None:
        raise Skipped("no library that kills at a call (--kill-at)")
    return attack(bench, job, rng, call, there=rng.random() < 0.5)


def short(bench):
    """Every call of five commands, over nothing and over what was there."""
    for command in SHORT_COMMANDS:
        job = Job(bench, command)
        bench.begin("kill", 0, 0)
        calls = calls_of(bench, job) if bench.options.kill_at else 1
        for there in (False, True):
            if there and job.only_new:
                continue
            for call in range(1, calls + 1):
                yield lambda rng, job=job, call=call, there=there: attack(bench, job, rng, call, there)
    for _ in range(2):
        yield lambda rng: verify_itself(bench, rng)
