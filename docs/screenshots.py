#!/usr/bin/env python3
"""Writes docs/pictures/studio-page*.png: screenshots of the studio with the heel tester, in both languages.

    target/browser-tests/bin/python docs/screenshots.py target/release/gaitcam  # --check: only compares

Each screenshot contains the verdict, numbers and checks of the page as a chunk of text. `--check` compares this text, because
the pixels depend on the fonts of the computer. CHROMIUM names the browser.
"""

import os
import shutil
import struct
import subprocess
import sys
import zlib
from pathlib import Path

from playwright.sync_api import sync_playwright

ROOT = Path(__file__).resolve().parent.parent
SCENE = ROOT / "scenes" / "heel_tester_fitted.toml"
PICTURES = {ROOT / "docs" / "pictures" / "studio-page.png": "en", ROOT / "docs" / "pictures" / "studio-page-es.png": "es"}
BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
# Parts of the page whose text is compared: verdict, numbers, names of the diagrams, checks.
PARTS = ("#verdict", "#figures", "#charts h2", "#limits")
# Keyword of the chunk of text, and the chunk's flags: not compressed, no language.
HEADER = b"iTXtDescription" + bytes(5)


def shown(page):
    """Text of the results on the page."""
    return "\n".join(text for part in PARTS for text in page.locator(part).all_inner_texts())


def taken(browser, address):
    """Screenshot of the page at an address, and the text of its results."""
    page = browser.new_page(viewport={"width": 1280, "height": 760}, color_scheme="light", reduced_motion="reduce")
    page.goto(address)
    page.wait_for_selector('#design[aria-busy="false"]:not([data-revision="0"])', timeout=60_000)
    if page.is_visible("#welcome-close"):
        page.click("#welcome-close")
    # The sensitivities of the limits follow the design, each with an arrow from the old to the new value.
    page.wait_for_function("document.querySelector('#limits').innerText.includes('\u2192')", timeout=60_000)
    text, earlier = shown(page), None
    while text != earlier:
        page.wait_for_timeout(1000)
        text, earlier = shown(page), text
    picture = page.screenshot()
    page.close()
    return picture, text


def with_text(png, text):
    """PNG with the text in a chunk before its last chunk."""
    chunk = HEADER + text.encode()
    return png[:-12] + struct.pack(">I", len(chunk) - 4) + chunk + struct.pack(">I", zlib.crc32(chunk)) + png[-12:]


def text_of(png):
    """Text that `with_text` has written; empty if there is none."""
    at = png.find(HEADER)
    if at < 0:
        return ""
    return png[at + len(HEADER):at + 4 + struct.unpack(">I", png[at - 4:at])[0]].decode()


def main(binary, check):
    chromium = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if not chromium:
        sys.exit("the pictures of the studio need Chromium: install it, or set CHROMIUM")
    old = []
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for file, language in PICTURES.items():
            served = subprocess.Popen([binary, "studio", str(SCENE), "--no-open", "--lang", language],
                                      stdout=subprocess.PIPE, text=True)
            try:
                picture, text = taken(browser, served.stdout.readline().strip())
            finally:
                served.terminate()
                served.wait()
            if check:
                old += [file.name] * (not file.exists() or text_of(file.read_bytes()) != text)
                continue
            file.write_bytes(with_text(picture, text))
            print(f"{file.relative_to(ROOT)} {file.stat().st_size}")
        browser.close()
    if old:
        sys.exit(f"old pictures: {', '.join(old)}; python3 docs/pictures.py {binary} studio")


if __name__ == "__main__":
    arguments = [a for a in sys.argv[1:] if a != "--check"]
    if len(arguments) != 1:
        sys.exit(__doc__)
    main(str(Path(arguments[0]).resolve()), "--check" in sys.argv)
