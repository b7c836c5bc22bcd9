#!/usr/bin/env python3
"""Runs the commands and wheels of a release and compares their results with those of Linux on x86_64.

    python3 release/try.py FILES TOOLS WORK [PLATFORM ...]

FILES has the archives, TOOLS qemu, wine and libraries (release/try.sh unpacks them), WORK is an empty folder. Each archive is
unpacked into a folder with spaces and umlauts, and its commands run there with an empty home. On each platform:

- every command of README.md and LEEME.md as printed; `studio` answers a request;
- `synth` of all built-in scenes: law.csv and scene.toml have the same bytes as on Linux x86_64, numbers of profile.csv differ by
  at most 1e-15 m, summary.json is equal except times; whole paths of recordings are not compared;
- `gait` of the recordings and curves in data/: same output;
- a sweep that is killed and resumed: same table except times;
- absolute paths, paths of the system's own form, a scene with CRLF line ends, a folder without write permission, a reader that
  closes the pipe, two processes with the same output folder;
- on Windows, the file that a double click starts;
- the wheel: its list of files, and in Python law.csv of the built-in scenes, with the same bytes as those of the command. There is no
  Python for Windows here: of that wheel, the exports and the needed libraries are checked.
"""

import base64
import hashlib
import json
import re
import shlex
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request
import zipfile
from pathlib import Path

FOLDER = "Prüfstand für Füße"
PROFILE_TOLERANCE = 1e-15
SWEEP = ["sweep", "scenes/footbridge.toml", "--vary", "limits.stroke=45 mm:50 mm:2000"]
# Scenes that are complete only with a file.
OPTIONS = {"measured_walk": ["--set", "gait.file=data/recordings/made_walk.csv"]}
# Whole path of this recording in a written scene, with its quotes. It depends on the folder of the archive.
WHOLE_PATH = re.compile(rb"""(["'])[^"'\n]*made_walk\.csv\1""")


WHEELS = {"linux-x86_64": "manylinux*_x86_64", "linux-aarch64": "manylinux*_aarch64", "windows-x86_64": "win_amd64"}
IN_PYTHON = """
import sys, gaitcam
for name in gaitcam.Scene.builtins():
    if name not in sys.argv[2].split(","):
        gaitcam.synth(gaitcam.Scene.builtin(name)).save(f"{sys.argv[1]}/{name}", png=False)
        print(name)
"""
# Libraries that every Windows has, and python3.dll of the interpreter.
WINDOWS_LIBRARIES = re.compile(r"(?i)(python3|kernel32|ntdll|advapi32|ws2_32|userenv|bcrypt|bcryptprimitives|msvcrt|ole32|shell32|user32|api-ms-win-.*)\.dll")


class Fault(Exception):
    """A result that differs from the expected one."""


class Platform:
    """An unpacked archive, and how this machine runs its command."""

    def __init__(self, name, files, tools, work):
        self.name, self.files, self.tools = name, files, tools
        self.work = work / name
        self.home = self.work / "home"
        self.home.mkdir(parents=True)
        self.environment = {"HOME": str(self.home), "PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"}
        self.windows = name.startswith("windows")
        found = sorted(files.glob(f"gaitcam-*-{name}.*"))
        if len(found) != 1:
            raise Fault(f"{len(found)} archives for {name} in {files}")
        self.archive = found[0]
        self.runner, self.how = [], "native"
        if name == "linux-aarch64":
            self.runner, self.how = [tools / "usr/bin/qemu-aarch64-static", "-L", tools / "usr/aarch64-linux-gnu"], "qemu-user"
        if self.windows:
            self.runner, self.how = [tools / "usr/lib/wine/wine64"], "wine"
            self.environment |= {
                "WINEPREFIX": str(work / "wine"), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml=",
                "LD_LIBRARY_PATH": str(tools / "usr/lib/x86_64-linux-gnu"),
            }
            self.set_up_wine()

    def set_up_wine(self):
        """A new Windows folder with two libraries that Debian's wine does not put there: zlib1.dll, which wine's own libraries need,
        and a bcryptprimitives.dll with ProcessPrng, which Windows has and wine 8 does not (built by release/try.sh)."""
        system = Path(self.environment["WINEPREFIX"]) / "drive_c/windows/system32"
        system.mkdir(parents=True)
        for library in (self.tools / "bcryptprimitives.dll", self.tools / "usr/x86_64-w64-mingw32/lib/zlib1.dll"):
            (system / library.name).write_bytes(library.read_bytes())
        subprocess.run([*self.runner, "wineboot", "-i"], env=self.environment, stdin=subprocess.DEVNULL,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)

    def unpack(self):
        parent = self.work / FOLDER
        parent.mkdir()
        if self.windows:
            with zipfile.ZipFile(self.archive) as archive:
                archive.extractall(parent)
        else:
            subprocess.run(["tar", "-xzf", self.archive], cwd=parent, check=True)
        (self.folder,) = parent.iterdir()
        self.program = self.folder / ("gaitcam.exe" if self.windows else "gaitcam")

    def words(self, *arguments):
        return [str(word) for word in (*self.runner, self.program, *arguments)]

    def start(self, *arguments, **options):
        settings = {"cwd": self.folder, "env": self.environment, "stdin": subprocess.DEVNULL,
                    "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        return subprocess.Popen(self.words(*arguments), **(settings | options))

    def run(self, *arguments, **options):
        """Exit code, output and messages."""
        process = self.start(*arguments, **options)
        out, messages = process.communicate(timeout=900)
        return process.returncode, out.decode(), messages.decode()

    def succeed(self, *arguments, codes=(0,)):
        code, out, messages = self.run(*arguments)
        if code not in codes:
            raise Fault(f"exit code {code}: gaitcam {shlex.join(map(str, arguments))}\n{out}{messages}")
        return out

    def own_path(self, path):
        """A path as a user of this system writes it: on Windows with drive letter and backslashes."""
        return "Z:" + str(path).replace("/", "\\") if self.windows else str(path)


def first_cam(platform, _):
    begun = time.time()
    platform.unpack()
    platform.succeed("synth", "--out", "first")
    return f"{time.time() - begun:.1f} s"


def printed_commands(platform, _):
    """Every command in the texts of the archive. A block of TOML is first saved under the name in its comment."""
    count = 0
    for text in ("README.md", "LEEME.md"):
        for kind, block in re.findall(r"(?ms)^```(\w+)\n(.*?)^```", (platform.folder / text).read_text(encoding="utf-8")):
            if kind == "toml":
                (platform.folder / re.match(r"# (\S+)", block).group(1)).write_text(block, encoding="utf-8")
            for line in block.splitlines() if kind == "sh" else ():
                program, *arguments = shlex.split(line.replace("\\", "/"))
                if platform.folder / program not in (platform.folder / "gaitcam",):
                    raise Fault(f"{text}: not the command of the archive: {line}")
                if arguments[0] == "studio":
                    serve(platform, arguments)
                else:
                    platform.succeed(*arguments)
                count += 1
    if count < 15:
        raise Fault(f"only {count} commands were found")
    return f"{count} commands"


def serve(platform, arguments):
    answer_once(platform.start(*arguments, "--no-open"))


def double_click(platform, _):
    """What a double click on the file for Windows starts."""
    if not platform.windows:
        return "–"
    words = [str(word) for word in (*platform.runner, "cmd", "/c", "gaitcam studio.cmd")]
    answer_once(subprocess.Popen(words, cwd=platform.folder, env=platform.environment, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.DEVNULL))
    # The command is a child of the interpreter of the file.
    subprocess.run([platform.tools / "usr/lib/wine/wineserver64", "-k"], env=platform.environment, timeout=60)
    return "gaitcam studio.cmd serves the page"


def answer_once(process):
    """The process prints an address, and the page is there. The process is then stopped."""
    try:
        address = process.stdout.readline().decode().strip()
        with urllib.request.urlopen(address, timeout=60) as answer:
            if b"<html" not in answer.read():
                raise Fault("studio serves no page")
    except (ValueError, urllib.error.URLError) as error:
        raise Fault(f"studio: {error}") from error
    finally:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        process.stdout.close()


def scenes(platform, reference):
    names = [line.split()[0] for line in platform.succeed("scenes").splitlines() if re.match(r"\w+ ", line)]
    if len(names) < 25:
        raise Fault(f"only {len(names)} scenes are listed")
    largest, bits, faults = 0.0, 0, []
    for name in names:
        platform.succeed("synth", name, *OPTIONS.get(name, ()), "--out", f"all/{name}", codes=(0, 3))
    for name in names if reference is not platform else ():
        mine, other = (which.folder / "all" / name for which in (platform, reference))
        for file in ("law.csv", "scene.toml"):
            a, b = (WHOLE_PATH.sub(b"RECORDING", (folder / file).read_bytes()) for folder in (mine, other))
            if a != b:
                faults.append(f"{name}: {file} differs by {difference(a.decode(), b.decode()):.2g}")
        distance = difference((mine / "profile.csv").read_text(), (other / "profile.csv").read_text())
        if distance > PROFILE_TOLERANCE:
            faults.append(f"{name}: profile.csv differs by {distance:.2g}")
        largest = max(largest, distance)
        if fault := next(unequal(summary(mine), summary(other)), None):
            faults.append(f"{name}: summary.json: {fault}")
        bits += all(path.read_bytes() == (other / path.name).read_bytes() for path in mine.iterdir() if path.suffix in (".svg", ".png"))
    if faults:
        raise Fault("\n  ".join(faults))
    equal = "" if reference is platform else f", profile.csv within {largest:.1g} m, pictures of {bits} with the same bytes"
    return f"{len(names)} scenes{equal}"


def difference(mine, other):
    """Largest difference between the numbers of two tables; infinite where their form differs."""
    mine, other = (re.split(r"[,\n]", text) for text in (mine, other))
    if len(mine) != len(other):
        return float("inf")
    largest = 0.0
    for a, b in zip(mine, other):
        if a != b:
            try:
                largest = max(largest, abs(float(a) - float(b)))
            except ValueError:
                return float("inf")
    return largest


def summary(folder):
    return json.loads(WHOLE_PATH.sub(b'"RECORDING"', (folder / "summary.json").read_bytes()))


def unequal(mine, other, place=""):
    if isinstance(mine, dict) and isinstance(other, dict) and mine.keys() == other.keys():
        for key in mine.keys() - {"total_s", "solve_s"}:
            yield from unequal(mine[key], other[key], f"{place}.{key}")
    elif isinstance(mine, list) and isinstance(other, list) and len(mine) == len(other):
        for number, pair in enumerate(zip(mine, other)):
            yield from unequal(*pair, f"{place}[{number}]")
    elif mine != other:
        yield f"{place} is {mine}, on Linux x86_64 {other}"


def recordings(platform, reference):
    files = sorted([*(platform.folder / "data/recordings").glob("*.csv"), *(platform.folder / "data/gait_curves").glob("*.csv")])
    read = 0
    for path in files:
        given = path.relative_to(platform.folder)
        mine, other = platform.run("gait", given), reference.run("gait", given)
        if mine != other:
            raise Fault(f"gait {given}: {mine}\non Linux x86_64: {other}")
        read += mine[0] == 0
    if read < 7:
        raise Fault(f"only {read} of {len(files)} files are read")
    return f"{read} files read, {len(files) - read} refused" + ("" if reference is platform else ", same output")


def resumed_sweep(platform, reference):
    platform.succeed(*SWEEP, "--out", "whole.csv")
    process = platform.start(*SWEEP, "--out", "killed.csv", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    blocks = platform.folder / "killed.csv.partial"
    begun = time.time()
    while process.poll() is None and time.time() < begun + 300 and not (blocks.is_dir() and len(list(blocks.iterdir())) > 2):
        time.sleep(0.002)
    process.kill()
    process.wait()
    if (platform.folder / "killed.csv").exists():
        raise Fault("the sweep was complete before it could be killed")
    kept = len(list(blocks.glob("*"))) if blocks.is_dir() else 0
    platform.succeed(*SWEEP, "--out", "killed.csv", "--resume")
    whole, again, other = (without_times(f) for f in (platform.folder / "whole.csv", platform.folder / "killed.csv", reference.folder / "whole.csv"))
    if whole != again:
        raise Fault("the resumed sweep differs from the whole one")
    if whole != other:
        pairs = [(i, name, a, b) for i, (mine, theirs) in enumerate(zip(whole, other)) for name, a, b in zip(whole[0], mine, theirs) if a != b]
        raise Fault(f"{len(pairs)} fields of the sweep differ from those of Linux x86_64: row, column and values of some: {pairs[:3]}")
    return f"{len(whole) - 1} rows, killed with {kept} files of blocks" + ("" if reference is platform else ", same table")


def without_times(file):
    rows = [line.split(",") for line in file.read_text(encoding="utf-8").splitlines()]
    return [[field for name, field in zip(rows[0], row) if name != "time_s"] for row in rows]


def paths(platform, _):
    law = (platform.folder / "all/heel_tester/law.csv").read_bytes()
    forms = [platform.own_path(platform.folder / "scenes/heel_tester.toml"), "scenes/heel_tester.toml"]
    if platform.windows:
        forms.append(r"scenes\heel_tester.toml")
        forms.append(r".\scenes\..\scenes\heel_tester.toml")
    for number, form in enumerate(forms):
        out = platform.folder / f"Größe {number}"
        platform.succeed("synth", form, "--out", platform.own_path(out), codes=(0, 3))
        if (out / "law.csv").read_bytes() != law:
            raise Fault(f"synth {form}: law.csv differs")
    return f"{len(forms)} forms"


def crlf(platform, _):
    text = (platform.folder / "scenes/heel_tester.toml").read_bytes()
    (platform.folder / "crlf.toml").write_bytes(text.replace(b"\n", b"\r\n"))
    platform.succeed("synth", "crlf.toml", "--out", "crlf", codes=(0, 3))
    table = (platform.folder / "data/recordings/made_walk.csv").read_bytes()
    (platform.folder / "crlf.csv").write_bytes(table.replace(b"\n", b"\r\n"))
    lf, crlf_ = (platform.succeed("gait", file).splitlines()[1:] for file in ("data/recordings/made_walk.csv", "crlf.csv"))
    if lf != crlf_ or (platform.folder / "crlf/law.csv").read_bytes() != (platform.folder / "all/heel_tester/law.csv").read_bytes():
        raise Fault("a file with CRLF gives another result")
    return "scene and recording"


def read_only(platform, _):
    folder = platform.folder / "read only"
    folder.mkdir()
    folder.chmod(0o555)
    code, out, messages = platform.run("synth", "--out", "read only/result")
    if code in (0, 3, 101) or "panicked" in messages or not messages.startswith("gaitcam: "):
        raise Fault(f"a folder without write permission: exit code {code}\n{out}{messages}")
    if any(folder.iterdir()):
        raise Fault("files in a folder without write permission")
    return f"refused, exit code {code}"


def closed_pipe(platform, _):
    process = platform.start("synth", "--help")
    process.stdout.read(1)
    process.stdout.close()
    messages = process.stderr.read().decode()
    process.wait(timeout=60)
    if messages:
        raise Fault(f"a closed pipe: {messages}")
    return "no message"


def two_processes(platform, _):
    both = [platform.start("synth", "thesis_iteration_1", "--out", "both") for _ in range(2)]
    ended = [(process.communicate(timeout=300), process.returncode) for process in both]
    codes = sorted(code for _, code in ended)
    if codes[0] not in (0, 3) or any(b"panicked" in messages for (_, messages), _ in ended):
        raise Fault(f"two processes on one folder: {ended}")
    names = {path.name for path in (platform.folder / "all/thesis_iteration_1").iterdir()}
    if {path.name for path in (platform.folder / "both").iterdir()} - names:
        raise Fault("two processes on one folder leave other files")
    if (platform.folder / "both/law.csv").read_bytes() != (platform.folder / "all/thesis_iteration_1/law.csv").read_bytes():
        raise Fault("two processes on one folder: law.csv differs")
    return f"exit codes {codes[0]} and {codes[1]}"


def wheel(platform, _):
    found = sorted(platform.files.glob(f"gaitcam-*-{WHEELS[platform.name]}.whl"))
    if len(found) != 1:
        return "not built"
    folder = platform.work / "wheel"
    with zipfile.ZipFile(found[0]) as archive:
        archive.extractall(folder)
    check_record(folder)
    if platform.windows:
        return libraries(platform, next(folder.glob("gaitcam/_native*.pyd")))
    python, numpy = ["/usr/bin/python3"], platform.tools / "python/numpy-x86_64"
    if platform.runner:
        root = platform.tools / "python"
        python, numpy = [platform.runner[0], "-L", root, root / "usr/bin/python3"], root / "numpy-aarch64"
    out = platform.work / "by wheel"
    done = subprocess.run([*python, "-c", IN_PYTHON, out, ",".join(OPTIONS)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          env=platform.environment | {"PYTHONPATH": f"{folder}:{numpy}", "PYTHONDONTWRITEBYTECODE": "1"}, timeout=900)
    if done.returncode:
        raise Fault(f"the wheel: {done.stdout}{done.stderr}")
    for name in done.stdout.split():
        if (out / name / "law.csv").read_bytes() != (platform.folder / "all" / name / "law.csv").read_bytes():
            raise Fault(f"the wheel: law.csv of {name} differs from that of the command")
    return f"{len(done.stdout.split())} scenes, same law.csv"


def check_record(folder):
    """Whether the files of an unpacked wheel are those in its list, with the digests there."""
    (record,) = folder.glob("*.dist-info/RECORD")
    listed = set()
    for line in record.read_text(encoding="utf-8").splitlines():
        name, digest, _ = line.rsplit(",", 2)
        listed.add(folder / name)
        is_ = base64.urlsafe_b64encode(hashlib.sha256((folder / name).read_bytes()).digest()).decode().rstrip("=")
        if digest and digest != f"sha256={is_}":
            raise Fault(f"{name} of the wheel does not have the listed digest")
    if listed != {path for path in folder.rglob("*") if path.is_file()}:
        raise Fault("the wheel has other files than it lists")


def libraries(platform, module):
    """Whether a Python module for Windows exports its start and needs nothing but Python and Windows."""
    objdump = platform.tools.parent / "release-tools/mingw/usr/bin/x86_64-w64-mingw32-objdump"
    printed = subprocess.run([objdump, "-p", module], check=True, capture_output=True, text=True).stdout
    needed = re.findall(r"DLL Name: (\S+)", printed)
    if "pei-x86-64" not in printed or "PyInit__native" not in printed:
        raise Fault("the module of the wheel is not a Python module for Windows")
    if foreign := [name for name in needed if not WINDOWS_LIBRARIES.fullmatch(name)]:
        raise Fault(f"the module of the wheel needs {', '.join(foreign)}")
    return f"not run; list of files and {len(needed)} needed libraries checked"


CHECKS = {
    "from the archive to the first cam": first_cam,
    "commands of README.md and LEEME.md": printed_commands,
    "synth": scenes,
    "gait": recordings,
    "sweep, killed and resumed": resumed_sweep,
    "paths": paths,
    "CRLF": crlf,
    "no write permission": read_only,
    "closed pipe": closed_pipe,
    "two processes, one folder": two_processes,
    "double click": double_click,
    "wheel": wheel,
}


def main():
    files, tools, work = (Path(argument).resolve() for argument in sys.argv[1:4])
    names = sys.argv[4:] or ["linux-x86_64", "linux-aarch64", "windows-x86_64"]
    results, failed, reference = {}, [], None
    for name in ["linux-x86_64", *(name for name in names if name != "linux-x86_64")]:
        platform = Platform(name, files, tools, work)
        reference = reference or platform
        results[name] = {"built": f"{platform.archive.name}, {platform.archive.stat().st_size / 1e6:.1f} MB", "run": platform.how}
        for check, function in CHECKS.items():
            begun = time.time()
            try:
                results[name][check] = function(platform, reference)
            except (Fault, OSError, subprocess.TimeoutExpired) as fault:
                failed.append(f"{name}: {check}: {fault}")
                results[name][check] = "FAILED"
            print(f"{name}: {check}: {results[name][check]} ({time.time() - begun:.1f} s)", flush=True)
    print("\n| | " + " | ".join(results) + " |\n|---" * 1 + "|---" * len(results) + "|")
    for row in next(iter(results.values())):
        print(f"| {row} | " + " | ".join(result[row] for result in results.values()) + " |")
    sys.exit("\n" + "\n".join(failed) if failed else 0)


if __name__ == "__main__":
    main()
