#!/usr/bin/env python3
"""Checks that the targets of all references in documents and comments exist.

    python3 docs/check.py
    python3 docs/check.py --book target/book      the links of the HTML that docs/book.sh has built

- `theory §n` anywhere in the repository is a section of docs/theory/;
- a path such as `src/law/rise.rs` in README, CONTRIBUTING and docs/ is the path of a file or folder;
- a relative link in a Markdown file leads to a file, and its #anchor to a heading;
- every number with a decimal point (in Spanish a comma) or with four digits or more in the paragraph after `<!-- from FILE -->` occurs in this
  file, up to rounding of decimals;
- every number with four digits or more and a decimal point in docs/theory/ occurs, up to rounding and powers of a
  thousand, in a test, a source or a report, unless `docs/commands.py` computes it (`<!-- printed by`);
- no text cites a document that is not in the repository;
- the README installs and tests with the commands of `.ci/run`;
- every published crate (without `publish = false`) has description, README, keywords and both licences.
"""

import bisect
import re
import sys
import tomllib
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parent.parent
TEXT = {".rs", ".md", ".toml", ".py", ".ftl", ".html", ".js", ".css"}
SKIP = {"target", ".git", "out", "corpus", "node_modules", ".venv", "dist"}
FIGURE = r"\d+(?:\.\d+)+|\d{4,}"
# Abbreviations of documents that are not in the repository.
FOREIGN = re.compile(r"\b(FACTS|INTERFACE\.md|DESIGN\.md|STYLE\.md)\b|\b[Tt]hesis 00\d|\b[Pp]aper 00\d")


def files():
    for path in sorted(ROOT.rglob("*")):
        parts = path.relative_to(ROOT).parts
        if path.suffix in TEXT and path.is_file() and not SKIP.intersection(parts):
            yield path


def anchors(text):
    """Anchors that GitHub generates for the headings of a Markdown text."""
    out = set()
    for heading in re.findall(r"(?m)^#+ +(.*?)\s*$", re.sub(r"(?ms)^```.*?^```", "", text)):
        plain = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        out.add(re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-"))
    return out


def broken_links(path, text):
    for link in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"(?ms)^```.*?^```|`[^`\n]*`", "", text)):
        if re.match(r"[a-z]+:", link):
            continue
        target, _, anchor = unquote(link).partition("#")
        file = (path.parent / target).resolve() if target else path
        if not file.exists():
            yield f"link to {target}, which does not exist"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text(encoding="utf-8")):
            yield f"link to #{anchor}, which is no heading of {file.name}"


def decimals_of(text):
    return sorted({float(number) for number in re.findall(r"\d+\.\d+", text)})


def holds(known, number, scale=1):
    """Whether one of the known numbers, times `scale`, equals this number up to rounding."""
    last = 0.5001 * 10 ** -len(number.split(".")[1])
    i = bisect.bisect_left(known, (float(number) - last) / scale)
    return i < len(known) and known[i] * scale <= float(number) + last


def changed_figures(path, text):
    for source, paragraph in re.findall(r"(?ms)^<!-- from (\S+) -->\n(.*?)(?:\n\n|\Z)", text):
        text_of_source = (path.parent / source).read_text(encoding="utf-8")
        if "guia" in path.parts:
            paragraph = re.sub(r"(\d),(\d)", r"\1.\2", paragraph)
        known, decimals = set(re.findall(FIGURE, text_of_source)), decimals_of(text_of_source)
        for number in re.findall(FIGURE, paragraph):
            if number not in known and not (number.count(".") == 1 and holds(decimals, number)):
                yield f"{number}, which {source} does not have"


def unknown_figures(theory):
    """Numbers of the theory that no test, source or report contains."""
    places = ["src", "tests", "crates", "lab", "reports", "data"]
    texts = (path.read_text(encoding="utf-8", errors="ignore") for place in places for path in (ROOT / place).rglob("*")
             if path.suffix in (".rs", ".md", ".csv") and not SKIP.intersection(path.relative_to(ROOT).parts))
    known = decimals_of("\n".join(texts).replace("_", ""))
    computed = r"(?ms)^<!-- printed.*?-->\n.*?(?:\n\n|\Z)|`[^`\n]*`|\]\([^)]*\)|§[\d.]+|arXiv [\d.]+"
    for number in re.findall(r"(?<![\w.])\d+\.\d+(?!\d*/)", re.sub(computed, "\n", theory)):
        if len(number.replace(".", "").lstrip("0")) >= 4 and not any(holds(known, number, s) for s in (1e-3, 1, 1e3)):
            yield f"docs/theory: {number}, which no test, source or report has"


def faults(path, sections):
    text = path.read_text(encoding="utf-8")
    for list_ in re.findall(r"theory((?:,? (?:and )?§\d+(?:[–-]§?\d+)?)+)", text):
        for number in re.findall(r"\d+", list_):
            if int(number) not in sections:
                yield f"theory §{number}, which docs/theory/ does not have"
    if path != Path(__file__).resolve():
        for found in FOREIGN.finditer(text):
            yield f"`{found.group()}`, which is not in the repository"
    if path.suffix == ".md":
        yield from broken_links(path, text)
        yield from changed_figures(path, text)
    if path.suffix == ".md" and path.relative_to(ROOT).parts[0] in ("README.md", "CONTRIBUTING.md", "docs"):
        for named in re.findall(r"`((?:src|crates|tests|docs|scenes|data|fuzz|lab)/[a-z0-9_./]+)`", text):
            if not (ROOT / named).exists():
                yield f"`{named}`, which does not exist"


class Links(HTMLParser):
    """Targets of the links in a page of HTML, and its anchors."""

    def __init__(self, path):
        super().__init__()
        self.links, self.ids = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.ids.add(given.get("id"))
        if tag != "base":
            self.links += [given[name] for name in ("href", "src") if given.get(name)]


def broken_book_links(folder):
    pages = {path: Links(path) for path in sorted(folder.rglob("*.html")) if path.name not in ("404.html", "toc.html")}
    for path, page in pages.items():
        for link in page.links:
            target, _, anchor = unquote(link).partition("#")
            file = (path.parent / target).resolve() if target else path
            if re.match(r"[a-z]+:|//", link):
                continue
            if not file.is_file() or folder not in file.parents:
                yield f"{path.relative_to(folder)}: link to {link}, which is not in the book"
            elif anchor and file in pages and anchor not in pages[file].ids:
                yield f"{path.relative_to(folder)}: link to {link}, an anchor that the page does not have"
    print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links")


def install_faults():
    """Commands for a new machine: in the first block of the README's section Install, and in .ci/run."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    block = re.search(r"(?ms)^## Install$.*?^```sh\n(.*?)^```$", readme)
    shown = [line.split("#")[0].strip() for line in (block.group(1) if block else "").splitlines()]
    run = [line.strip() for line in (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()]
    for command in ("cargo run --release", "cargo test --release"):
        if command not in shown:
            yield f"README.md: the Install block lacks `{command}`"
        if not any(line == command or line.startswith(f"{command} -- ") for line in run):
            yield f".ci/run: does not run `{command}`, which the README shows"


def package_faults():
    """Missing requirements of a published crate."""
    for manifest in [ROOT / "Cargo.toml", *sorted(ROOT.glob("*/Cargo.toml")), *sorted(ROOT.glob("crates/*/Cargo.toml"))]:
        package = tomllib.loads(manifest.read_text(encoding="utf-8"))["package"]
        if package.get("publish", True):
            lacking = [key for key in ("description", "readme", "keywords", "categories") if key not in package]
            lacking += [name for name in ("README.md", "LICENSE-MIT", "LICENSE-APACHE") if not (manifest.parent / name).is_file()]
            yield from (f"{manifest.relative_to(ROOT)}: without {name}" for name in lacking)


def main():
    if sys.argv[1:2] == ["--book"]:
        found = list(broken_book_links(Path(sys.argv[2]).resolve()))
        sys.exit("\n".join(found) or 0)
    theory = "\n".join(page.read_text(encoding="utf-8") for page in sorted((ROOT / "docs" / "theory").glob("*.md")))
    sections = {int(n) for n in re.findall(r"(?m)^## (\d+)\. ", theory)}
    found = [f"{p.relative_to(ROOT)}: {f}" for p in files() for f in faults(p, sections)]
    found += [*install_faults(), *package_faults(), *unknown_figures(theory)]
    if found:
        sys.exit("\n".join(found))


if __name__ == "__main__":
    main()
