"""Draws attempts from the groups in turn, counts what held, keeps what did not, and can go on later."""
import json
import shutil
import sys
import time
import traceback
from pathlib import Path

from .bench import Bench, Broken, Skipped
from . import differential, environment, fuzz, hostile, kill, live, tamper

GROUPS = {"kill": kill, "environment": environment, "hostile": hostile, "tamper": tamper, "live": live, "fuzz": fuzz,
          "differential": differential}
MOST_KEPT = 20  # folders of failures a group


def fresh_count():
    return {"next": 0, "tried": 0, "held": 0, "failed": 0, "skipped": 0, "spent_s": 0.0, "worst_s": 0.0, "peak_mib": 0.0,
            "failures": [], "not_tried": []}


class Campaign:
    def __init__(self, options):
        self.options = options
        self.place = Path(options.output).resolve()
        self.state_file = self.place / "state.json"
        self.state = {"seed": options.seed, "groups": {}}
        if self.state_file.exists():
            self.state = json.loads(self.state_file.read_text())
            if self.state["seed"] != options.seed:
                sys.exit(f"torture: {self.place} holds a campaign of seed {self.state['seed']}; go on with it, or give "
                         "another --output")
        if options.short or options.attempt is not None:  # both are judged alone; an attempt is not even counted
            self.state["groups"] = {}
        self.place.mkdir(parents=True, exist_ok=True)
        self.bench = Bench(options.tcert, options.root, self.place, options)

    def count_of(self, group):
        return self.state["groups"].setdefault(group, fresh_count())

    def save(self):
        unfinished = self.state_file.with_suffix(".unfinished")
        unfinished.write_text(json.dumps(self.state, indent=1) + "\n")
        unfinished.rename(self.state_file)

    def keep(self, group, number, why):
        """Says what failed and keeps its folder, with the commands that led there."""
        folder = self.place / "kept" / f"{group}-{number}"
        shutil.rmtree(folder, ignore_errors=True)
        if len(self.count_of(group)["failures"]) < MOST_KEPT:
            folder.parent.mkdir(exist_ok=True)
            shutil.copytree(self.bench.attempt, folder, symlinks=True, ignore_dangling_symlinks=True)
            (folder / "commands.txt").write_text("\n".join(self.bench.commands) + "\n")
        again = f"scripts/torture --group {group} --seed {self.state['seed']} --attempt {number}"
        if self.options.short:
            again += " --short"
        failure = {"attempt": number, "why": why, "again": again, "kept": str(folder)}
        self.count_of(group)["failures"].append(failure)
        last = self.bench.commands[-1] if self.bench.commands else "none"
        print(f"torture: FAILED: {group}, seed {self.state['seed']}, attempt {number}: {why}\n"
              f"  last command: {last}\n  kept: {folder}\n  again: {again}", file=sys.stderr, flush=True)

    def one(self, group, number, attack):
        """One attempt; its verdict in the counts."""
        count = self.count_of(group)
        began = time.monotonic()
        rng = self.bench.begin(group, self.state["seed"], number)
        executions = 1
        try:
            attack(rng)
            verdict = "held"
        except Skipped as why:
            verdict = "skipped"
            if str(why) not in count["not_tried"]:
                count["not_tried"].append(str(why))
        except Broken as why:
            verdict = "failed"
            self.keep(group, number, str(why))
        except Exception as fault:  # an answer that cannot be understood is none
            verdict = "failed"
            self.keep(group, number, f"the attack itself failed: {fault!r} {traceback.format_exc(limit=-3)}")
        if self.bench.executions:
            executions = self.bench.executions
        if verdict != "skipped":
            count["tried"] += executions
            count["held"] += executions - (verdict == "failed")
            count["failed"] += verdict == "failed"
        count["skipped"] += verdict == "skipped"
        count["spent_s"] += time.monotonic() - began
        count["worst_s"] = max(count["worst_s"], self.bench.worst_s)
        count["peak_mib"] = max(count["peak_mib"], self.bench.peak_mib)
        count["next"] = max(count["next"], number + 1)

    def run_short(self):
        for group in self.options.group:
            for number, attack in enumerate(GROUPS[group].short(self.bench)):
                if self.options.attempt in (None, number):
                    self.one(group, number, attack)

    def run_attempt(self):
        for group in self.options.group:
            self.one(group, self.options.attempt, self.attack(group, self.options.attempt))

    def attack(self, group, number):
        return lambda rng: GROUPS[group].attempt(self.bench, rng, number)

    def run_minutes(self):
        """The group that has had the least time comes next."""
        ends = time.monotonic() + 60 * self.options.minutes
        spent = dict.fromkeys(self.options.group, 0.0)
        while time.monotonic() < ends:
            group = min(spent, key=spent.get)
            began = time.monotonic()
            number = self.count_of(group)["next"]
            self.one(group, number, self.attack(group, number))
            spent[group] += max(1.0, time.monotonic() - began)  # so that what cannot be tried is not tried all the time
            self.save()

    def table(self):
        columns = ("group", "tried", "held", "failed", "skipped", "worst s", "peak MiB")
        rows = [columns]
        for group in self.options.group:
            c = self.count_of(group)
            rows.append((group, f"{c['tried']:,}", f"{c['held']:,}", str(c["failed"]), str(c["skipped"]),
                         f"{c['worst_s']:.1f}", f"{c['peak_mib']:.0f}"))
        widths = [max(len(row[i]) for row in rows) for i in range(len(columns))]
        lines = ["  ".join(cell.ljust(w) if i == 0 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
                 for row in rows]
        lines.insert(1, "  ".join("-" * w for w in widths))
        for group in self.options.group:
            lines += [f"not tried ({group}): {why}" for why in self.count_of(group)["not_tried"]]
        return "\n".join(lines)

    def run(self):
        if self.options.short:
            self.run_short()
        elif self.options.attempt is not None:
            self.run_attempt()
        else:
            self.run_minutes()
        self.bench.clear()
        if self.options.attempt is None:
            self.save()
            (self.place / "table.json").write_text(json.dumps(
                {"seed": self.state["seed"], "groups": {g: self.count_of(g) for g in self.options.group}}, indent=1) + "\n")
        print(self.table())
        return int(any(self.count_of(g)["failed"] for g in self.options.group))
