"""The live loop: garbage among ticks, signals, disks that fill up, producers that come and go, clocks that jump.

Ticks that are good give the rows of an undisturbed run, byte for byte; what is not a tick is skipped and
said; the loop goes on, and ends when it is told to."""
import os
import re
import resource
import signal
import socket
import threading
import time

from .bench import Broken, require
from .hostile import NUMBERS
from .material import TICKS, results

TRIALS = ("t0000000", "t0000001", "t0000002")


def ticks_of(bench, rng):
    """Comment, header and lines of a trial's ticks."""
    lines = (results(bench) / TICKS.replace("t0000000", rng.choice(TRIALS))).read_bytes().splitlines(keepends=True)
    return lines[:2], lines[2:]


def live(bench, *words):
    return ["live", "--bundle", results(bench) / "tree/corpus", *words]


def rows_of(bench, head, ticks, words):
    """What an undisturbed run writes."""
    return bench.run(*live(bench, *words), stdin=b"".join(head + ticks)).ended_well({0}).out.splitlines(keepends=True)


def garbage_line(rng, tick):
    cells = tick.rstrip(b"\n").split(b",")
    kind = rng.randrange(7)
    if kind == 0:
        return bytes(rng.choice([b for b in range(256) if b not in (10, 13)]) for _ in range(rng.randint(1, 300))) + b"\n"
    if kind == 1:
        return b",".join(cells[:rng.randrange(1, len(cells))]) + b"\n"
    if kind == 2:
        return b",".join(cells + [b"1"] * rng.randint(1, 2000)) + b"\n"
    if kind == 3:
        return b"x" * rng.choice((1000, 100000, 2000000)) + b"\n"
    if kind == 4:
        return b"," * (len(cells) - 1) + b"\n"
    if kind == 5:  # not a number where one is needed
        cells[rng.randrange(4)] = rng.choice((b"abc", b"--1", b"0x", b"1e", b"\xff", b"null", b"'", b"1;2"))
        return b",".join(cells) + b"\n"
    return rng.choice((b"{\n", b"[]\n", b'{"time_s":}\n', b"NA\n", b"\0\0\0\n", b"time_s\n", b"-,-,-\n"))


def garbage(bench, rng):
    head, ticks = ticks_of(bench, rng)
    words = rng.choice(([], ["--guards"], ["--ray-margins"], ["--monitor"], ["--risk"]))
    expected = rows_of(bench, head, ticks, words)
    mixed = list(ticks)
    for _ in range(rng.choice((1, 5, 50))):
        mixed.insert(rng.randint(1, len(mixed)), garbage_line(rng, rng.choice(ticks)))
    run = bench.run(*live(bench, *words), stdin=b"".join(head + mixed)).ended_well({3})
    require(run.out.splitlines(keepends=True) == expected, f"garbage changed the rows: {run.words()}")


def clock_jumps(bench, rng):
    """Times that go back are refused, those that leap are a break; T_t of a trial never falls."""
    head, ticks = ticks_of(bench, rng)
    jumped = []
    offset = 0.0
    for tick in ticks:
        time_s, rest = tick.split(b",", 1)
        if rng.random() < 0.02:
            offset = rng.choice((0.0, -5.0, 5.0, 1e6, -1e6, 1e9, 1.7e9))
        said = rng.choice(NUMBERS).encode() if rng.random() < 0.01 else repr(float(time_s) + offset).encode()
        jumped.append(said.replace(b"\n", b"") + b"," + rest)
    run = bench.run(*live(bench), stdin=b"".join(head + jumped)).ended_well({0, 3})
    rows = run.out.decode().splitlines()
    rows = [row for row in rows if not row.startswith("#")]
    names = rows[0].split(",")
    require(len(rows) - 1 <= len(ticks), f"more rows than ticks: {run.words()}")
    certificate, at = float("-inf"), names.index("certificate_m")
    before = float("-inf")
    for row in rows[1:]:
        cells = row.split(",")
        now = float(cells[at]) if cells[at] else float("-inf")
        require(now >= certificate, f"T fell at {cells[0]}: {run.words()}")
        certificate = now
        require(float(cells[0]) > before or "bad_input" in row, f"a time that does not increase, {cells[0]}: {run.words()}")
        before = max(before, float(cells[0]))


def odd_values(bench, rng):
    """Cells of any number: each tick has its row or is refused; T_t and V_t are numbers or nothing."""
    head, ticks = ticks_of(bench, rng)
    spoiled = []
    for tick in ticks:
        if rng.random() < 0.05:
            cells = tick.rstrip(b"\n").split(b",")
            cells[rng.randrange(1, len(cells))] = rng.choice([n for n in NUMBERS if "," not in n]).encode()
            tick = b",".join(cells) + b"\n"
        spoiled.append(tick)
    words = rng.choice(([], ["--guards", "--monitor", "--risk"], ["--set", "clearance=swept"]))
    run = bench.run(*live(bench, *words), stdin=b"".join(head + spoiled)).ended_well({0, 3})
    rows = [row.split(",") for row in run.out.decode().splitlines() if not row.startswith("#")]
    at = [rows[0].index(name) for name in ("certificate_m", "corridor_value_m", "speed_law_mps")]
    for row in rows[1:]:
        for k in at:
            require(row[k] == "" or float(row[k]) == float(row[k]), f"{rows[0][k]} is {row[k]}: {run.words()}")


class Running:
    """A loop that is fed through a pipe or a socket."""

    def __init__(self, bench, *words, stdin=None):
        self.bench = bench
        self.out = open(bench.attempt / "rows.csv", "wb")
        self.err = open(bench.attempt / "words.txt", "wb")
        self.began = time.monotonic()
        self.process = bench.start(live(bench, *words), stdin=stdin, stdout=self.out, stderr=self.err)

    def rows(self):
        return (self.bench.attempt / "rows.csv").read_bytes().splitlines(keepends=True)

    def wait_for(self, holds, what, seconds=20):
        ends = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > ends:
                self.stop(signal.SIGKILL)
                raise Broken(f"{what} did not happen within {seconds} s; it said: {self.words()}")
            time.sleep(0.005)

    def words(self):
        return (self.bench.attempt / "words.txt").read_bytes()[-600:].decode(errors="replace")

    def stop(self, which=None):
        if which:
            self.process.send_signal(which)
        code = self.bench.end(self.process, 20)
        self.bench.worst_s = max(self.bench.worst_s, time.monotonic() - self.began)
        self.out.close()
        self.err.close()
        return code


def signals(bench, rng):
    """Told to end in the middle: the rows are the beginning of all, and the record holds their ticks."""
    head, ticks = ticks_of(bench, rng)
    expected = rows_of(bench, head, ticks, [])
    reading, writing = os.pipe()
    running = Running(bench, "--record", bench.attempt / "record", "--audit", bench.attempt / "audit.csv", stdin=reading)
    os.close(reading)
    count = rng.randint(1, len(ticks))
    which = rng.choice((signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL, None))
    with os.fdopen(writing, "wb") as pipe:
        pipe.write(b"".join(head + ticks[:count]))
        pipe.flush()
        running.wait_for(lambda: len(running.rows()) >= count, f"rows of {count} ticks")
        if which is None and rng.random() < 0.5:
            pipe.write(ticks[-1][: rng.randrange(1, len(ticks[-1]))])  # and ends within a line
            pipe.flush()
        if which:
            code = running.stop(which)
    if which is None:
        code = running.stop()
    rows = running.rows()
    require(rows == expected[:len(rows)] or which is None, f"other rows than undisturbed; {which}: {running.words()}")
    require(len(rows) >= count, f"rows were lost; {which}: {running.words()}")
    if which in (signal.SIGTERM, signal.SIGINT, None):
        require(code in (0, 3), f"it ended with {code} on {which}: {running.words()}")
        recorded = bench.attempt / "record"
        require(recorded.is_dir(), f"no record after {which}: {running.words()}")
        again = bench.run("certify", recorded, "--output", bench.attempt / "again").ended_well({0, 3})
        series = next((bench.attempt / "again/series").glob("*.csv"), None)
        require(series is not None, f"the record does not read back: {again.words()}")


def full_disk(bench, rng):
    """Rows, audit or record meet a full disk: ticks go on being certified, it is said and the code is 73."""
    head, ticks = ticks_of(bench, rng)
    expected = rows_of(bench, head, ticks, ["--guards"])
    audit, record = ["--audit", bench.attempt / "audit.csv"], ["--record", bench.attempt / "record"]
    if rng.random() < 0.3:
        with open("/dev/full", "wb") as full:
            run = bench.run(*live(bench, "--guards", *record), stdin=b"".join(head + ticks), stdout=full).ended_well({73})
        return require(b"stdout" in run.err, f"it does not say where: {run.words()}")
    limit = rng.choice((0, 512, 1024, 8192, 20000))
    reading, writing = os.pipe()
    with os.fdopen(writing, "wb") as pipe:
        chunks = []
        reader = threading.Thread(target=lambda: chunks.extend(iter(lambda: os.read(reading, 65536), b"")))
        reader.start()
        try:
            run = bench.run(*live(bench, "--guards", *rng.choice((audit, record, audit + record))), stdin=b"".join(head + ticks),
                            stdout=pipe, limits={resource.RLIMIT_FSIZE: limit})
        finally:
            pipe.close()
            reader.join()
            os.close(reading)
    run.ended_well({0, 73})
    got = b"".join(chunks).splitlines(keepends=True)
    # If nothing could be written from the start on, it says so and begins nothing.
    require(got == expected or (run.code == 73 and not got), f"rows were lost to another file's disk: {run.words()}")


def reconnects(bench, rng):
    """Producers on a socket that come, stop within a line and go: every whole tick has its row."""
    head, ticks = ticks_of(bench, rng)
    place = bench.attempt / "socket"
    running = Running(bench, "--listen", f"unix:{place}", "--slow-consumer", "wait")
    running.wait_for(place.exists, "the socket")
    sent = at = 0
    for _ in range(rng.choice((1, 3, 20))):
        with socket.socket(socket.AF_UNIX) as producer:
            producer.connect(str(place))
            producer.sendall(b"".join(head))
            some = ticks[at: at + rng.randint(0, 40)]
            at += len(some)
            sent += len(some)
            producer.sendall(b"".join(some))
            kind = rng.randrange(4)
            if kind == 0 and at < len(ticks):
                producer.sendall(ticks[at][:-8])  # never ended
            elif kind == 1:
                producer.sendall(garbage_line(rng, ticks[0])[:5000])
        at = min(at + 1, len(ticks))
    running.wait_for(lambda: len([r for r in running.rows() if not r.startswith((b"#", b"time_s"))]) >= sent, f"rows of {sent} ticks")
    code = running.stop(rng.choice((signal.SIGTERM, signal.SIGINT)))
    require(code in (0, 3), f"it ended with {code}: {running.words()}")
    require(not place.exists(), "the socket was left")


def datagrams(bench, rng):
    """Lines on UDP, some of them garbage: it goes on, and ends when told to."""
    head, ticks = ticks_of(bench, rng)
    running = Running(bench, "--listen", "udp:0")
    port = []

    def said():
        found = re.search(rb"udp:127\.0\.0\.1:(\d+)", (bench.attempt / "words.txt").read_bytes())
        port[:] = [int(found.group(1))] if found else []
        return bool(found)

    running.wait_for(said, "the port")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as producer:
        producer.sendto(b"".join(head), ("127.0.0.1", port[0]))
        for k, tick in enumerate(ticks[:200]):
            producer.sendto(tick, ("127.0.0.1", port[0]))
            if rng.random() < 0.2:
                producer.sendto(garbage_line(rng, tick)[:9000], ("127.0.0.1", port[0]))
            if k % 20 == 19:
                time.sleep(0.002)
    running.wait_for(lambda: len(running.rows()) > 20, "rows")
    code = running.stop(signal.SIGTERM)
    require(code in (0, 3), f"it ended with {code}: {running.words()}")


KINDS = (garbage, signals, clock_jumps, full_disk, odd_values, reconnects, garbage, signals, odd_values, datagrams)


def attempt(bench, rng, number):
    KINDS[number % len(KINDS)](bench, rng)


def short(bench):
    for number in range(40):
        yield lambda rng, number=number: attempt(bench, rng, number)
