"""What every attack needs: a place of its own, a run that is limited and measured, trees to compare."""
import hashlib
import os
import random
import resource
import shlex
import shutil
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

# What the help lists; 4 to 8 are the ends of 'explore'.
DOCUMENTED = frozenset(range(9)) | {65, 66, 71, 73}
MEBIBYTE = 1 << 20


class Broken(Exception):
    """A property that does not hold."""


class Skipped(Exception):
    """What cannot be tried on this machine, and why."""


def require(holds, what):
    if not holds:
        raise Broken(what)


@dataclass
class Run:
    command: str
    code: int  # less than 0: the signal that ended it
    out: bytes
    err: bytes
    seconds: float

    def words(self):
        return f"'{self.command}' ended with {self.code}; it said: {self.err[-600:].decode(errors='replace')}"

    def ended_well(self, codes=DOCUMENTED):
        """A documented end, and no fault of the tool's own."""
        require(self.code in codes, f"an end that is not documented here: {self.words()}")
        require(b"internal error" not in self.err, f"an internal error: {self.words()}")
        return self


def tree(folder):
    """All that is below a folder: path -> digest, link target or kind."""
    folder = Path(folder)
    found = {}
    for place, folders, files in os.walk(folder):
        for name in folders + files:
            path = Path(place, name)
            key = str(path.relative_to(folder))
            if path.is_symlink():
                found[key] = "-> " + os.readlink(path)
            elif path.is_dir():
                found[key] = "folder"
            elif path.is_file():
                found[key] = hashlib.sha256(path.read_bytes()).hexdigest()
            else:
                found[key] = "special"
    return found


def digest(path):
    """Of a file or a tree; None where nothing is."""
    path = Path(path)
    if path.is_dir() and not path.is_symlink():
        return tree(path)
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else None


def require_same(before, after, what):
    for path in sorted(set(before) | set(after)):
        if before.get(path) != after.get(path):
            change = "new" if path not in before else "gone" if path not in after else "changed"
            raise Broken(f"{what}: {path} is {change}")


class Bench:
    """The tool, a folder `place` for material, and one for the attempt that is being made."""

    def __init__(self, tcert, root, place, options):
        self.tcert = str(tcert)
        self.root = Path(root)  # of the sources
        self.place = Path(place)
        self.options = options
        self.made = self.place / "made"
        self.attempt = self.place / "attempt"
        self.memory = {}
        self.commands = []
        self.worst_s = self.peak_mib = 0.0
        self.executions = 0

    def begin(self, group, seed, number):
        """A fresh folder; random draws that depend on nothing but group, seed and number."""
        self.clear()
        self.attempt.mkdir(parents=True)
        self.made.mkdir(parents=True, exist_ok=True)
        for folder in ("tmp", "home", "cache"):
            (self.attempt / folder).mkdir()
        self.commands = []
        self.worst_s = self.peak_mib = 0.0
        self.executions = 0
        return random.Random(f"{seed}/{group}/{number}")

    def clear(self):
        for place, folders, _ in os.walk(self.attempt):
            for folder in folders:
                if not Path(place, folder).is_symlink():
                    os.chmod(Path(place, folder), 0o755)
        shutil.rmtree(self.attempt, ignore_errors=True)

    def once(self, name, make):
        """What is made once a campaign: `make(folder)` fills the folder made/NAME."""
        folder = self.made / name
        if name not in self.memory:
            if not folder.exists():
                unfinished = self.made / f".{name.replace('/', '.')}"
                shutil.rmtree(unfinished, ignore_errors=True)
                unfinished.mkdir(parents=True)
                make(unfinished)
                folder.parent.mkdir(parents=True, exist_ok=True)
                unfinished.rename(folder)
            self.memory[name] = folder
        return folder

    def environment(self, changes=None):
        env = {"PATH": os.environ["PATH"], "HOME": str(self.attempt / "home"), "TMPDIR": str(self.attempt / "tmp"),
               "XDG_CACHE_HOME": str(self.attempt / "cache")}
        for name, value in (changes or {}).items():
            if value is None:
                env.pop(name, None)
            else:
                env[name] = value
        return env

    def start(self, words, cwd=None, env=None, limits=None, before=None, **streams):
        """Starts the tool with `words`. `limits` are resource limits; `before` runs in the child."""
        def prepare():
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            for which, value in (limits or {}).items():
                resource.setrlimit(which, (value, value))
            if before:
                before()

        self.commands.append(" ".join([f"cd {shlex.quote(str(cwd or self.attempt))};"] +
                                      [f"{k}={shlex.quote(v)}" for k, v in (env or {}).items() if v is not None] +
                                      ["tcert"] + [shlex.quote(str(w)) for w in words]))
        return subprocess.Popen([self.tcert, *map(str, words)], cwd=cwd or self.attempt, env=self.environment(env),
                                preexec_fn=prepare, **streams)

    def end(self, process, seconds):
        """Waits, at most so long; notes time and memory. What then still runs is a property that failed."""
        began = time.monotonic()
        while True:
            pid, status, used = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() - began > seconds:
                os.kill(process.pid, signal.SIGKILL)
                os.wait4(process.pid, 0)
                process.returncode = -9
                raise Broken(f"still running after {seconds} s: {self.commands[-1]}")
            time.sleep(min(0.02, 0.001 + 0.05 * (time.monotonic() - began)))
        process.returncode = os.waitstatus_to_exitcode(status)
        self.peak_mib = max(self.peak_mib, used.ru_maxrss / 1024)
        return process.returncode

    def run(self, *words, seconds=60, stdin=b"", stdout=None, stderr=None, **how):
        """Runs the tool to its end. `stdout` and `stderr` are open files in the place of those that are read back."""
        with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as said, tempfile.TemporaryFile() as warned:
            given.write(stdin)
            given.seek(0)
            began = time.monotonic()
            process = self.start(words, stdin=given, stdout=stdout or said, stderr=stderr or warned, **how)
            code = self.end(process, seconds)
            took = time.monotonic() - began
            self.worst_s = max(self.worst_s, took)
            said.seek(0)
            warned.seek(0)
            return Run(self.commands[-1], code, said.read(), warned.read(), took)

    def make(self, *words, **how):
        """Runs what must succeed."""
        return self.run(*words, **how).ended_well({0})


def leftovers(*folders):
    """Unfinished results, which the tool calls '.NAME.*.tmp'; a recording that had no place is kept for people."""
    return sorted(str(p) for folder in folders for p in Path(folder).rglob("*.tmp") if not p.name.endswith(".kept.tmp"))


def copy(source, target):
    """A copy of a file or a tree, links kept."""
    source, target = Path(source), Path(target)
    if source.is_dir():
        shutil.copytree(source, target, symlinks=True)
    else:
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, target)
    return target
