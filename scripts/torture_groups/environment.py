"""Surroundings in which things go wrong: closed streams, too little of something, odd folders and words.

Whatever they are, the tool ends with a documented code. Either the result is the one of an undisturbed
run, or nothing is there, or what was there before; nothing unfinished is left, and nothing beside it
changed."""
import contextlib
import os
import resource
import shutil
import signal
import subprocess

from .bench import MEBIBYTE, Skipped, digest, leftovers, require, require_same, tree
from .material import COMMANDS, SHORT_COMMANDS, Job

SLOW = ("page.html", "everything", "figures")


def closed_streams(bench, rng):
    which = rng.sample((0, 1, 2), rng.randint(1, 3))

    def before():
        for descriptor in which:
            os.close(descriptor)
    return {"before": before}


def full_stream(bench, rng):
    return {rng.choice(("stdout", "stderr")): open("/dev/full", "wb")}


def few_descriptors(bench, rng):
    return {"limits": {resource.RLIMIT_NOFILE: rng.randint(3, 40)}}


def little_memory(bench, rng):
    return {"limits": {resource.RLIMIT_AS: rng.choice((30, 60, 100, 150, 250, 400, 1000)) * MEBIBYTE}}


def short_files(bench, rng):
    return {"limits": {resource.RLIMIT_FSIZE: rng.choice((0, 1, 512, 4096, 16384, 65536, rng.randint(0, 300000)))}}


def small_stack(bench, rng):
    return {"limits": {resource.RLIMIT_STACK: rng.choice((256 << 10, 512 << 10, MEBIBYTE, 2 * MEBIBYTE))}}


def odd_folder(bench, rng):
    file, locked = bench.attempt / "file", bench.attempt / "locked"
    file.write_text("mine")
    locked.mkdir(mode=0o500)
    place = rng.choice((None, "", ".", "/nowhere/at/all", str(file), str(file / "below"), str(locked), "relative",
                        "/proc/none", "/dev/null", str(bench.attempt / "new\nline"), "~", "x" * 5000))
    return {"env": {rng.choice(("HOME", "TMPDIR", "XDG_CACHE_HOME")): place}}


def odd_words(bench, rng):
    word = rng.choice(("de_DE.UTF-8", "tr_TR.UTF-8", "C", "POSIX", "C.UTF-8", "ar_SA", "no such locale", "\x1b[31m", ""))
    return {"env": {rng.choice(("LC_ALL", "LANG", "LC_NUMERIC", "TZ", "COLUMNS", "TERM", "LANGUAGE", "NO_COLOR")): word}}


def odd_mask(bench, rng):
    mask = rng.choice((0o000, 0o077, 0o277))
    return {"before": lambda: os.umask(mask)}


def ignored_signals(bench, rng):
    def before():
        for which in (signal.SIGPIPE, signal.SIGXFSZ, signal.SIGTERM, signal.SIGINT, signal.SIGCHLD):
            signal.signal(which, rng.choice((signal.SIG_IGN, signal.SIG_DFL)))
    return {"before": before}


def broken_pipe(bench, rng):
    reading, writing = os.pipe()
    os.close(reading)
    return {rng.choice(("stdout", "stderr")): os.fdopen(writing, "wb")}


SURROUNDINGS = (closed_streams, full_stream, few_descriptors, little_memory, short_files, small_stack, odd_folder,
                odd_words, odd_mask, ignored_signals, broken_pipe)
# These ask for nothing that could be short, so that the result must be there.
HARMLESS = (odd_words, odd_mask, ignored_signals)


def draw_job(bench, rng):
    commands = SHORT_COMMANDS if bench.options.short else [c for c in COMMANDS if c[0] not in SLOW or rng.random() < 0.1]
    name = rng.choice(commands)
    if name[0] == "page.html" and not bench.options.has_page:
        raise Skipped("a build without the page")
    return Job(bench, name)


def judge(bench, job, out, run, before, elsewhere):
    """What must be so after a run in bad surroundings."""
    loader = run.code == 127 and b"error while loading shared libraries" in run.err
    piped = run.code == -signal.SIGPIPE
    if not (loader or piped):
        run.ended_well()
    now = digest(out / job.file)
    if run.code in job.good:
        require(now == digest(job.reference() / job.file), f"another result than undisturbed: {run.words()}")
    elif job.is_tree:
        for part in (out / job.file).glob("*"):
            whole = job.reference() / job.file / part.name
            require(digest(part) == digest(whole), f"half a result, {part.name}: {run.words()}")
    elif not (job.option == "--record" and run.code == 73):
        # A recording that a full disk cut short is kept, and said to be.
        old = before.get(job.file)
        require(now == old or now in (None, {}), f"half a result, or another one: {run.words()}")
    left = leftovers(out)
    require(not left or piped or job.option == "--record", f"left over: {left[:3]}, after {run.words()}")
    require_same(elsewhere, tree(job.results), "the inputs")


def in_surroundings(bench, rng, job, surroundings):
    out = bench.attempt / "out"
    out.mkdir()
    job.reference()
    job.prepare(out)
    if rng.random() < 0.3 and not job.only_new:
        job.run(out).ended_well(job.good)
    before = {job.file: digest(out / job.file)}
    elsewhere = tree(job.results)
    how = surroundings(bench, rng)
    beside = tree(bench.attempt / "home")
    with contextlib.ExitStack() as open_files:
        for stream in ("stdout", "stderr"):
            if stream in how:
                open_files.enter_context(how[stream])
        run = job.run(out, **how)
    judge(bench, job, out, run, before, elsewhere)
    if surroundings in HARMLESS:
        require(run.code in job.good, f"harmless surroundings ({surroundings.__name__}) stopped it: {run.words()}")
    require_same(beside, {k: v for k, v in tree(bench.attempt / "home").items() if not k.startswith(".cache")}, "home")
    mine = bench.attempt / "file"
    require(not mine.exists() or mine.read_text() == "mine", "a file in the place of a folder was changed")


@contextlib.contextmanager
def mounted(place, *options):
    """A file system in memory at `place`."""
    place.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", ",".join(options), "torture", str(place)]
    if subprocess.run(command, capture_output=True).returncode != 0:
        raise Skipped("no right to mount a small disk")
    try:
        yield
    finally:
        subprocess.run(["umount", "-l", str(place)], capture_output=True)


def on_a_full_disk(bench, rng, job):
    """The output on a disk that has too little room, or cannot be written to at all."""
    reference, out = job.reference(), bench.attempt / "out"
    size = sum(p.stat().st_size for p in reference.rglob("*") if p.is_file())
    kib = max(4, int(rng.random() * 1.5 * size / 1024))
    elsewhere = tree(job.results)
    with mounted(out, f"size={kib}k", f"nr_inodes={rng.choice((5, 12, 100, 10000))}"):
        try:
            job.prepare(out)
        except OSError:
            return
        if rng.random() < 0.3:
            if subprocess.run(["mount", "-o", "remount,ro", str(out)], capture_output=True).returncode != 0:
                raise Skipped("no right to mount a disk that is read only")
        judge(bench, job, out, job.run(out), {}, elsewhere)


def through_links(bench, rng, job):
    """A link in the place of the output leads nowhere; a link to the inputs is as good as they are."""
    out, other = bench.attempt / "out", bench.attempt / "other"
    other.mkdir()
    (other / "mine").write_text("mine")
    kind = rng.choice(("output", "dangling", "place", "inputs"))
    before = tree(other)
    if kind == "inputs":
        out.mkdir()
        (bench.attempt / "linked").symlink_to(job.results)
        job.prepare(out)
        run = bench.run(*job.arguments(out), cwd=bench.attempt / "linked", stdin=job.ticks, seconds=120)
        run.ended_well(job.good)
    elif kind == "place":
        (bench.attempt / "real").mkdir()
        out.symlink_to(bench.attempt / "real")
        job.prepare(out)
        run = job.run(out).ended_well(job.good)
    else:
        out.mkdir()
        (out / job.file).symlink_to(other if kind == "output" else bench.attempt / "nothing")
        run = job.run(out).ended_well()
        require(run.code not in job.good or not (out / job.file).is_symlink(), f"it wrote through a link: {run.words()}")
    require_same(before, tree(other), "behind a link")
    require(not (bench.attempt / "nothing").exists(), f"it wrote through a dangling link: {run.words()}")
    if kind in ("inputs", "place"):
        require(digest(out / job.file) == digest(job.reference() / job.file), f"another result than without links: {run.words()}")


def two_at_once(bench, rng, job):
    """Two runs into one place: each ends well or says that it cannot, and what is there is whole."""
    out = bench.attempt / "out"
    out.mkdir()
    reference = digest(job.reference() / job.file)
    job.prepare(out)
    ticks = bench.attempt / "ticks.csv"
    ticks.write_bytes(job.ticks)
    with contextlib.ExitStack() as files:
        running = [bench.start(job.arguments(out), cwd=job.results, stdin=files.enter_context(open(ticks, "rb")),
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(2)]
        codes = [bench.end(process, 120) for process in running]
    require(all(code in job.good | {73} for code in codes) and any(code in job.good for code in codes),
            f"two at once ended with {codes}: {bench.commands[-1]}")
    require(digest(out / job.file) == reference, f"two at once left another result: {bench.commands[-1]}")
    require(not leftovers(out), f"left over: {leftovers(out)[:3]}")


def in_a_deleted_folder(bench, rng, job):
    gone = bench.attempt / "gone"
    gone.mkdir()
    words = [word.replace("tree/", f"{job.results}/tree/") for word in job.arguments(rng.choice(("here", str(bench.attempt))))]
    bench.run(*words, cwd=gone, stdin=job.ticks, before=lambda: shutil.rmtree(gone)).ended_well()


def attempt(bench, rng, number):
    job = draw_job(bench, rng)
    kind = number % 16
    if kind < 11:
        return in_surroundings(bench, rng, job, SURROUNDINGS[kind])
    if kind < 13:
        return on_a_full_disk(bench, rng, job)
    return (through_links, two_at_once, in_a_deleted_folder)[kind - 13](bench, rng, job)


def short(bench):
    for number in range(64):
        yield lambda rng, number=number: attempt(bench, rng, number)
