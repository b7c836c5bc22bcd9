#!/usr/bin/env python3
"""Measures the structure of the source and prints a table for a commit.

    lab/measure.py [COMMIT ...]     without a commit: the tracked files of the working tree
    lab/measure.py --check          fails for import cycles, and for public names that differ from lab/api.txt
    lab/measure.py --store          writes lab/api.txt

Product code lines are the lines of `src/*.rs`, `crates/*.rs` and `python/*.rs` that are neither blank nor comments, up to the first
`#[cfg(test)]` of a file. Tests, examples, fuzz targets and the lab are excluded.
"""

import collections
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
API = ROOT / "lab" / "api.txt"
NOT_PRODUCT = re.compile(r"^crates/evidence/|^lab/|(^|/)tests/|tests\.rs$|^crates/test-support/|/examples/|/fuzz/")


class Tree:
    """Files of a commit, or of the working tree."""

    def __init__(self, commit):
        self.commit = commit
        listing = ["ls-tree", "-r", "--name-only", commit] if commit else ["ls-files"]
        self.names = [name for name in git(*listing).splitlines() if commit or (ROOT / name).is_file()]
        self.texts = {}
        if commit:
            self.texts = blobs(commit, [name for name in self.names if name.endswith((".rs", ".ftl", ".toml"))])

    def text(self, name):
        return self.texts[name] if self.commit else (ROOT / name).read_text(encoding="utf-8")


def git(*arguments, given=None):
    done = subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True, input=given)
    return done.stdout.decode("utf-8", errors="replace")


def blobs(commit, names):
    """Texts of files of a commit, read by one process."""
    given = "".join(f"{commit}:{name}\n" for name in names).encode()
    done = subprocess.run(["git", "cat-file", "--batch"], cwd=ROOT, check=True, capture_output=True, input=given)
    out, texts, at = done.stdout, {}, 0
    for name in names:
        end = out.index(b"\n", at)
        size = int(out[at:end].split()[2])
        texts[name] = out[end + 1:end + 1 + size].decode("utf-8")
        at = end + 2 + size
    return texts


# --- lines -------------------------------------------------------------------------------------

def is_product(name):
    return name.endswith(".rs") and name.startswith(("src/", "crates/", "python/")) and not NOT_PRODUCT.search(name)


def code_lines(text):
    """Number of lines that are neither blank nor comments nor tests. Tests are in separate files or at the end of a file."""
    count, lines = 0, iter(text.splitlines())
    for line in lines:
        if line.startswith("#[cfg(test)]"):
            if not next(lines, "").endswith(";"):
                break
            continue
        stripped = line.strip()
        count += bool(stripped) and not stripped.startswith("//")
    return count


def part(name):
    places = name.split("/")
    if places[0] == "crates":
        return "/".join(places[:2])
    return places[0] if places[0] == "python" or len(places) < 3 else "/".join(places[:2])


def lines_by_part(tree):
    parts = collections.Counter()
    for name in filter(is_product, tree.names):
        parts[part(name)] += code_lines(tree.text(name))
    return parts


# --- imports -----------------------------------------------------------------------------------

def code(text):
    """Text of a file without comments and tests."""
    text = re.sub(r"(?m)//.*$", "", text)
    text = re.sub(r"#\[cfg\(test\)\]\s*(#\[[^\]]*\]\s*)*(pub(\([a-z]+\))? )?(mod|use) [^;{]*;", "", text)
    return re.split(r"#\[cfg\(test\)\]\s*(?:#\[[^\]]*\]\s*)*mod \w+ \{", text)[0]


def paths_of(text):
    """All paths that begin with `crate` or `super`, one for each name in braces."""
    for found in re.finditer(r"(?<![\w:])(crate|super)((?:::super)*)::", text):
        yield from expanded(found.group()[:-2].split("::"), text, found.end())


def expanded(before, text, at):
    if at < len(text) and text[at] == "{":
        depth, start, at = 1, at + 1, at + 1
        while depth:
            if text[at] == "{":
                depth += 1
            elif text[at] == "}":
                depth -= 1
            if (text[at] == "," and depth == 1) or depth == 0:
                piece = text[start:at].strip()
                if piece:
                    yield from expanded(before, piece, 0)
                start = at + 1
            at += 1
        return
    name = re.match(r"\w+", text[at:])
    if not name or name.group() == "self":
        yield before
        return
    after = at + name.end()
    if text[after:after + 2] == "::":
        yield from expanded([*before, name.group()], text, after + 2)
    else:
        yield [*before, name.group()]


def modules(tree):
    """Mapping of the library: module path -> file."""
    out = {}
    for name in tree.names:
        if not name.startswith("src/") or not is_product(name) or name in ("src/lib.rs", "src/main.rs"):
            continue
        places = name.removeprefix("src/").removesuffix(".rs").split("/")
        out["::".join(places[:-1] if places[-1] == "mod" else places)] = name
    return out


PASSED_ON = re.compile(r"(?m)^\s*pub(?:\([^)]*\))? use ([^;]*);")


def absolute(path, own, known):
    """Absolute path from the root of the library."""
    if path[0] == "crate":
        return path[1:]
    ups = path.count("super")
    if ups:
        return own[:len(own) - ups] + path[ups:]
    return own + path if "::".join([*own, path[0]]) in known else path


def imports(tree):
    """Mapping of the library: module -> imported modules. A re-exported name counts for the file that defines it."""
    known = modules(tree)
    texts = {module: code(tree.text(name)) for module, name in known.items()}
    passed_on = {}
    for module, text in texts.items():
        own = module.split("::")
        for list_ in PASSED_ON.findall(text):
            for path in expanded([], list_, 0):
                passed_on[module, path[-1]] = absolute(path, own, known)

    def home(path):
        """Module that defines the item of a path."""
        at = 0
        while at < len(path) and "::".join(path[:at + 1]) in known:
            at += 1
        module = "::".join(path[:at])
        further = passed_on.get((module, path[at])) if module and at < len(path) else None
        return home([*further, *path[at + 1:]]) if further and further[:at + 1] != path[:at + 1] else module

    out = {}
    for module, text in texts.items():
        own = module.split("::")
        text = PASSED_ON.sub("", text)
        children = [path for path in plain_paths(text) if "::".join([*own, path[0]]) in known]
        named = [absolute(path, own, known) for path in [*paths_of(text), *children]]
        out[module] = {home(path) for path in named} - {module, ""}
    return out


def plain_paths(text):
    """All paths that begin with neither `crate` nor `super`."""
    for found in re.finditer(r"(?<![\w:])([a-z_][a-z0-9_]*)::(?=[\w{])", text):
        if found.group(1) not in ("crate", "super", "self", "std"):
            yield from expanded([found.group(1)], text, found.end())


def circles(graph):
    """Strongly connected sets of more than one file (Tarjan)."""
    index, low, stack, on, out = {}, {}, [], set(), []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        on.add(node)
        for other in graph[node]:
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in on:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            found = []
            while not found or found[-1] != node:
                found.append(stack.pop())
                on.discard(found[-1])
            if len(found) > 1:
                out.append(sorted(found))

    sys.setrecursionlimit(10_000)
    for node in graph:
        if node not in index:
            visit(node)
    return sorted(out)


# --- the public surface ------------------------------------------------------------------------

PUBLIC = re.compile(r"(?m)^pub (?:const |unsafe |async )*(fn|struct|enum|trait|type|const|static|mod) (\w+)")


def public_names(tree):
    """Public names of the library: items of public modules, and re-exports, without methods and fields."""
    known = {module: code(tree.text(name)) for module, name in modules(tree).items()}
    known[""] = code(tree.text("src/lib.rs"))
    out = set()

    def visit(module):
        text = known[module]
        for kind, name in PUBLIC.findall(text):
            inner = f"{module}::{name}" if module else name
            out.add(inner)
            if kind == "mod" and inner in known:
                visit(inner)
        for found in re.finditer(r"(?m)^pub use ", text):
            for path in expanded([], text[:text.index(";", found.end())], found.end()):
                out.add(f"{module}::{path[-1]}" if module else path[-1])

    visit("")
    return out


# --- the rest ----------------------------------------------------------------------------------

def published(tree):
    manifests = [n for n in tree.names if re.fullmatch(r"(?:[\w-]+/){0,2}Cargo\.toml", n) and "/fuzz/" not in n]
    texts = [tree.text(n) for n in manifests]
    return [re.search(r'(?m)^name = "(.*?)"', t).group(1) for t in texts
            if "[package]" in t and "publish = false" not in t and "edition.workspace" in t]


def messages(tree):
    """Message identifiers of the English and of all Fluent files."""
    files = [n for n in tree.names if n.endswith(".ftl")]
    count = lambda n: len(re.findall(r"(?m)^[a-z][\w-]* =", tree.text(n)))
    english = [n for n in files if "/en/" in n or n.endswith("/en.ftl")]
    return sum(map(count, english)), sum(map(count, files))


def measure(commit):
    tree = Tree(commit)
    parts = lines_by_part(tree)
    graph = imports(tree)
    found = circles(graph)
    names = public_names(tree)
    english, both = messages(tree)
    crates = published(tree)
    print(f"## {commit or 'working tree'}\n\n| part | product code lines |\n|---|---|")
    for name, count in sorted(parts.items(), key=lambda p: -p[1]):
        print(f"| {name} | {count} |")
    print(f"| **all** | **{sum(parts.values())}** |\n")
    print("| measure | value |\n|---|---|")
    print(f"| circles of files in src | {len(found)} |")
    print(f"| public names of gaitcam | {len(names)} |")
    print(f"| published crates | {len(crates)}: {', '.join(sorted(crates))} |")
    print(f"| messages, English / all | {english} / {both} |\n")
    for circle in found:
        print(f"- circle: {', '.join(circle)}")
    print()
    return {"lines": sum(parts.values()), "circles": len(found), "public": len(names), "published": len(crates), "messages": english}


def check():
    """Forbidden contents of the working tree."""
    tree = Tree(None)
    for circle in circles(imports(tree)):
        yield f"files import each other: {', '.join(circle)}"
    stored, names = set(API.read_text(encoding="utf-8").split()), public_names(tree)
    yield from (f"{name} is public and not in lab/api.txt: lab/measure.py --store" for name in sorted(names - stored))
    yield from (f"{name} is in lab/api.txt and not public: lab/measure.py --store" for name in sorted(stored - names))


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        faults = list(check())
        print("\n".join(faults) or "structure: ok")
        sys.exit(bool(faults))
    elif sys.argv[1:] == ["--store"]:
        API.write_text("\n".join(sorted(public_names(Tree(None)))) + "\n", encoding="utf-8")
    else:
        for one in sys.argv[1:] or [None]:
            measure(one)
