#!/usr/bin/env python3
"""Selects doc comments and sentences at random, for the judgement of a second reader.

    lab/sample.py [--seed 60] [--comments 200] [--sentences 200]

A doc comment is one block of `///` or `//!` lines of product code, without its code examples. A sentence is one of the
Markdown documents written by hand, without tables, headings, code and lists of literature, or a message of an English `.ftl` file. Each item
is printed with its number, file and line. The same seed and the same commit give the same items.
"""

import argparse
import random
import re
import textwrap

from measure import NOT_PRODUCT, Tree

GENERATED = re.compile(r"^reports/|^docs/keys\.md$|^docs/reference/(?:commands|laws)\.md$|^docs/SUMMARY\.md$")
NOT_ENGLISH = re.compile(r"^docs/guia/|/es/|/es\.ftl$|/LEEME\.md$")
# A full stop after an abbreviation or before a small letter or a number does not end a sentence.
SENTENCE = re.compile(r"\S.*?(?:(?<!\b[a-zA-Z])(?<!\beq)(?<!\bal)(?<!\bfig)[.?!](?=\s+[A-Z`*\[]|\s*$)|$)", re.S)
LITERATURE = re.compile(r"(?ms)^#+ Literature$.*")


def blank(text, pattern):
    """Text without the matches, with the same number of lines."""
    return re.sub(pattern, lambda match: "\n" * match[0].count("\n"), text)


def line(text, position):
    return text.count("\n", 0, position) + 1


def comments(name, text):
    text = re.split(r"(?m)^\s*#\[cfg\(test\)\]\s*mod \w+ \{", text)[0]
    for block in re.finditer(r"(?m)(?:^[ \t]*//[/!](?!/).*\n)+", text):
        words = re.sub(r"(?m)^[ \t]*//[/!] ?", "", block[0])
        words = blank(words, r"(?ms)^```.*?^```").strip()
        if words:
            yield name, line(text, block.start()), words


def sentences(name, text):
    text = blank(LITERATURE.sub("", text), r"(?s)<!--.*?-->|(?<=\n)```.*?\n```(?=\n)")
    for paragraph in re.finditer(r"(?:^.*\S.*(?:\n|$))+", text, re.M):
        for part in re.finditer(r"(?ms)^(?!\||#|\s*<|\$\$)(?:[ \t]*(?:[-*]|\d+\.) )?.*?(?=^\||^\s*(?:[-*]|\d+\.) |\Z)", paragraph[0]):
            for sentence in SENTENCE.finditer(part[0]):
                if len(sentence[0].split()) > 2:
                    yield name, line(text, paragraph.start() + part.start() + sentence.start()), sentence[0]


def messages(name, text):
    for message in re.finditer(r"(?m)^[a-zA-Z][\w-]* *= *(.*\n(?:[ \t]+.*\n?)*)", text):
        if len(message[1].split()) > 2:
            yield name, line(text, message.start()), message[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name, number in (("seed", 60), ("comments", 200), ("sentences", 200)):
        parser.add_argument(f"--{name}", type=int, default=number, metavar="N")
    options = parser.parse_args()
    tree, documented, written = Tree(None), [], []
    for name in tree.names:
        if re.match(r"(?:crates/[^/]+/|python/)?src/.*\.rs$", name) and not NOT_PRODUCT.search(name):
            documented += comments(name, tree.text(name))
        elif name.endswith(".md") and not GENERATED.search(name) and not NOT_ENGLISH.search(name):
            written += sentences(name, tree.text(name))
        elif name.endswith(".ftl") and not NOT_ENGLISH.search(name):
            written += messages(name, tree.text(name))
    draw = random.Random(options.seed)
    for kind, items, number in (("doc comments", documented, options.comments), ("sentences", written, options.sentences)):
        print(f"\n{min(number, len(items))} of {len(items)} {kind}\n")
        for i, (name, at, words) in enumerate(draw.sample(items, min(number, len(items))), 1):
            print(textwrap.fill(f"{i}. {name}:{at}: {' '.join(words.split())}", 160, break_on_hyphens=False, break_long_words=False))


if __name__ == "__main__":
    main()
