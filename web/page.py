#!/usr/bin/env python3
"""Writes the page as static files and as one file.

    python3 web/page.py MODULES ESBUILD OUT [--url https://example.org/gaitcam/]

`--url` is the address of the files. Previews of links need it, because most sites ignore relative addresses of pictures.
"""

import argparse
import base64
import gzip
import hashlib
import html
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "crates" / "studio" / "page"
# Script of the report for the animation of the cam, which the page also uses.
MOTION = ROOT / "crates" / "output" / "src" / "report" / "motion.js"
# Picture of the page for previews of links.
PREVIEW = ROOT / "docs" / "pictures" / "studio-page.png"
# Maximum number of compressed bytes before the first design.
FIRST_LOAD = 1_500_000
# Content security policy of the page in a single file, which loads no other files.
POLICY = (
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; style-src 'unsafe-inline'; "
    "img-src data: blob:; connect-src data: blob:"
)


def bundle(esbuild, out):
    """All modules of the page in a single script."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page"
        shutil.copytree(PAGE, page)
        shutil.copy(MOTION, page / "core" / "motion.js")
        command = [esbuild, str(page / "app.js"), "--bundle", "--format=esm", "--minify", f"--outfile={out}", "--log-level=warning"]
        subprocess.run(command, check=True)


def without_custom_sections(module):
    """The module without function names and other notes of its compiler."""
    out, at = bytearray(module[:8]), 8
    while at < len(module):
        kind, length, start = module[at], 0, at + 1
        for shift in range(0, 35, 7):
            length |= (module[start] & 127) << shift
            start += 1
            if module[start - 1] < 128:
                break
        if kind != 0:
            out += module[at : start + length]
        at = start + length
    return bytes(out)


def index(url=""):
    text = (PAGE / "index.html").read_text()
    return text.replace("{language}", "").replace("{engine}", "wasm").replace("<!--preview-->", preview(url))


def preview(url):
    """Picture and address of the page, for previews of links."""
    picture = html.escape(url + "preview.png")
    tags = [
        f'<meta property="og:image" content="{picture}">',
        '<meta property="og:image:alt" content="A cam with its follower, its force and its diagrams on the page of gaitcam">',
        '<meta name="twitter:card" content="summary_large_image">',
    ]
    if url:
        tags.insert(0, f'<meta property="og:url" content="{html.escape(url)}">')
    return "\n".join(tags)


def inline(tag, text, **attributes):
    given = "".join(f' {k}="{v}"' for k, v in attributes.items())
    text = text.replace(f"</{tag}", f"<\\/{tag}")
    return f"<{tag}{given}>{text}</{tag}>"


def one_file(out, engine):
    page = index().replace('<base href="{base}">', f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">')
    for style in ["style.css", "panels.css"]:
        link = f'<link rel="stylesheet" href="{style}">'
        assert link in page, style
        page = page.replace(link, inline("style", (out / style).read_text()))
    script = '<script type="module" src="app.js"></script>'
    assert script in page
    page = page.replace(script, "")
    own = 'window.gaitcamPage = "<!doctype html>" + document.documentElement.outerHTML;'
    parts = [
        "<!--packed-->",
        inline("script", (out / "engine" / "worker.js").read_text(), type="text/plain", id="engine-worker"),
        inline("script", base64.b64encode(engine).decode(), type="text/plain", id="engine-module"),
        inline("script", (out / "app.js").read_text(), type="module"),
        inline("script", own),
    ]
    assert "</body>" in page
    return page.replace("</body>", "\n".join(parts) + "\n</body>")


def service_worker(out, files, later):
    """Writes the service worker. It stores the files of this build, so that the page opens without a network after the first visit."""
    version = hashlib.sha256(b"".join((out / file).read_bytes() for file in [*files, later])).hexdigest()[:16]
    text = (ROOT / "web" / "service_worker.js").read_text()
    list_ = ", ".join(f'"{file}"' for file in ["./", *files])
    return text.replace("{version}", version).replace("{files}", list_).replace("{later}", later)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("modules", type=Path)
    parser.add_argument("esbuild")
    parser.add_argument("out", type=Path)
    parser.add_argument("--url", default="", help="address that the files will have, with a slash at its end")
    given = parser.parse_args()
    modules, esbuild, out = given.modules, given.esbuild, given.out
    url = given.url and given.url.rstrip("/") + "/"
    shutil.rmtree(out, ignore_errors=True)
    (out / "engine").mkdir(parents=True)
    for name in ["engine", "whole"]:
        module = without_custom_sections((modules / f"{name}.wasm").read_bytes())
        (out / "engine" / f"{name}.wasm.gz").write_bytes(gzip.compress(module, 9, mtime=0))
    shutil.copy(PAGE / "engine" / "worker.js", out / "engine" / "worker.js")
    bundle(esbuild, out / "app.js")
    for style in ["style.css", "panels.css"]:
        shutil.copy(PAGE / style, out / style)
    shutil.copy(PREVIEW, out / "preview.png")
    (out / "index.html").write_text(index(url).replace("{base}", "./"))
    files = ["app.js", "style.css", "panels.css", "engine/worker.js", "engine/engine.wasm.gz"]
    later = "engine/whole.wasm.gz"
    (out / "service_worker.js").write_text(service_worker(out, files, later))
    (out / "gaitcam.html").write_text(one_file(out, (out / later).read_bytes()))
    packed = {file: len(gzip.compress((out / file).read_bytes())) for file in ["index.html", *files, later, "gaitcam.html"]}
    for file, size in packed.items():
        print(f"{(out / file).stat().st_size / 1e3:9.1f} kB  {size / 1e3:8.1f} kB packed  {file}")
    first = sum(packed[file] for file in ["index.html", *files])
    print(f"{'':12}  {first / 1e3:8.1f} kB packed  before the first design")
    if first > FIRST_LOAD:
        sys.exit(f"web/page.py: the first load is larger than {FIRST_LOAD / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
