#!/usr/bin/env python3
"""Preprocessor of the book: replaces a link to a file that is not a page of the book by the name of the file.

A picture from outside docs/ is embedded in the page.

mdBook calls this preprocessor (docs/book.toml). Such links work on the pages of the repository, but not in the book.
"""

import base64
import json
import re
import sys
from pathlib import Path
from posixpath import join, dirname, normpath

DOCS = Path(__file__).resolve().parent


def chapters(items):
    for item in items:
        chapter = item.get("Chapter") if isinstance(item, dict) else None
        if chapter:
            yield chapter
            yield from chapters(chapter["sub_items"])


def main():
    _, book = json.load(sys.stdin)
    found = list(chapters(book.get("items") or book["sections"]))
    pages = {chapter["path"] for chapter in found}
    for chapter in found:

        def inside(link, folder=dirname(chapter["path"])):
            target = normpath(join(folder, link.group(2)))
            if target in pages or (not target.startswith("..") and not target.endswith(".md")):
                return link.group()
            return f"{link.group(1)} (`{target.removeprefix('../')}`)"

        def picture(link, folder=dirname(chapter["path"])):
            data = base64.b64encode((DOCS / folder / link.group(2)).read_bytes()).decode()
            return f"{link.group(1)}(data:image/svg+xml;base64,{data})"

        chapter["content"] = re.sub(r"(!\[[^\]\n]*\])\(((?:\.\./)+reports/\S+\.svg)\)", picture, chapter["content"])
        chapter["content"] = re.sub(r"(?<!!)\[([^\]\n]+)\]\((?![a-z]+:|#)([^)#\s]+)(#[^)\s]*)?\)", inside, chapter["content"])
    json.dump(book, sys.stdout)


if __name__ == "__main__":
    if sys.argv[1:2] != ["supports"]:  # it serves every renderer
        main()
