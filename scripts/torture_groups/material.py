"""Small results of every kind that the groups attack, made once a campaign."""


def results(bench):
    """made/results: a corpus with certificates, witnesses and what follows from them, and a terrain."""
    def make(folder):
        def run(*words):
            bench.make(*words, "--quiet", cwd=folder)

        run("simulate", "--trials", "6", "--output", "tree/corpus")
        run("certify", "tree/corpus", "--ticks", "--witness", "--output", "tree/certificates")
        run("ablate", "tree/corpus", "--replicates", "20", "--no-cache", "--output", "tree/ablation")
        run("replay", "tree/corpus", "--series", "--output", "tree/replays")
        run("world", "tree/corpus/worlds/t0000000.json", "--no-curvature", "--output", "tree/truth.csv")
        run("simulate", "terrain", "--rows", "24", "--columns", "24", "--output", "terrain.csv")
        bench.run("explore", "terrain.csv", "--start", "12,12", "--lipschitz", "18", "--mode", "explore", "--max-steps",
                  "5", "--threshold", "-1e9", "--output", "tree/walk", "--quiet", cwd=folder).ended_well({0, 4})
        run("simulate", "--trials", "120", "--output", "study/corpus")
        run("certify", "study/corpus", "--no-series", "--output", "study/certificates")
        run("replay", "study/corpus", "--output", "study/replays")
        features = "study/certificates/features.csv"
        run("fit", "cox", "--data", features, "--formula", "Surv(time_s, success) ~ tc_early", "--output", "tree/cox.json",
            "--format", "json")
        run("hypotheses", "h1", "--features", features, "--replicates", "20", "--output", "tree/h1")
        run("simulate", "--micro-study", "--output", "gates")
        (folder / "robot.clf").write_text("".join(
            f"FLASER 5 2 2 2 2 2 {k / 10} 0 0 {k / 10} 0 0 {k}.5 host {k}.5\n" for k in range(40)))

    return bench.once("results", make)


def inputs(bench):
    """Where 'verify' finds what the results were made from."""
    places = ("tree", "tree/certificates", "tree/corpus/worlds", "study", "study/certificates", "study/replays", ".")
    return [word for place in places for word in ("--inputs", results(bench) / place)]


# Every kind of command that writes: name of what is made, option that says where, the rest.
SHORT_COMMANDS = (
    ("corpus", "--output", "simulate --trials 6"),
    ("certified", "--output", "certify tree/corpus"),
    ("km.txt", "--output", "fit km --data tree/certificates/features.csv --formula Surv(time_s,success)~1"),
    ("replays", "--output", "replay tree/corpus"),
    ("record", "--record", "live --bundle tree/corpus"),
)
COMMANDS = SHORT_COMMANDS + (
    ("gates", "--output", "simulate --micro-study"),
    ("map.csv", "--output", "simulate terrain --rows 24 --columns 24"),
    ("proven", "--output", "certify tree/corpus --witness --truth"),
    ("carmen", "--output", "import carmen robot.clf --fov 180"),
    ("h1/", "--output", "hypotheses h1 --features study/certificates/features.csv --replicates 20"),
    ("h2.json", "--output", "hypotheses h2 --features study/certificates/features.csv --permutations 20 --format json"),
    ("h3/", "--output", "hypotheses h3 --replays study/replays/replay.csv --replicates 20"),
    ("gate/", "--output", "gate gates --replicates 20"),
    ("ablation", "--output", "ablate tree/corpus --replicates 20"),
    ("sweep", "--output", "sweep tree/corpus --grid beta_per_m=5,10 --replicates 20"),
    ("truth.csv", "--output", "world tree/corpus/worlds/t0000000.json --no-curvature"),
    ("pictures", "--picture", "world tree/corpus/worlds/t0000000.json --no-curvature"),
    ("walk", "--output", "explore terrain.csv --start 12,12 --lipschitz 18 --mode explore --max-steps 5 --threshold -1e9"),
    ("driven", "--output", "drive --worlds 1 --policies M1"),
    ("soundness", "--output", "study soundness --worlds 4"),
    ("figures", "--output", "figures tree"),
    ("page.html", "--output", "report tree"),
    ("everything", "--output", "reproduce tree/corpus"),
)
TICKS = "tree/certificates/ticks/t0000000.csv"


class Job:
    """One of the commands, run in the folder of the results, with its result below `out`."""

    def __init__(self, bench, command):
        self.bench = bench
        self.name, self.option, rest = command
        self.words = rest.split()
        self.results = results(bench)
        self.ticks = (self.results / TICKS).read_bytes() if self.words[0] == "live" else b""
        # What is imported or recorded is never replaced, and has no manifest.
        self.only_new = self.words[0] in ("import", "live")
        self.is_tree = self.words[0] == "reproduce"
        self.has_manifest = not self.only_new and self.option == "--output"

    @property
    def file(self):
        return self.name.rstrip("/")

    @property
    def good(self):
        return {0, 4} if self.words[0] == "explore" else {0}

    def arguments(self, out):
        quiet = [] if self.words[0] == "live" else ["--quiet"]
        return [*self.words, self.option, f"{out}/{self.name}", *quiet]

    def prepare(self, out):
        if self.name.endswith("/"):
            (out / self.file).mkdir(parents=True, exist_ok=True)

    def run(self, out, **how):
        return self.bench.run(*self.arguments(out), cwd=self.results, stdin=self.ticks, seconds=120, **how)

    def reference(self):
        """The folder with the result of an undisturbed run."""
        def make(folder):
            (folder / "out").mkdir()
            self.prepare(folder / "out")
            self.run(folder / "out").ended_well(self.good)

        return self.bench.once(f"reference_{self.file}", make) / "out"

    def inputs(self):
        return inputs(self.bench)
