#!/usr/bin/env python3
"""Mutation tests: the share of faults in the code that the tests detect.

    lab/mutation/run.py [AREA ...]     selects, builds and tests mutants; writes reports/mutation.csv and reports/mutation.md
    lab/mutation/run.py --all AREA     every mutant of an area instead of a sample
    lab/mutation/run.py --again        only mutants that survived the last run or were not tried in it

It needs cargo-mutants (cargo install cargo-mutants), and tree-sitter and tree-sitter-rust (pip) for the positions of expressions.
cargo-mutants generates the mutants and selects the sample (--shard 0/n, round robin). One build contains all mutants: each is
beside the original under `if crate::mutant(k)`, and an environment variable selects the active one. Mutants that do not compile
in this form are built separately. The areas and the handwritten faults are in areas.py. A mutant is caught if a test fails or
does not end; the tests of its area run first, then all tests of its crate. The table keeps the reasons for surviving mutants from
run to run.
"""

import argparse
import collections
import csv
import fnmatch
import json
import os
import pathlib
import re
import signal
import subprocess
import threading

import tree_sitter
import tree_sitter_rust

from areas import AREAS, FAULTS, KINDS

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TREE = ROOT / "target" / "mutation"
TABLE = ROOT / "reports" / "mutation.csv"
TIMEOUT = 180.0
HEAD = """# Mutation testing

The tests were run with faults in the code, by `lab/mutation/run.py`, which describes the method. Of the mutants of
cargo-mutants a sample of one in 1 to 35 is used, by area; the faults of `lab/mutation/areas.py` are also tested. All rows are in
mutation.csv. This is not part of CI. "Not tried" mutants cannot be compiled together with the original, and were not built separately.
"""
SWITCH = """
/// Whether a mutant is in force.
pub(crate) fn mutant(k: u32) -> bool {
    static NUMBER: std::sync::LazyLock<u32> = std::sync::LazyLock::new(|| {
        std::env::var("GAITCAM_MUTANT").ok().and_then(|k| k.parse().ok()).unwrap_or(0)
    });
    *NUMBER == k
}
"""
RUST = tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language()))

Mutant = collections.namedtuple("Mutant", "number area package file name start end genre new")


def drawn(area, whole):
    """Random mutants of an area by cargo-mutants, and the number of all."""
    files = [argument for glob in AREAS[area].files for argument in ("-f", glob)]
    listing = ["cargo", "mutants", "--list", "--json", "--workspace", *files]
    listed = lambda *more: json.loads(subprocess.run([*listing, *more], cwd=ROOT, check=True, capture_output=True).stdout)
    every = len(listed())
    shard = [] if whole else ["--sharding", "round-robin", "--shard", f"0/{AREAS[area].one_in}"]
    return listed(*shard), every


def position(text, place):
    """Byte offset of a line and column counted from 1."""
    lines = text.split("\n")
    before = lines[: place["line"] - 1] + [lines[place["line"] - 1][: place["column"] - 1]]
    return len("\n".join(before).encode())


def numbered(areas, whole):
    """All mutants to try."""
    out = []
    for area in areas:
        for m in drawn(area, whole)[0]:
            text = (ROOT / m["file"]).read_text()
            start, end = (position(text, m["span"][k]) for k in ("start", "end"))
            out.append((area, m["package"], m["file"], m["name"], start, end, m["genre"], m["replacement"]))
    for fault in FAULTS:
        text = (ROOT / fault.file).read_text()
        if text.count(fault.old) != 1:
            raise SystemExit(f"{fault.name}: {fault.file} has {text.count(fault.old)} times: {fault.old}")
        start = len(text[: text.index(fault.old)].encode())
        if fault.area in areas:
            end = start + len(fault.old.encode())
            out.append((fault.area, AREAS[fault.area].package, fault.file, fault.name, start, end, "Fault", fault.new))
    return [Mutant(k, *m) for k, m in enumerate(out, 1)]


def nodes(node):
    yield node
    for child in node.children:
        yield from nodes(child)


def switched(mutant, source, tree):
    """Byte range of a mutant, with the texts before and after it; None if no switch is possible."""
    start, end, k = mutant.start, mutant.end, mutant.number
    text = lambda a, b: source[a:b].decode()
    either = lambda a, b, other: (a, b, f"(if crate::mutant({k}) {{ {other} }} else {{ ", " })")
    if mutant.genre == "FnValue":
        return start, end, f"if crate::mutant({k}) {{ return {mutant.new}; }} ", ""
    if mutant.genre in ("Fault", "MatchArmGuard"):
        return either(start, end, mutant.new)
    for node in nodes(tree.root_node):
        if node.type in ("binary_expression", "compound_assignment_expr", "unary_expression"):
            operator = node.child_by_field_name("operator") or node.children[0]
            if (operator.start_byte, operator.end_byte) == (start, end):
                whole = (node.start_byte, node.end_byte)
                return either(*whole, text(whole[0], start) + mutant.new + text(end, whole[1]))
        if node.type == "match_arm" and mutant.genre == "MatchArm" and node.start_byte == start:
            pattern = node.child_by_field_name("pattern")
            guard = pattern.child_by_field_name("condition")
            if guard:
                return guard.start_byte, guard.end_byte, f"!crate::mutant({k}) && (", ")"
            return pattern.start_byte, pattern.end_byte, "", f" if !crate::mutant({k})"
        if node.type == "field_initializer" and mutant.genre == "StructField" and node.start_byte == start:
            rest = next(n for n in node.parent.children if n.type == "base_field_initializer")
            value, field = node.child_by_field_name("value"), node.child_by_field_name("field")
            other = f"({text(rest.start_byte + 2, rest.end_byte)}).{text(field.start_byte, field.end_byte)}"
            return either(value.start_byte, value.end_byte, other)
    return None


def with_switches(source, wraps):
    """Source with all its switches. If two begin or end at the same place, the longer one is outside."""
    puts = []
    for k, (start, end, before, behind) in enumerate(wraps):
        puts.append((start, 1, start - end, k, before))
        puts.append((end, 0, end - start, -k, behind))
    out, last = [], 0
    for at, *_, text in sorted(puts):
        out += [source[last:at], text.encode()]
        last = at
    return b"".join([*out, source[last:]])


def put(path, content):
    """Writes the changed files only, so that the build is incremental."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != content:
        path.write_bytes(content)


def lay_out(mutants, alone=None):
    """Writes the tree with the switches of all mutants, or with one mutant. Returns the mutants without a switch."""
    left = []
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True).stdout
    by_file = collections.defaultdict(list)
    for m in mutants:
        by_file[m.file].append(m)
    libraries = {name.split("src/")[0] + "src/lib.rs" for name in by_file} if alone is None else set()
    names = tracked.decode().strip("\0").split("\0")
    for stale in set(TREE.glob("*/**/*.rs")) - {TREE / name for name in names} - set(TREE.glob("target/**/*.rs")):
        stale.unlink()
    for name in names:
        source = (ROOT / name).read_bytes()
        if alone and alone.file == name:
            source = source[: alone.start] + alone.new.encode() + source[alone.end :]
        elif alone is None and name in by_file:
            tree = RUST.parse(source)
            wraps = [(m, switched(m, source, tree)) for m in by_file[name]]
            left += [m for m, wrap in wraps if wrap is None]
            source = with_switches(source, [wrap for _, wrap in wraps if wrap])
        if name in libraries:
            source += SWITCH.encode()
        put(TREE / name, source)
    return left


def built(areas):
    """Test programs by package and name, and the errors of the compiler."""
    programs = {(package, name) for area in areas for package, name, _ in AREAS[area].first + AREAS[area].then}
    packages = [argument for package in sorted({p for p, _ in programs}) for argument in ("-p", package)]
    kinds = [argument for name in sorted({n for _, n in programs}) for argument in KINDS[name]]
    command = ["cargo", "test", "--no-run", "--release", "--message-format=json", *packages, *kinds]
    environment = {**os.environ, "CARGO_INCREMENTAL": "1"}
    run = subprocess.run(command, cwd=TREE, env=environment, stdout=subprocess.PIPE, text=True)
    messages = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
    errors = [m["message"] for m in messages if m["reason"] == "compiler-message" and m["message"]["level"] == "error"]
    if run.returncode and not errors:
        raise SystemExit("the tree does not build")
    found = {}
    for m in messages:
        if m.get("executable") and m["profile"]["test"]:
            folder = pathlib.Path(m["manifest_path"]).parent
            package = re.search(r'^name = "(.*)"', (folder / "Cargo.toml").read_text(), re.M)[1]
            found[package, "lib" if "lib" in m["target"]["kind"] else m["target"]["name"]] = (m["executable"], folder)
    return found, errors


def culprits(errors):
    """Numbers of the switches with compiler errors."""
    out = set()
    for error in errors:
        for span in error["spans"]:
            before = (TREE / span["file_name"]).read_bytes()[: span["byte_end"]]
            numbers = re.findall(rb"crate::mutant\((\d+)\)", before)
            if span["is_primary"] and numbers:
                out.add(int(numbers[-1]))
    return out


def build_of_all(mutants, areas):
    """Test programs with all mutants that compile as switches, and the other mutants."""
    alone, active = [], mutants
    while True:
        left = lay_out(active)
        programs, errors = built(areas)
        bad = culprits(errors) | {m.number for m in left}
        alone += [m for m in active if m.number in bad]
        active = [m for m in active if m.number not in bad]
        if not errors:
            return programs, active, alone
        if not culprits(errors):
            raise SystemExit("\n".join(e["rendered"] for e in errors))
        print(f"{len(alone)} mutants are built alone", flush=True)


def failing(program, filters, number):
    """First test that fails or does not end; None if all pass."""
    executable, folder = program
    environment = {**os.environ, "GAITCAM_MUTANT": str(number), "CARGO_MANIFEST_DIR": str(folder)}
    run = subprocess.Popen([executable, *filters], cwd=folder, env=environment, text=True, start_new_session=True,
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    late = threading.Event()

    def end():
        late.set()
        os.killpg(run.pid, signal.SIGKILL)

    timer = threading.Timer(TIMEOUT, end)
    timer.start()
    try:
        for line in run.stdout:
            if fails := re.match(r"test (\S+).* \.\.\. FAILED", line):
                os.killpg(run.pid, signal.SIGKILL)
                return fails[1]
        code = run.wait()
    finally:
        timer.cancel()
        run.stdout.close()
        run.wait()
    return "time" if late.is_set() else "abort" if code else None


def outcome(mutant, programs, number):
    """Outcome of a mutant: caught, with the test that caught it, or missed."""
    area = AREAS[mutant.area]
    for package, name, filters in area.first + area.then:
        if test := failing(programs[package, name], filters, number):
            return "timeout" if test == "time" else "caught", test
    return "missed", ""


def tried(mutants, areas):
    """Every mutant with its outcome."""
    programs, active, alone = build_of_all(mutants, areas)
    for area in areas:
        plain = Mutant(0, area, *[None] * 7)
        result = outcome(plain, programs, 0)
        if result[0] != "missed":
            raise SystemExit(f"{area}: the tests fail without a mutant: {result[1]}")
    for m in active:
        yield m, *outcome(m, programs, m.number)
    for m in alone:
        lay_out([], m)
        programs, errors = built([m.area])
        yield m, *(("unviable", "") if errors else outcome(m, programs, 0))


def plain_name(name):
    """Name of a mutant without line and column, which change."""
    return re.sub(r":\d+:\d+:", ":", name)


COLUMNS = ["area", "mutant", "outcome", "by", "reason"]
OPEN = ("missed", "not tried")


def place(name):
    """Column and line of a mutant; 0 for a fault, which has only a name."""
    found = re.search(r":(\d+):(\d+):", name)
    return (int(found[2]), int(found[1])) if found else (0, 0)


def still_open(mutants, rows):
    """Mutants of the table that survived or were not tried. Of several with the same name in a function, the nearest one is used."""
    out = {}
    for row in (r for r in rows if r["outcome"] in OPEN):
        column, line = place(row["mutant"])
        same = [m for m in mutants if plain_name(m.name) == plain_name(row["mutant"]) and m.number not in out]
        away = lambda m: (abs(place(m.name)[0] - column), abs(place(m.name)[1] - line))
        if same:
            nearest = min(same, key=away)
            out[nearest.number] = nearest
    return [out[k] for k in sorted(out)]


def stored():
    """Table of the last run."""
    if not TABLE.exists():
        return []
    with TABLE.open(newline="") as file:
        return list(csv.DictReader(file))


def store(rows):
    with TABLE.open("w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def page(rows, sizes):
    """Writes reports/mutation.md."""
    out = [HEAD, "| area | mutants | drawn | not tried | do not compile | caught | survive | caught of those tried that compile |",
           "|---|---:|---:|---:|---:|---:|---:|---:|"]
    for area in [*AREAS, "all"]:
        own = [r for r in rows if area in (r["area"], "all")]
        count = collections.Counter(r["outcome"] for r in own)
        caught, viable = count["caught"] + count["timeout"], len(own) - count["unviable"] - count["not tried"]
        size = sum(sizes.values()) if area == "all" else sizes[area]
        share = f"{100.0 * caught / viable:.0f} %" if viable else ""
        out.append(f"| {area} | {size} | {len(own)} | {count['not tried']} | {count['unviable']} | {caught} | {count['missed']} | {share} |")
    out += ["", "## Survivors", "", "| mutant | why no test fails |", "|---|---|"]
    escaped = lambda text: text.replace("|", "\\|")
    out += [f"| {escaped(r['mutant'])} | {escaped(r['reason'])} |" for r in rows if r["outcome"] == "missed"]
    by_hand = {f.name: f.area for f in FAULTS}
    out += ["", "## Faults written by hand", "", "| fault | area | outcome | by |", "|---|---|---|---|"]
    mine = [r for r in rows if r["mutant"] in by_hand]
    out += [f"| {r['mutant']} | {r['area']} | {r['outcome']} | {r['by']} |" for r in mine]
    TABLE.with_suffix(".md").write_text("\n".join(out) + "\n")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("areas", nargs="*", metavar="AREA")
    arguments.add_argument("--all", action="store_true", help="every mutant instead of the sample")
    arguments.add_argument("--again", action="store_true", help="only what the table has as survivor or not tried")
    given = arguments.parse_args()
    areas = given.areas or list(AREAS)
    mutants = numbered(areas, given.all or given.again)
    before = stored()
    if given.again:
        mutants = still_open(mutants, before)
    reasons = {plain_name(r["mutant"]): r["reason"] for r in before}
    kept = lambda r: r["area"] not in areas or given.again and r["outcome"] not in OPEN
    rows = [r for r in before if kept(r)]
    for m, result, by in tried(mutants, areas):
        reason = reasons.get(plain_name(m.name), "") if result == "missed" else ""
        rows.append(dict(zip(COLUMNS, [m.area, m.name, result, by, reason])))
        print(f"{result:8} {m.name}  {by}", flush=True)
        store(sorted(rows, key=lambda r: list(AREAS).index(r["area"])))
    page(rows, {area: drawn(area, False)[1] for area in AREAS})


if __name__ == "__main__":
    main()
