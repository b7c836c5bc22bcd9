"""Studio server and browser page for tests."""

import os
import re
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from playwright.sync_api import TimeoutError, sync_playwright

BINARY = os.environ["GAITCAM"]
CHROMIUM = os.environ["CHROMIUM"]
ROOT = Path(os.environ["GAITCAM_ROOT"])
PATIENCE = 30.0
# A folder with files of the page. They replace those in the binary, so that a change needs no compilation.
FRESH = os.environ.get("GAITCAM_PAGE")


# Folder with the static files of the page and its engine. If set, the tests use these files.
DIST = os.environ.get("GAITCAM_DIST")


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class Static:
    """Web server for the static files. Tests that need a folder or a separate server are skipped."""

    def __init__(self, port=0):
        self.server = ThreadingHTTPServer(("127.0.0.1", port), partial(Quiet, directory=DIST))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.url = f"http://127.0.0.1:{self.server.server_address[1]}/"

    def kill(self):
        self.server.shutdown()
        self.server.server_close()

    def __getattr__(self, name):
        raise unittest.SkipTest(f"static files have no {name}")


class Native:
    """`gaitcam studio` on a separate folder."""

    def __init__(self, port=0):
        self.folder = Path(tempfile.mkdtemp(prefix="gaitcam-studio-"))
        self.start(port)

    def start(self, port=0):
        command = [BINARY, "studio", str(self.folder), "--no-open", "--port", str(port)]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.url = self.process.stdout.readline().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/\?token=[0-9a-f]+", self.url), self.url
        self.port = int(re.search(r":(\d+)/", self.url).group(1))

    def kill(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def interrupt(self):
        """Ends the server like Ctrl-C; returns the exit code."""
        self.process.send_signal(signal.SIGINT)
        code = self.process.wait(timeout=10)
        self.process.stdout.close()
        return code


Server = Static if DIST else Native
of_server = unittest.skipIf(DIST, "static files have no server")


class Browser:
    """One Chromium instance for all tests."""

    def __init__(self):
        self.driver = sync_playwright().start()
        self.chromium = self.driver.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])

    def context(self, turns=False, **more):
        """A separate user. The cam is at rest unless it `turns`, so that pages in the background need no processor time."""
        return self.chromium.new_context(accept_downloads=True, reduced_motion="no-preference" if turns else "reduce", **more)

    def page(self, url, width=1400, height=900, theme="light", context=None, turns=False):
        context = context or self.context(turns, viewport={"width": width, "height": height}, color_scheme=theme)
        if FRESH:
            context.route("**/*", fresh)
        return Page(context.new_page(), url)

    def close(self):
        self.chromium.close()
        self.driver.stop()


def fresh(route):
    """Serves the files of FRESH and the texts of the source tree. Every request takes about ten milliseconds longer."""
    path = route.request.url.split("?")[0]
    name = re.sub(r"^http://[^/]+/([0-9a-f]{16,}/)?", "", path)
    file = Path(FRESH) / (name or "index.html")
    if name == "start":
        answer = route.fetch()
        start = answer.json()
        for tag, words in start["words"].items():
            text = (ROOT / "crates/app/src/page/words" / f"{tag}.ftl").read_text()
            words.update({k: re.sub(r"{ \$(\w+) }", r"{\1}", v) for k, v in re.findall(r"^(studio-[\w-]+) = (.*)$", text, re.M)})
        route.fulfill(response=answer, json=start)
    elif not name:
        answer = route.fetch()
        base = re.search(r'<base href="([^"]*)"', answer.text()).group(1)
        tag = re.search(r'<html lang="(\w*)"', answer.text()).group(1)
        body = file.read_text().replace("{base}", base).replace("{language}", tag).replace("{engine}", "native")
        route.fulfill(response=answer, body=body)
    elif file.is_file():
        kind = {"js": "text/javascript", "css": "text/css"}[file.suffix[1:]]
        route.fulfill(body=file.read_text(), content_type=f"{kind}; charset=utf-8")
    else:
        route.continue_()


class Page:
    """A page of the studio with its console messages."""

    def __init__(self, page, url=None):
        self.page = page
        self.said = []
        page.on("console", lambda m: self.said.append(m.text) if m.type in ("error", "warning") else None)
        page.on("pageerror", lambda e: self.said.append(str(e)))
        if url:
            page.goto(url)
            self.shown(0)
            if page.is_visible("#welcome-close"):
                page.click("#welcome-close")

    def revision(self):
        return int(self.page.get_attribute("#design", "data-revision"))

    def verdict(self):
        return self.page.get_attribute("#verdict", "data-verdict")

    def ms(self):
        return float(self.page.get_attribute("#design", "data-ms"))

    def until(self, what, holds):
        end = time.monotonic() + PATIENCE
        while not holds():
            assert time.monotonic() < end, f"in vain: {what}; the console says {self.said}"
            self.page.wait_for_timeout(15)

    def shown(self, before):
        """Waits for a design after revision `before` and for the last requested one."""
        self.until("a design is shown", lambda: self.revision() > before)
        self.until("it is at rest", lambda: self.page.get_attribute("#design", "aria-busy") == "false")

    def does(self, action):
        """Runs an action that leads to a new design."""
        before = self.revision()
        action()
        self.shown(before)

    def sets(self, key, value):
        self.does(lambda: self.page.fill(f'[name="{key}"]', value))

    def opens(self, scene):
        self.page.click("#open-scenes")
        # Some scenes are only found by the search.
        self.page.fill("#find-scene", scene.replace("_", " "))
        self.page.wait_for_selector(f'[data-scene="{scene}"]')
        self.does(lambda: self.page.click(f'[data-scene="{scene}"]'))

    def downloads(self, name, path):
        """Clicks a link and stores its file. A browser under load sometimes loses a click. The response of the server to the same
        address is then checked, and one more click is allowed."""
        link = self.page.locator(f'a[download="{name}"]')
        try:
            with self.page.expect_download(timeout=10_000) as waiting:
                link.click()
        except TimeoutError:
            answer = self.page.request.get(link.evaluate("a => a.href"))
            print(f"\n  {name}: no download began; the server answers {answer.status}")
            assert answer.ok, f"{name}: {answer.status} {answer.text()[:200]}"
            with self.page.expect_download() as waiting:
                link.click()
        waiting.value.save_as(path)

    def value(self, key):
        return self.page.input_value(f'[name="{key}"]')


class Pages(unittest.TestCase):
    """Tests that share one browser and one server. Each opens separate pages."""

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.server.kill()

    def page(self, url=None, **more):
        page = self.browser.page(url or self.server.url, **more)
        self.addCleanup(page.page.context.close)
        return page
