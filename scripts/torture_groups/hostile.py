"""What strangers hand over: ids, options, parameters and files that are meant to hurt, or only broken.

The tool ends with a documented code, within time and memory, and nothing but what was asked for has
changed: a canary lies in and round the folder in which it works."""
import gzip
import hashlib
import json
import re
import resource
import zipfile

from .bench import MEBIBYTE, copy, require, require_same, tree
from .material import results

# Real time and address space of one attack; a run of the material takes less than a second and 200 MiB.
SECONDS = 60
LIMITS = {resource.RLIMIT_AS: 8192 * MEBIBYTE}

IDS = ["..", ".", ".hidden", ".x.1-0.tmp", "../canary/x", "../../canary/x", "a/../../../canary/x", "../canary", "a/b",
       "series/../../canary/x", "a\\..\\b", "~/x", "$HOME/x", "`touch x`/y", "$(touch x)", "x\ty", "\x1b[2J", "x\ny", "x\r",
       "\x7f", "a" * 231, "a" * 255, "b" * 5000, "link/x", "manifest.json/x", "x\u009by/z", "", " ", "'", '"', ",", ";",
       "=cmd|' /C calc'!A0", "<script>alert(1)</script>", "%s%n%x", "NA", "nan", "-1", "--output", "t0000000", "T0000000",
       "\u202egnp", "\ufeffid", "CON", "a.csv", "*", "?", "[a-z]*"]
IDS += ["../" * depth + "canary/planted" for depth in range(1, 9)]
NUMBERS = ["0", "-0.0", "-1", "1e-300", "5e-324", "1e300", "1.7976931348623157e308", "1e400", "-1e400", "nan", "inf", "-inf",
           "NA", "", " ", "0x1F", "1e", "1,5", "9223372036854775807", "-9223372036854775808", "18446744073709551616",
           "4294967296", "2147483648", "1e-9", "0.001", "1000000", "true", "null", "'", "1 2", "\u0661", "1" * 400]


def quoted(text):
    return '"' + text.replace('"', '""') + '"'


def drawn_id(rng):
    if rng.random() < 0.7:
        return rng.choice(IDS)
    return "".join(chr(rng.choice((rng.randrange(1, 32), rng.randrange(32, 127), rng.randrange(128, 0x2100))))
                   for _ in range(rng.randint(1, 40)))


class Stage:
    """A folder to work in with canaries in it and round it, and a link that leads to one."""

    def __init__(self, bench):
        self.bench = bench
        self.here = bench.attempt / "run"
        for place in (self.here / "canary", bench.attempt / "canary"):
            place.mkdir(parents=True)
            for name in ("x", "x.csv", "planted", "planted.csv"):
                (place / name).write_text("mine")
        (self.here / "link").symlink_to("../canary")
        (self.here / "out").mkdir()

    def outside(self):
        kept = ("run/out", "tmp", "home/.cache", "cache")
        return {k: v for k, v in tree(self.bench.attempt).items() if not k.startswith(kept)}

    def attack(self, *words, stdin=b"", codes=None, limits=LIMITS):
        before = self.outside()
        run = self.bench.run(*words, cwd=self.here, stdin=stdin, seconds=SECONDS, limits=limits, env={"GNUTERM": "dumb"})
        run.ended_well(*([codes] if codes else []))
        require_same(before, self.outside(), f"outside of --output, by {run.command}")
        require(b"\x1b" not in run.err, f"it tells a terminal what to do: {run.words()}")
        return run


FORMATS = ("text", "md", "csv", "json", "jsonl", "tex")


def hostile_id_in_a_bundle(stage, rng):
    source = results(stage.bench) / "tree/corpus"
    bundle = copy(source, stage.here / "bundle")
    table = (bundle / "trials.csv").read_text()
    name = drawn_id(rng)
    if rng.random() < 0.5:
        table += quoted(name) + ",M1,Dark,D01,B01,1,20,3,goal,0.1\n"
    else:  # in the place of another word
        row = table.splitlines()[2].split(",")
        row[rng.randrange(len(row))] = quoted(name)
        table += ",".join(row) + "\n"
    (bundle / "trials.csv").write_text(table, errors="surrogatepass")
    stage.attack(*rng.choice((
        ["certify", "bundle", "--ticks", "--witness", "--output", "out/a"], ["certify", "bundle", "--format", rng.choice(FORMATS)],
        ["replay", "bundle", "--series", "--output", "out/b"], ["check", "bundle", "--format", rng.choice(FORMATS)],
        ["ablate", "bundle", "--replicates", "20", "--cache", "out/cache", "--output", "out/c"],
        ["hypotheses", "h3", "bundle", "--format", rng.choice(FORMATS)], ["gate", "bundle"],
        ["certify", "bundle", "--trials", "*"])))


def hostile_id_of_results(stage, rng):
    source = results(stage.bench) / "tree"
    foreign = stage.here / "foreign"
    for part in ("corpus", "certificates"):
        copy(source / part, foreign / part)
    name = drawn_id(rng)
    manifest = json.loads((foreign / "certificates/manifest.json").read_text())
    for table in ("certificates.csv", "features.csv"):
        path = foreign / "certificates" / table
        text = path.read_text().replace("t0000000", quoted(name)).encode(errors="surrogatepass")
        path.write_bytes(text)
        for output in manifest["outputs"]:
            if output["path"] == table:
                output |= {"bytes": len(text), "sha256": hashlib.sha256(text).hexdigest()}
    (foreign / "certificates/manifest.json").write_text(json.dumps(manifest, indent=2) + "\n")
    page = [["report", "foreign", "--output", "out/report.html"]] if stage.bench.options.has_page else []
    stage.attack(*rng.choice([["figures", "foreign", "--output", "out/figures"], ["verify", "foreign"],
                              ["fit", "roc", "--data", "foreign/certificates/features.csv", "--formula",
                               "success ~ tc_early", "--cluster", "trial_id", "--format", rng.choice(FORMATS)],
                              ["hypotheses", "h1", "--features", "foreign/certificates/features.csv", "--replicates", "5"]] + page))


def hostile_id_on_the_command_line(stage, rng):
    name = drawn_id(rng).replace("\0", "")
    base = results(stage.bench)
    stage.attack(*rng.choice((
        ["figures", base / "tree", "--output", "out/figures", "--trials", name],
        ["certify", base / "tree/corpus", "--trials", name], ["certify", name, "--output", "out/x"],
        ["import", "carmen", base / "robot.clf", "--fov", "180", "--output", "out/carmen", "--trial-id", name],
        ["fit", "glm", "--data", base / "tree/certificates/features.csv", "--formula", f"success ~ {name}"],
        ["fit", "cox", "--data", base / "tree/certificates/features.csv", "--formula", "Surv(time_s, success) ~ tc_early",
         "--cluster", name], ["help", name], [name, "--help"], ["fit", name],
        ["certify", base / "tree/corpus", "--set", f"{name}={name}"], ["live", "--bundle", name],
        ["verify", name], ["world", name], ["check", name], ["explore", name, "--start", name])))


def parameters(bench):
    """key -> what it accepts, of 'tcert help parameters'."""
    if "parameters" not in bench.memory:
        text = bench.make("help", "parameters").out.decode()
        found = re.findall(r"^([a-z][a-z0-9_]+) {2,}(.*)$", text, flags=re.M)
        bench.memory["parameters"] = {key: rest for key, rest in found if key != "key"}
    return bench.memory["parameters"]


def bounds_of(rest):
    """Numbers at the ends of what a parameter accepts."""
    found = re.search(r"number (?:from|above) (\S+?)(?: to |, at most )(\S+?)(?:[ ,]|$)", rest)
    return list(found.groups()) if found else []


def extreme_parameters(stage, rng):
    known = parameters(stage.bench)
    require(len(known) > 60, "help parameters lists too few")
    changes = []
    for key in rng.sample(sorted(known), rng.choice((1, 1, 2, 3))):
        words = re.findall(r"\b[a-z_]+\b", known[key])
        value = rng.choice(bounds_of(known[key]) * 3 + NUMBERS + words[:8])
        changes += ["--set", f"{key}={value}"]
    base = results(stage.bench)
    ticks = (base / "tree/certificates/ticks/t0000000.csv").read_bytes()
    command = rng.choice((["certify", base / "tree/corpus", "--trials", "t0000000"],
                          ["certify", base / "tree/corpus", "--trials", "t0000001", "--set", "clearance=swept"],
                          ["certify", base / "tree/corpus", "--trials", "t0000001", "--set", "clearance=witness"],
                          ["replay", base / "tree/corpus", "--trials", "t0000002"],
                          ["live", "--bundle", base / "tree/corpus", "--guards", "--monitor", "--risk"],
                          ["drive", "--worlds", "1", "--policies", "M3+squash20+guards", "--output", "out/driven"]))
    stage.attack(*command, *changes, stdin=ticks)


def options_of(bench, command):
    """(option, whether it takes a value) of a command's help."""
    key = "options of " + " ".join(command)
    if key not in bench.memory:
        text = bench.run(*command, "--help").out.decode()
        bench.memory[key] = re.findall(r"^  (?:-\w \[ )?(--[a-z0-9-]+)(?: \])?(?: ([A-Z][A-Z0-9,=_]*))?", text, flags=re.M)
    return bench.memory[key]


def any_command_line(stage, rng):
    base = results(stage.bench)
    features = base / "study/certificates/features.csv"
    command, needed = rng.choice((
        (["simulate"], ["--trials", "3"]), (["simulate", "terrain"], ["--rows", "20", "--columns", "20"]),
        (["certify"], [base / "tree/corpus"]), (["check"], [base / "tree/corpus"]), (["replay"], [base / "tree/corpus"]),
        (["world"], [base / "tree/corpus/worlds/t0000000.json"]), (["gate"], [base / "gates", "--replicates", "20"]),
        (["fit", "glm"], ["--data", features, "--formula", "success ~ tc_early"]),
        (["fit", "cox"], ["--data", features, "--formula", "Surv(time_s, success) ~ tc_early"]),
        (["fit", "km"], ["--data", features, "--formula", "Surv(time_s, success) ~ lighting"]),
        (["fit", "roc"], ["--data", features, "--formula", "success ~ tc_early"]),
        (["fit", "glmm"], ["--data", features, "--formula", "success ~ tc_early + (1 | day)"]),
        (["fit", "calibration"], ["--data", features, "--formula", "success ~ tc_early"]),
        (["fit", "concordance"], ["--data", features, "--formula", "Surv(time_s, success) ~ tc_early"]),
        (["hypotheses", "h1"], ["--features", features, "--replicates", "20"]),
        (["hypotheses", "h2"], ["--features", features, "--permutations", "20"]),
        (["hypotheses", "h3"], ["--replays", base / "study/replays/replay.csv", "--replicates", "20"]),
        (["explore"], [base / "terrain.csv", "--start", "12,12", "--lipschitz", "18", "--max-steps", "5"]),
        (["live"], ["--bundle", base / "tree/corpus"]), (["figures"], [base / "tree"]),
        (["import", "carmen"], [base / "robot.clf", "--fov", "180"]), (["verify"], [base / "tree/certificates"]),
        (["study", "soundness"], ["--worlds", "2"]), (["drive"], ["--worlds", "1", "--policies", "M1"]),
        (["ablate"], [base / "tree/corpus", "--replicates", "5"])))
    known = [(name, takes) for name, takes in options_of(stage.bench, command)
             if name not in ("--listen", "--stdio", "--help", "--output", "--picture", "--cache", "--audit", "--record")]
    require(known, f"no options in the help of {command}")
    words = []
    for name, takes in rng.sample(known, min(len(known), rng.choice((1, 1, 2, 3)))):
        words.append(name)
        if takes or rng.random() < 0.05:
            words.append(rng.choice(NUMBERS + ["a", "1,2", "1;2", "x=1", "12,12", "t0000000", str(features), "csv"] + IDS[:8]))
    if command[0] not in ("live", "verify", "check"):
        words += ["--output", "out/result"]
    stage.attack(*command, *needed, *words, stdin=b"")


def spoiled(rng, data):
    """Bytes with some edits, as a disk, an editor or a stranger would make."""
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 5, 20))):
        at = rng.randrange(len(data) + 1)
        kind = rng.randrange(9)
        if kind == 0 and data:
            data[min(at, len(data) - 1)] ^= 1 << rng.randrange(8)
        elif kind == 1:
            del data[at:]
        elif kind == 2:
            del data[at:at + rng.choice((1, 2, 10, 500))]
        elif kind == 3:
            data[at:at] = data[max(0, at - rng.choice((1, 20, 400, 5000))):at]
        elif kind == 4:
            data[at:at] = rng.choice((b"\0", b"\xff", b"\xef\xbb\xbf", b"\r", b"\n", b'"', b",,,,", b"[" * 5000, b"{" * 70,
                                      b"\x1b[2J", b"9" * 400, b"-", b"e", b"1e999", b"NA", b"\xc3\x28", b"#"))
        elif kind in (5, 6):  # a number for a number
            places = list(re.finditer(rb"-?\d+(?:\.\d+)?(?:e-?\d+)?", data))
            if places:
                place = rng.choice(places)
                data[place.start():place.end()] = rng.choice(NUMBERS).encode()
        elif kind == 7:
            lines = bytes(data).splitlines(keepends=True)
            if len(lines) > 2:
                a, b = rng.sample(range(len(lines)), 2)
                lines[a], lines[b] = lines[b], lines[a]
            data = bytearray(b"".join(lines))
        else:
            data[at:at] = bytes(rng.randrange(256) for _ in range(rng.choice((1, 4, 64))))
    return bytes(data)


def spoiled_file_of_a_bundle(stage, rng):
    bundle = copy(results(stage.bench) / "tree/corpus", stage.here / "bundle")
    files = ["bundle.json", "trials.csv", "worlds/t0000000.json", "manifest.json"]
    files += [f"logs/t0000000/{stream}.csv" for stream in ("pose", "tactile", "control")] * 2
    file = bundle / rng.choice(files)
    data = spoiled(rng, file.read_bytes())
    if rng.random() < 0.15:
        file.unlink()
        file = file.with_name(file.name + ".gz")
        data = spoiled(rng, gzip.compress(data)) if rng.random() < 0.5 else gzip.compress(data)
    file.write_bytes(data)
    source = "bundle"
    if rng.random() < 0.1:
        with zipfile.ZipFile(stage.here / "bundle.zip", "w") as packed:
            for path in bundle.rglob("*"):
                packed.write(path, path.relative_to(stage.here))
        zipped = stage.here / "bundle.zip"
        zipped.write_bytes(spoiled(rng, zipped.read_bytes()) if rng.random() < 0.7 else zipped.read_bytes())
        source = "bundle.zip"
    ticks = (results(stage.bench) / "tree/certificates/ticks/t0000000.csv").read_bytes()
    stage.attack(*rng.choice((["certify", source, "--output", "out/a"], ["certify", source, "--repair", "--format", "csv"],
                              ["check", source], ["check", source, "--write-map", "out/map.json"],
                              ["replay", source, "--format", "csv"], ["live", "--bundle", source],
                              ["certify", source, "--set", "clearance=swept", "--witness", "--truth", "--output", "out/w"],
                              ["world", "bundle/worlds/t0000000.json", "--no-curvature", "--step", "0.1"],
                              ["verify", "bundle", "--files-only"])), stdin=ticks)


def spoiled_table(stage, rng):
    base = results(stage.bench)
    path = stage.here / "table.csv"
    if rng.random() < 0.3:
        path.write_bytes(spoiled(rng, (base / "terrain.csv").read_bytes()))
        return stage.attack("explore", "table.csv", "--start", "12,12", "--lipschitz", "18", "--max-steps", "3", "--goal", "4,4")
    path.write_bytes(spoiled(rng, (base / "study/certificates/features.csv").read_bytes()))
    formula = rng.choice(("success ~ tc_early + lighting", "success ~ I(tc_early^2) + dwell", "success ~ log(time_s) + factor(day)"))
    surv = rng.choice(("Surv(time_s, success) ~ tc_early + strata(algorithm)", "Surv(time_s, success) ~ lighting"))
    stage.attack(*rng.choice((["fit", "glm", "--data", "table.csv", "--formula", formula, "--cluster", "day"],
                              ["fit", "cox", "--data", "table.csv", "--formula", surv], ["check", "table.csv"],
                              ["fit", "km", "--data", "table.csv", "--formula", "Surv(time_s, success) ~ lighting", "--rmst", "60"],
                              ["fit", "roc", "--data", "table.csv", "--formula", "success ~ tc_early"],
                              ["hypotheses", "h1", "--features", "table.csv", "--replicates", "5"],
                              ["hypotheses", "h2", "--features", "table.csv", "--permutations", "5"])))


def spoiled_text(stage, rng):
    """Rules, maps, config files and other small texts of the user."""
    base = results(stage.bench)
    ticks = (base / "tree/certificates/ticks/t0000000.csv").read_bytes()
    text = stage.here / "text"
    kind = rng.choice(("rules", "map", "config", "clf", "world"))
    if kind == "rules":
        text.write_bytes(spoiled(rng, b"force: force_n > force_limit_n\nwatch m: historically[0,0.2] (robust_margin_m <= 0.005 "
                                      b"and speed_cmd_mps > 0)\nstall: time_s >= 2 and not once[0,2] moved_mps < 0.01\n"))
        stage.attack("live", "--bundle", base / "tree/corpus", "--rules", "text", stdin=ticks)
    elif kind == "map":
        text.write_bytes(spoiled(rng, json.dumps({
            "robot": {"body_width_m": 0.4, "min_turn_radius_m": 0.2},
            "course": {"start": {"disc": {"x_m": 0, "y_m": 0, "radius_m": 0.5}}},
            "pose": {"file": "pose.csv", "x_m": {"column": "x_m"}, "y_m": {"column": "y_m"}, "yaw_rad": {"column": "yaw_rad"}},
            "rays": {"file": "tactile.csv", "rays": [{"name": "left", "kind": "range", "mount_y_m": 0.1, "bearing_deg": 90,
                                                      "reach_m": 2, "range_m": {"column": "left_bend_rad"}}]}}).encode()))
        stage.attack("import", "log", base / "tree/corpus/logs/t0000000", "--map", "text", "--output", "out/bundle")
    elif kind == "config":
        text.write_bytes(spoiled(rng, b"trials = t000000*\ntick_s = 0.1\n[certify]\nstrict = true\nedge_length_m=0.3\n"))
        stage.attack("certify", base / "tree/corpus", "--config", "text")
    elif kind == "clf":
        text.write_bytes(spoiled(rng, (base / "robot.clf").read_bytes()))
        stage.attack("import", "carmen", "text", "--fov", "180", "--output", "out/carmen")
    else:
        text.write_bytes(spoiled(rng, (base / "tree/corpus/worlds/t0000001.json").read_bytes()))
        stage.attack("world", "text", "--step", "0.1", "--no-curvature", "--picture", "out/pictures")


def bomb(stage, rng):
    """Much out of little: packed files, deep and wide JSON, long lines, many columns, many small trials."""
    base = results(stage.bench)
    bundle = copy(base / "tree/corpus", stage.here / "bundle")
    ticks = (base / "tree/certificates/ticks/t0000000.csv").read_bytes()
    kind = rng.choice(("gzip", "deep", "wide", "line", "columns", "rows", "zip", "deep_tick"))
    if kind == "gzip":
        (bundle / "logs/t0000001/pose.csv").unlink()
        with gzip.open(bundle / "logs/t0000001/pose.csv.gz", "wb", compresslevel=9) as packed:
            packed.write(b"time_s,x_m,y_m,yaw_rad\n" + bytes(rng.choice((10, 100, 300)) * MEBIBYTE))
    elif kind in ("deep", "wide"):
        deep = rng.choice(("[", '{"a":')) * rng.choice((65, 1000, 100000, 1000000))
        wide = "{" + "".join(f'"k{i}":1,' for i in range(rng.choice((4097, 200000)))) + '"z":1}'
        target = rng.choice(("bundle.json", "worlds/t0000000.json", "manifest.json"))
        (bundle / target).write_text(deep if kind == "deep" else wide)
        if target != "bundle.json":
            return stage.attack(*(["world", "bundle/" + target] if "worlds" in target else ["verify", "bundle"]))
    elif kind == "line":
        (bundle / "trials.csv").write_text("trial_id,success,time_s\n" + "a" * rng.choice((10**6, 2 * 10**7)) + ",1,2\n")
    elif kind == "columns":
        names = ",".join(f"c{i}" for i in range(rng.choice((10**4, 10**5))))
        (bundle / "trials.csv").write_text(f"trial_id,success,time_s,{names}\nt0000000,1,2\n")
    elif kind == "rows":
        (bundle / "trials.csv").write_text("trial_id,success,time_s\n" + "".join(f"x{i},1,2\n" for i in range(50000)))
    elif kind == "zip":
        with zipfile.ZipFile(stage.here / "many.zip", "w", zipfile.ZIP_DEFLATED) as packed:
            for path in bundle.rglob("*"):
                packed.write(path, path.relative_to(stage.here))
            for i in range(20000):
                packed.writestr(f"bundle/logs/x{i}/pose.csv", "time_s\n")
            packed.writestr("../canary/x", "planted")
        return stage.attack(*rng.choice((["certify", "many.zip", "--output", "out/a"], ["check", "many.zip"])))
    else:
        line = b'{"time_s":' + b"[" * rng.choice((100, 10**6)) + b"\n"
        many = b"{" + b"".join(b'"k%d":1,' % i for i in range(60000)) + b'"z":1}\n'
        return stage.attack("live", "--bundle", base / "tree/corpus", "--input-format", "jsonl", stdin=line + many + line)
    stage.attack(*rng.choice((["certify", "bundle", "--output", "out/a"], ["check", "bundle"], ["certify", "bundle", "--format", "csv"],
                              ["live", "--bundle", "bundle"])), stdin=ticks)


KINDS = (hostile_id_in_a_bundle, spoiled_file_of_a_bundle, extreme_parameters, any_command_line, hostile_id_on_the_command_line,
         spoiled_table, spoiled_text, hostile_id_of_results, spoiled_file_of_a_bundle, extreme_parameters, any_command_line, bomb)


def attempt(bench, rng, number):
    stage = Stage(bench)
    KINDS[number % len(KINDS)](stage, rng)


def short(bench):
    for number in range(96):
        if number % len(KINDS) != len(KINDS) - 1 or number < 24:  # bombs are slow
            yield lambda rng, number=number: attempt(bench, rng, number)
