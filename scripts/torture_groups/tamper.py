"""Results, manifests and caches that somebody changed: 'verify' says so, runs nothing that is not a result,
and a cache never changes what comes out."""
import hashlib
import json
import os
import shutil

from .bench import copy, require, require_same, tree
from .hostile import spoiled
from .material import inputs, results

# Of a manifest's keys these say which program wrote it; they are noted and not compared.
NOTED = ("tool",)


def changed_file(rng, folder, path):
    """One edit of a file that a manifest lists; says what was done."""
    data = path.read_bytes()
    kind = rng.choice(("bit", "truncate", "append", "delete", "empty", "line", "swap", "link", "folder", "space"))
    if kind == "bit":
        at = rng.randrange(len(data))
        path.write_bytes(data[:at] + bytes([data[at] ^ (1 << rng.randrange(8))]) + data[at + 1:])
    elif kind == "truncate":
        path.write_bytes(data[:rng.randrange(len(data))])
    elif kind == "append":
        path.write_bytes(data + rng.choice((b"\n", b"\0", b"x", b" ")))
    elif kind == "delete":
        path.unlink()
    elif kind == "empty":
        path.write_bytes(b"")
    elif kind == "line":
        lines = data.splitlines(keepends=True)
        lines[rng.randrange(len(lines))] = b"\n" if len(lines) > 1 else b"x\n"
        if b"".join(lines) == data:
            path.write_bytes(data + b"\n")
        else:
            path.write_bytes(b"".join(lines))
    elif kind == "swap":
        others = [p for p in folder.rglob("*") if p.is_file() and p.name != "manifest.json" and p.read_bytes() != data]
        path.write_bytes(rng.choice(others).read_bytes() if others else data + b"x")
    elif kind == "link":
        other = path.with_name(path.name + ".elsewhere")
        path.rename(other)
        path.symlink_to(other.name)
    elif kind == "folder":
        path.unlink()
        path.mkdir()
    else:
        path.write_bytes(data.replace(b",", b", ", 1) if b"," in data else data + b" ")
    return kind


def tampered_result(bench, rng):
    """A file below a result; 'verify' ends with 1, also by the files alone."""
    source = results(bench) / "tree"
    result = rng.choice(sorted(p.name for p in source.iterdir() if (p / "manifest.json").exists()))
    folder = copy(source / result, bench.attempt / "tree" / result)
    files = [p for p in sorted(folder.rglob("*")) if p.is_file() and p.name != "manifest.json" and p.stat().st_size]
    path = rng.choice(files)
    kind = changed_file(rng, folder, path)
    before = tree(bench.attempt / "tree")
    words = ["--files-only"] if rng.random() < 0.6 else inputs(bench)
    run = bench.run("verify", "tree", *words).ended_well({1, 65, 66})
    require_same(before, tree(bench.attempt / "tree"), f"what was verified ({kind} of {path.name})")
    return run


def added_file(bench, rng):
    source = results(bench) / "tree"
    result = rng.choice(sorted(p.name for p in source.iterdir() if (p / "manifest.json").exists()))
    folder = copy(source / result, bench.attempt / "tree" / result)
    place = rng.choice([folder, *(p for p in folder.rglob("*") if p.is_dir())])
    added = place / rng.choice(("extra.csv", "features2.csv", "x.json", "new"))
    kind = rng.choice(("file", "link", "hidden"))
    if kind == "link":
        added.symlink_to("/etc/passwd")
    elif kind == "hidden":
        place.joinpath(".hidden.csv").write_text("x")
    else:
        added.write_text("mine")
    run = bench.run("verify", "tree", "--files-only").ended_well({0, 1, 65, 66})
    require(run.code != 0 or kind == "hidden", f"a {kind} that is not listed was not noticed: {run.words()}")


def places_of(value, path=()):
    """Every place in a JSON document."""
    if path:
        yield path
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        yield from places_of(child, path + (key,))


def other_value(rng, value):
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return rng.choice((value + 1, -value - 1, 1e300, str(value), None))
    if isinstance(value, str):
        return rng.choice((value + "x", value[:-1] if len(value) > 1 else "y", "../" + value, "", 7, "/etc/passwd"))
    return rng.choice((None, [], {}, "x", 1)) if value not in ([], {}, None) else rng.choice(("x", 1, [1]))


def changed_manifest(bench, rng):
    """A claim of a manifest is another one, is gone or is new: it does not stand any more."""
    source = results(bench) / "tree"
    result = rng.choice(sorted(p.name for p in source.iterdir() if (p / "manifest.json").exists()))
    folder = copy(source / result, bench.attempt / "tree" / result)
    path = folder / "manifest.json"
    manifest = json.loads(path.read_text())
    kind = rng.choice(("value", "value", "value", "gone", "new", "bytes", "trailing"))
    text = None
    place = rng.choice([p for p in places_of(manifest) if p[0] not in NOTED])
    holder = manifest
    for key in place[:-1]:
        holder = holder[key]
    if kind == "value":
        holder[place[-1]] = other_value(rng, holder[place[-1]])
    elif kind == "gone":
        del holder[place[-1]]
    elif kind == "new":
        manifest[rng.choice(("extra", "inputs2", "outputs ", "Seed"))] = rng.choice((1, [], "x"))
    elif kind == "trailing":
        text = path.read_text() + rng.choice(("\n", " ", "{}", "x", "\0"))
    else:
        text = spoiled(rng, path.read_bytes()).decode(errors="replace")
        try:
            if {k: v for k, v in json.loads(text).items() if k not in NOTED} == {k: v for k, v in manifest.items() if k not in NOTED}:
                return None  # nothing was claimed otherwise
        except (ValueError, AttributeError):
            pass
    path.write_text(text if text is not None else json.dumps(manifest, indent=2, ensure_ascii=False) + "\n")
    before = tree(bench.attempt)
    run = bench.run("verify", "tree", *inputs(bench)).ended_well({1, 65, 66})
    after = {k: v for k, v in tree(bench.attempt).items() if not k.startswith(("cache", "home/.cache"))}
    require_same({k: v for k, v in before.items() if not k.startswith(("cache", "home/.cache"))}, after, f"beside it ({kind} {place})")
    return run


def hostile_manifest(bench, rng):
    """A command line that would write, run or read elsewhere: refused, and nothing changes."""
    source = results(bench) / "tree"
    for part in ("corpus", "certificates"):
        copy(source / part, bench.attempt / "tree" / part)
    canary = bench.attempt / "canary"
    canary.mkdir()
    (canary / "x.csv").write_text("mine")
    path = bench.attempt / "tree/certificates/manifest.json"
    manifest = json.loads(path.read_text())
    there = str(canary / rng.choice(("x.csv", "new", "new/deeper")))
    manifest["command"] = rng.choice(("world", "report", "certify", "ablate", "sweep", "live", "reproduce", "verify", "import",
                                      "import carmen", "simulate", "simulate terrain", "fit", "fit cox", "figures", "explore",
                                      "hypotheses", "batch", "drive", "help", "", "certify;touch x", "/bin/sh", "../x"))
    manifest["arguments"] = [rng.choice((
        {"input": "corpus"}, {"input": "../corpus"}, {"input": there}, {"input": "/etc/passwd"}, "--output", "--picture",
        f"--output={there}", f"--picture={there}", "--cache", "--figures", "--record", "--audit", "--config", "--threads", "1000",
        "-c", "touch x", there, "--", "--help", "--trials", "*", "--cells", "--bundle", "--listen", f"unix:{there}", "--data",
        "--formula", "y ~ x", "--set", "tick_s=0.1", {"input": "corpus", "x": 1}, 7, None)) for _ in range(rng.randint(0, 4))]
    path.write_text(json.dumps(manifest, indent=2) + "\n")
    before = {k: v for k, v in tree(bench.attempt).items() if not k.startswith(("cache", "home", "tmp"))}
    bench.run("verify", "tree", seconds=120).ended_well({1, 65, 66})
    after = {k: v for k, v in tree(bench.attempt).items() if not k.startswith(("cache", "home", "tmp"))}
    require_same(before, after, f"beside a hostile manifest: {manifest['command']} {manifest['arguments']}")
    require(not os.listdir(bench.attempt / "tmp"), "the scratch folder of 'verify' was left")


def forged_proof(bench, rng):
    """A witness that states more than it proves does not stand, even where its manifest lists the forgery."""
    source = results(bench) / "tree"
    folder = copy(source / "certificates", bench.attempt / "tree/certificates")
    copy(source / "corpus", bench.attempt / "tree/corpus")
    proofs = sorted((folder / "witness").glob("*.json"))
    proof = rng.choice([p for p in proofs if p.stat().st_size > 400] or proofs)
    document = json.loads(proof.read_text())
    places = [p for p in places_of(document) if not isinstance(reach(document, p), (dict, list))]
    place = rng.choice(places)
    value = reach(document, place)
    reach(document, place[:-1])[place[-1]] = value * 1.01 + 0.01 if type(value) in (int, float) else other_value(rng, value)
    text = json.dumps(document, indent=2) + "\n" if rng.random() < 0.5 else \
        proof.read_text().replace(json.dumps(value), json.dumps(reach(document, place)), 1)
    if text == proof.read_text():
        text += " "
    proof.write_text(text)
    manifest = json.loads((folder / "manifest.json").read_text())
    for output in manifest["outputs"]:
        if output["path"] == f"witness/{proof.name}":
            output |= {"bytes": len(text.encode()), "sha256": hashlib.sha256(text.encode()).hexdigest()}
    (folder / "manifest.json").write_text(json.dumps(manifest, indent=2) + "\n")
    bench.run("verify", "tree", seconds=120).ended_well({1, 65, 66})


def reach(value, path):
    for key in path:
        value = value[key]
    return value


def forged_cache(bench, rng):
    """Entries of the cache that were cut, flipped, swapped or written anew: the results are those without it."""
    corpus = results(bench) / "tree/corpus"
    words = ["ablate", corpus, "--replicates", "20", "--quiet"]
    expected = bench.once("without_cache", lambda f: bench.make(*words, "--no-cache", "--output", f / "out"))
    filled = bench.once("cache", lambda f: bench.make(*words, "--cache", f / "cache", "--output", f / "out"))
    cache = copy(filled / "cache", bench.attempt / "entries")
    entries = [p for p in sorted(cache.rglob("*")) if p.is_file()]
    require(entries, "nothing was cached")
    for entry in rng.sample(entries, min(len(entries), rng.choice((1, 3, len(entries))))):
        kind = rng.choice(("spoil", "swap", "link", "folder", "empty"))
        if kind == "spoil":
            entry.write_bytes(spoiled(rng, entry.read_bytes()))
        elif kind == "swap":
            other = rng.choice(entries)
            if other != entry and other.is_file() and not other.is_symlink():
                shutil.copyfile(other, entry)
        elif kind == "link":
            entry.unlink()
            entry.symlink_to(rng.choice(("/dev/zero", "/etc/passwd", "nothing", str(entry))))
        elif kind == "folder":
            entry.unlink()
            entry.mkdir()
        else:
            entry.write_bytes(b"")
    run = bench.run(*words, "--cache", cache, "--output", bench.attempt / "out").ended_well({0})
    require_same(tree(expected / "out"), tree(bench.attempt / "out"), f"results by a forged cache: {run.words()}")


KINDS = (tampered_result, changed_manifest, tampered_result, hostile_manifest, added_file, forged_cache, changed_manifest, forged_proof)


def attempt(bench, rng, number):
    KINDS[number % len(KINDS)](bench, rng)


def short(bench):
    for number in range(40):
        yield lambda rng, number=number: attempt(bench, rng, number)
