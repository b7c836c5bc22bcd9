#!/usr/bin/env python3
"""Checks that what the documents and comments point at exists.

    python3 docs/check.py

- `theory §n` anywhere in the repository is a section of docs/theory.md;
- a path such as `src/law/rise.rs` in README, CONTRIBUTING and docs/ is that of a file or folder;
- a relative link in a Markdown file leads to a file, and its #anchor to a heading;
- nothing cites a document that is not in the repository.
"""

import re
import sys
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parent.parent
TEXT = {".rs", ".md", ".toml", ".py", ".ftl", ".html", ".js", ".css"}
SKIP = {"target", ".git", "out", "corpus", "node_modules", ".venv"}
# Short names of documents that only their writers had.
FOREIGN = re.compile(r"\b(FACTS|INTERFACE\.md|DESIGN\.md|STYLE\.md)\b|\b[Tt]hesis 00\d|\b[Pp]aper 00\d")


def files():
    for path in sorted(ROOT.rglob("*")):
        parts = path.relative_to(ROOT).parts
        if path.suffix in TEXT and path.is_file() and not SKIP.intersection(parts):
            yield path


def anchors(text):
    """The anchors that GitHub gives the headings of a Markdown text."""
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


def faults(path, sections):
    text = path.read_text(encoding="utf-8")
    for list_ in re.findall(r"theory((?:,? (?:and )?§\d+(?:[–-]§?\d+)?)+)", text):
        for number in re.findall(r"\d+", list_):
            if int(number) not in sections:
                yield f"theory §{number}, which docs/theory.md does not have"
    if path != Path(__file__).resolve():
        for found in FOREIGN.finditer(text):
            yield f"`{found.group()}`, which is not in the repository"
    if path.suffix == ".md":
        yield from broken_links(path, text)
    if path.suffix == ".md" and path.relative_to(ROOT).parts[0] in ("README.md", "CONTRIBUTING.md", "docs"):
        for named in re.findall(r"`((?:src|crates|tests|docs|scenes|data|fuzz|benches)/[a-z0-9_./]+)`", text):
            if not (ROOT / named).exists():
                yield f"`{named}`, which does not exist"


def main():
    theory = (ROOT / "docs" / "theory.md").read_text(encoding="utf-8")
    sections = {int(n) for n in re.findall(r"(?m)^## (\d+)\. ", theory)}
    found = [f"{p.relative_to(ROOT)}: {f}" for p in files() for f in faults(p, sections)]
    if found:
        sys.exit("\n".join(found))


if __name__ == "__main__":
    main()
