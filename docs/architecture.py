#!/usr/bin/env python3
"""Draws docs/architecture.svg from the imports in the sources.

    python3 docs/architecture.py            writes the picture
    python3 docs/architecture.py --check    fails if the committed picture is stale

A box is a top-level module of the library (src/) or a crate (crates/*). Crates that use the library are above it, crates that it uses are
below it. An arrow points from a module to an imported module. Arrows that follow from others are left out (transitive reduction). A module
is one layer above its highest import. Comments and tests are ignored.
"""

import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs" / "architecture.svg"

WIDTH = 1000
MARGIN = 24
BOX = 46          # height of a box
GAP = 44          # between layers
SPACE = 12        # least distance between neighbours in a layer
SLOT = 10         # width kept free for an arrow that passes a layer
LIBRARY = "gaitcam"


# --- reading -----------------------------------------------------------------------------------

def code(path):
    """Text of a source file without comments, doc comments and tests."""
    text = path.read_text(encoding="utf-8")
    text = re.sub(r"(?m)//.*$", "", text)
    text = re.sub(r"#\[cfg\(test\)\]\s*(#\[[^\]]*\]\s*)*(pub(\([a-z]+\))? )?(mod|use) [^;{]*;", "", text)
    return re.split(r"#\[cfg\(test\)\]\s*(?:#\[[^\]]*\]\s*)*mod \w+ \{", text)[0]


def first_names(text, root):
    """Names that follow `root::` in the text, each with the rest of its path."""
    for found in re.finditer(r"(?<![\w:])" + root + r"::", text):
        at = found.end()
        if text[at] != "{":
            yield re.match(r"[\w:{, ]*", text[at:]).group()
            continue
        depth, start = 0, at + 1
        for i in range(at, len(text)):
            if text[i] == "{":
                depth += 1
            elif text[i] == "}":
                depth -= 1
            if (text[i] == "," and depth == 1) or depth == 0:
                yield text[start:i].strip()
                start = i + 1
            if depth == 0:
                break


def sources(folder):
    skip = re.compile(r"(^|/)(tests?|\w+_tests?)(/|\.rs$)")
    return [p for p in sorted(folder.rglob("*.rs")) if not skip.search(str(p.relative_to(folder)))]


def folders(module):
    """Folders of a module that contain more than tests."""
    return sorted(p.name for p in module.iterdir() if p.is_dir() and sources(p)) if module.is_dir() else []


def library():
    """Modules of the library with their imports and folders."""
    src = ROOT / "src"
    files = [p for p in sources(src) if p.parent != src or p.stem not in ("lib", "main")]
    modules = sorted({p.relative_to(src).parts[0].removesuffix(".rs") for p in files})
    imports = {m: set() for m in modules}
    for path in files:
        parts = list(path.relative_to(src).with_suffix("").parts)
        module = parts[0]
        if parts[-1] == "mod":
            parts.pop()
        text = code(path)
        names = list(first_names(text, "crate"))
        # Chains of `super::` up to the root.
        names += first_names(text, "super::" * (len(parts) - 1) + "super")
        for name in names:
            target = re.match(r"\w*", name).group()
            # An error contains the error types of all areas. This is data, not a dependency on their functions.
            gathers = module == "error" and re.search(r"Error\b", name)
            if target in imports and target != module and not gathers:
                imports[module].add(target)
    rooms = {m: folders(src / m) for m in modules}
    return imports, rooms


def crates():
    """Crates other than the library with their imports. The library is one name among them."""
    folder = ROOT / "crates"
    manifests = [*folder.glob("*/Cargo.toml"), *ROOT.glob("python/Cargo.toml")]
    found = sorted(p.parent for p in manifests)
    names = {"gaitcam": LIBRARY} | {spelt(p): p.name for p in found}
    imports = {}
    for path in found:
        text = "\n".join(code(p) for p in sources(path / "src"))
        used = re.findall(r"(?<![\w:])(\w+)::", text)
        imports[path.name] = {names[u] for u in used if u in names} - {path.name}
    rooms = {p.name: folders(p / "src") for p in found}
    return imports, rooms


def spelt(crate):
    """Name of a crate in the sources: that of its manifest."""
    return tomllib.loads((crate / "Cargo.toml").read_text(encoding="utf-8"))["package"]["name"].replace("-", "_")


def below(imports):
    """Crates that the library uses directly and indirectly."""
    text = "\n".join(code(p) for p in sources(ROOT / "src"))
    names = {spelt(ROOT / "crates" / n): n for n in imports if (ROOT / "crates" / n).is_dir()}
    todo = [names[n] for n in sorted(set(re.findall(r"(?<![\w:])(\w+)::", text))) if n in names]
    out = set()
    while todo:
        crate = todo.pop()
        if crate not in out:
            out.add(crate)
            todo += imports[crate]
    return out


# --- layers ------------------------------------------------------------------------------------

def levels(imports):
    """Layer of every node: one above its highest import. Ends the program if there is an import cycle."""
    level = {}

    def visit(node, above):
        if node in above:
            sys.exit("imports in a circle: " + " → ".join(above[above.index(node):] + [node]))
        if node not in level:
            below = [visit(n, above + [node]) for n in sorted(imports[node])]
            level[node] = 1 + max(below, default=-1)
        return level[node]

    for node in sorted(imports):
        visit(node, [])
    return level


def reduced(imports):
    """Imports that do not follow from others."""
    def reach(node):
        out = set()
        for n in imports[node]:
            out |= {n} | reach(n)
        return out
    return {m: {n for n in used if not any(n in reach(o) for o in used if o != n)}
            for m, used in imports.items()}


# --- placing -----------------------------------------------------------------------------------

class Node:
    def __init__(self, name, rooms=()):
        self.name, self.up, self.down = name, [], []
        self.lines = wrapped(" · ".join(rooms), 34) if rooms else []
        text = max([9.2 * len(name)] + [6.1 * len(line) for line in self.lines]) if name else 0
        self.width = max(78, text + 24) if name else SLOT
        self.height = BOX + (14 * (len(self.lines) - 1) if self.lines else -10)
        self.x = self.y = 0.0


def wrapped(text, most):
    lines = [""]
    for word in text.split(" "):
        if lines[-1] and len(lines[-1]) + 1 + len(word) > most:
            lines.append("")
        lines[-1] = (lines[-1] + " " + word).strip()
    return [line.strip(" ·") for line in lines]


def layered(imports, rooms):
    """Rows of nodes, lowest first, with a chain of slots for every arrow that crosses a layer."""
    level, arrows = levels(imports), reduced(imports)
    rows = [[] for _ in range(1 + max(level.values()))]
    nodes = {}
    for name in sorted(imports):
        nodes[name] = Node(name, rooms.get(name, ()))
        rows[level[name]].append(nodes[name])
    chains = []
    for name in sorted(arrows):
        for used in sorted(arrows[name]):
            chain = [nodes[name]]
            for layer in range(level[name] - 1, level[used], -1):
                slot = Node("")
                rows[layer].append(slot)
                chain.append(slot)
            chain.append(nodes[used])
            for over, under in zip(chain, chain[1:]):
                over.down.append(under)
                under.up.append(over)
            chains.append(chain)
    return rows, chains


def crossings(rows):
    total = 0
    for low, high in zip(rows, rows[1:]):
        place = {id(n): i for i, n in enumerate(low)}
        ends = [place[id(d)] for n in high for d in sorted(n.down, key=lambda d: place[id(d)])]
        total += sum(a > b for i, a in enumerate(ends) for b in ends[i + 1:])
    return total


def ordered(rows):
    """Moves every node near the mean position of its neighbours, row by row, and keeps the best order."""
    best, fewest = [list(r) for r in rows], crossings(rows)
    for sweep in range(40):
        up = sweep % 2 == 0
        for i in (range(1, len(rows)) if up else range(len(rows) - 2, -1, -1)):
            beside = rows[i - 1] if up else rows[i + 1]
            place = {id(n): (k + 0.5) / len(beside) for k, n in enumerate(beside)}
            now = {id(n): (k + 0.5) / len(rows[i]) for k, n in enumerate(rows[i])}

            def wish(node):
                near = [place[id(n)] for n in (node.down if up else node.up)]
                return sum(near) / len(near) if near else now[id(node)]
            rows[i].sort(key=wish)
        # Adjacent nodes are exchanged if this removes a crossing.
        for row in rows:
            for k in range(len(row) - 1):
                before = crossings(rows)
                row[k], row[k + 1] = row[k + 1], row[k]
                if crossings(rows) >= before:
                    row[k], row[k + 1] = row[k + 1], row[k]
        if crossings(rows) < fewest:
            best, fewest = [list(r) for r in rows], crossings(rows)
    return best


def spread(row):
    """Moves the nodes of a row apart symmetrically, by as little as the minimum distances require."""
    def pushed(nodes, sign):
        out, at = {}, None
        for node in nodes:
            x = sign * node.x
            out[id(node)] = x if at is None else max(x, at + node.width / 2)
            at = out[id(node)] + node.width / 2 + SPACE
        return {k: sign * x for k, x in out.items()}
    right, left = pushed(row, 1), pushed(row[::-1], -1)
    for node in row:
        node.x = (right[id(node)] + left[id(node)]) / 2


def placed(rows, left, right):
    for row in rows:
        at = -sum(n.width + SPACE for n in row) / 2
        for node in row:
            node.x = at + node.width / 2
            at += node.width + SPACE
    for sweep in range(60):
        for row in rows if sweep % 2 else reversed(rows):
            for node in row:
                near = [n.x for n in node.up + node.down]
                if near:
                    node.x = 0.5 * node.x + 0.5 * sum(near) / len(near)
            spread(row)
    nodes = [n for row in rows for n in row]
    low, high = min(n.x - n.width / 2 for n in nodes), max(n.x + n.width / 2 for n in nodes)
    if high - low > right - left:
        print("docs/architecture.svg is wider than its frame", file=sys.stderr)
    for node in nodes:
        node.x += (left + right - low - high) / 2


# --- drawing -----------------------------------------------------------------------------------

STYLE = """
  text { font-family: system-ui, -apple-system, "Segoe UI", Helvetica, Arial, sans-serif; fill: #1f242b; }
  .name { font-size: 15px; font-weight: 600; text-anchor: middle; }
  .rooms { font-size: 11.5px; fill: #57606a; text-anchor: middle; }
  .title { font-size: 14px; font-weight: 600; fill: #57606a; }
  .paper { fill: #ffffff; }
  .frame { fill: #f3f6fa; stroke: #c8d1dc; }
  .box { fill: #ffffff; stroke: #3d6ea8; stroke-width: 1.4; }
  .crate { fill: #eef6ee; stroke: #3f8a4c; stroke-width: 1.4; }
  .arrow { fill: none; stroke: #7b8794; stroke-width: 1.3; }
  .head { fill: #7b8794; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6e9ee; }
    .rooms, .title { fill: #a0a9b6; }
    .paper { fill: #0d1117; }
    .frame { fill: #161b22; stroke: #30363d; }
    .box { fill: #1c2430; stroke: #6ea3dc; }
    .crate { fill: #18261c; stroke: #6fbf7d; }
    .arrow { stroke: #8b96a3; }
    .head { fill: #8b96a3; }
  }
"""


def heights(rows, bottom):
    """Sets the position of every row, with the lowest row at the bottom. Returns the top."""
    y = bottom
    for row in rows:
        tall = max(n.height for n in row)
        for node in row:
            node.y = y - tall / 2
            if not node.name:
                node.height = tall
        y -= tall + GAP
    return y + GAP


def box(node, kind):
    left, top = node.x - node.width / 2, node.y - node.height / 2
    out = [f'<rect class="{kind}" x="{left:.1f}" y="{top:.1f}" width="{node.width:.1f}" height="{node.height:.1f}" rx="6"/>']
    first = top + (20 if node.lines else node.height / 2 + 5)
    out.append(f'<text class="name" x="{node.x:.1f}" y="{first:.1f}">{node.name}</text>')
    for i, line in enumerate(node.lines):
        out.append(f'<text class="rooms" x="{node.x:.1f}" y="{first + 16 + 14 * i:.1f}">{line}</text>')
    return out


def ports(rows):
    """Ends of each arrow at its boxes, side by side, in the order of the other ends."""
    out = {}
    for row in rows:
        for node in row:
            for side, ends in (("down", node.down), ("up", node.up)):
                ends = sorted(ends, key=lambda n: n.x)
                room = min(node.width - 24, 22 * (len(ends) - 1)) if node.name else 0
                for i, end in enumerate(ends):
                    shift = room * (i / (len(ends) - 1) - 0.5) if len(ends) > 1 else 0
                    out[id(node), id(end), side] = node.x + shift
    return out


def arrow(chain, port):
    path = ""
    for over, under in zip(chain, chain[1:]):
        x1, x2 = port[id(over), id(under), "down"], port[id(under), id(over), "up"]
        y1 = over.y + over.height / 2
        y2 = under.y - under.height / 2 - (7 if under.name else 0)
        if not path:
            path = f"M{x1:.1f},{y1:.1f}"
        middle = (y1 + y2) / 2
        path += f" C{x1:.1f},{middle:.1f} {x2:.1f},{middle:.1f} {x2:.1f},{y2:.1f}"
        if not under.name:
            # Straight past the boxes of this layer.
            path += f" V{under.y + under.height / 2:.1f}"
    head = f"M{x2:.1f},{y2 + 7:.1f} l-4,-8 l8,0 z"
    return [f'<path class="arrow" d="{path}"/>', f'<path class="head" d="{head}"/>']


def diagram(imports, rooms, kind, left, right, bottom):
    rows, chains = layered(imports, rooms)
    rows = ordered(rows)
    top = heights(rows, bottom)
    placed(rows, left, right)
    port = ports(rows)
    shapes = [line for chain in chains for line in arrow(chain, port)]
    for row in rows:
        for node in row:
            if node.name:
                shapes += box(node, kind)
    return top, shapes, rows


def picture():
    inside, rooms = library()
    around, crate_rooms = crates()
    left, right = MARGIN, WIDTH - MARGIN
    under = below(around)
    floor, foundation = 0, []
    if under:
        used = {c: around.pop(c) for c in sorted(under)}
        top, foundation, rows = diagram(used, crate_rooms, "crate", left + 16, right - 16, -16)
        floor = top - 30
        for node in (n for row in rows for n in row if n.name and not n.up):
            y2 = node.y - node.height / 2 - 7
            foundation.append(f'<path class="arrow" d="M{node.x:.1f},{floor:.1f} V{y2:.1f}"/>')
            foundation.append(f'<path class="head" d="M{node.x:.1f},{y2 + 7:.1f} l-4,-8 l8,0 z"/>')
    top, shapes, _ = diagram(inside, rooms, "box", left + 16, right - 16, floor - 16)
    frame = top - 40
    shapes = foundation + [
        f'<rect class="frame" x="{left}" y="{frame:.1f}" width="{right - left}" height="{floor - frame:.1f}" rx="10"/>',
        f'<text class="title" x="{left + 14}" y="{frame + 22:.1f}">library gaitcam (src/)</text>',
    ] + shapes
    if around:
        # All crates use the library, so that only the arrows between crates are drawn.
        between = {c: used - {LIBRARY} - under for c, used in around.items()}
        top, more, rows = diagram(between, crate_rooms, "crate", left + 16, right - 16, frame - 36)
        shapes += more
        users = [n for row in rows for n in row if n.name and LIBRARY in around[n.name] and not n.down]
        for node in users:
            y1, y2 = node.y + node.height / 2, frame - 7
            shapes.append(f'<path class="arrow" d="M{node.x:.1f},{y1:.1f} V{y2:.1f}"/>')
            shapes.append(f'<path class="head" d="M{node.x:.1f},{frame:.1f} l-4,-8 l8,0 z"/>')
        shapes.append(f'<text class="title" x="{left + 14}" y="{top - 12:.1f}">crates (crates/)</text>')
        top -= 32
    else:
        top = frame
    top -= MARGIN / 2
    height = MARGIN / 2 - top
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 {top:.1f} {WIDTH} {height:.1f}" '
        f'width="{WIDTH}" height="{height:.0f}" role="img" aria-label="Modules and their imports">'
    )
    paper = f'<rect class="paper" x="0" y="{top:.1f}" width="{WIDTH}" height="{height:.1f}"/>'
    return "\n".join([head, f"<style>{STYLE}</style>", paper] + shapes + ["</svg>"]) + "\n"


def main():
    new = picture()
    if "--check" in sys.argv[1:]:
        old = PICTURE.read_text(encoding="utf-8") if PICTURE.exists() else ""
        if old != new:
            sys.exit("docs/architecture.svg is stale; run: python3 docs/architecture.py")
        return
    PICTURE.write_text(new, encoding="utf-8")


if __name__ == "__main__":
    main()
