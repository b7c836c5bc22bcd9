"""Runs `gaitcam gait` on a recording and classifies the result: right, asked rightly or wrong."""

import json
import re
import subprocess
from dataclasses import dataclass

# Forbidden parts of a text for users: placeholders, missing values, empty brackets and numbers without value.
FAULTS = re.compile(r"\{\$|\bNaN\b(?!['\"`»”])|\bundefined\b|\binf\b|\bnull\b|\(\s*\)|\[\s*\]|  ,|: *$")


@dataclass
class Verdict:
    """Result, its reason, and whether numbers are wrong without a question that covers them."""

    result: str
    why: str = ""
    # True value, lower and upper bound and width of the mass in kg, if stated.
    interval: tuple = ()
    silent: bool = False


def run(binary, recording, folder, *more):
    names = list(recording.files)
    command = [str(binary), "gait", names[0], *recording.args, *more]
    return subprocess.run(command, cwd=folder, capture_output=True, timeout=60)


def question_fits(recording, text):
    return any(re.search(seen, text) and re.search(settles, text) for seen, settles in recording.asks)


def close(value, low, high, part):
    return value is not None and low * (1 - part) <= value <= high * (1 + part)


def differences(recording, d):
    """Wrong numbers: pairs of the question that covers the number, and a sentence."""
    truth, cycle = recording.truth, d.get("cycle") or {}
    if "kind" in truth and d.get("kind") != truth["kind"]:
        yield "kind", f"kind {d.get('kind')}, true {truth['kind']}"
    period = d.get("period_s") or cycle.get("period_s")
    if "period" in truth and not close(period, *truth["period"], truth.get("period_error", 0.005)):
        yield "clock", f"stride time {period}, true {truth['period'][0]:.4f} to {truth['period'][1]:.4f} s"
    mass = d.get("mass_kg")
    if "mass" in truth and "mean" not in truth:
        true, low, high = truth["mass"], d.get("mass_low_kg"), d.get("mass_high_kg")
        held = low is not None and high is not None and low <= true <= high
        error = truth.get("mass_error", 0.01)
        if not held and not close(mass, true, true, error):
            stated = f" ({low:.1f} to {high:.1f})" if low is not None else ""
            off = f" ({100 * (mass / true - 1):+.1f} %)" if mass else ""
            yield "mass", f"mass {mass and round(mass, 2)}{stated}, true {true:.2f} kg{off}"
    if "mean" in truth and not close(cycle.get("mean_n"), truth["mean"], truth["mean"], truth.get("mean_error", 0.01)):
        yield "mean", f"mean force {cycle.get('mean_n')}, true {truth['mean']:.1f} N"
    if "counts" in truth:
        found = [c["stances"] for c in d.get("channels", []) if c["stances"] or c.get("idle") is None]
        lost = sum(truth["counts"]) - sum(found)
        if len(found) != len(truth["counts"]) or not 0 <= lost <= recording.slack or (lost == 0 and found != truth["counts"]):
            yield "counts", f"stances {found}, true {truth['counts']}"
    if "level" in truth:
        for c in d.get("channels", []):
            if c.get("idle") is None and abs(c["baseline_n"] - truth["level"]) > 4:
                yield "mass", f"unloaded level of {c['name']} {c['baseline_n']} N, true {truth['level']} N"


def judge(binary, recording, folder):
    """Classification of one recording, whose files are in the folder."""
    out = run(binary, recording, folder, "--json")
    said = {}
    for language in ("en", "es"):
        done = run(binary, recording, folder, "--lang", language)
        said[language] = (done.stdout + done.stderr).decode("utf-8", "replace")
    for language, text in said.items():
        fault = next((line for line in text.splitlines() if FAULTS.search(line)), None)
        if fault:
            return Verdict("wrong", f"text ({language}): {fault.strip()[:160]}")
    if out.returncode not in (0, 2, 3):
        return Verdict("wrong", f"exit {out.returncode}: {out.stderr.decode()[-200:]}")
    try:
        d = json.loads(out.stdout)
    except ValueError:
        return Verdict("wrong", f"no JSON: {out.stdout[:80]!r}")
    text = said["en"]
    if "error" in d or d.get("cycle") is None:
        message = "\n".join(line for line in text.splitlines() if line.startswith(("gaitcam:", "note", "warning", "open")))
        if question_fits(recording, message):
            return Verdict("asked")
        return Verdict("wrong", "refused: " + " / ".join(message.splitlines())[:300])
    return numbers(recording, d, text)


def shortened(notes):
    """Notes in one line, without the question at the end."""
    lines = [line.split(maxsplit=1)[1] for line in notes.splitlines() if not line.startswith("open")]
    return " / ".join(line[:150] for line in lines)


def numbers(recording, d, text):
    notes = "\n".join(line for line in text.splitlines() if line.startswith(("note", "warning", "open")))
    doubts = d.get("doubts") or []
    low, high = d.get("mass_low_kg"), d.get("mass_high_kg")
    interval = (recording.truth["mass"], low, high) if low is not None and high is not None and "mass" in recording.truth else ()
    if recording.only_asks and not doubts:
        return Verdict("wrong", f"read without a question: kind {d.get('kind')}, mass {d.get('mass_kg')}", interval, True)
    problems = list(differences(recording, d))
    fits = bool(doubts) and question_fits(recording, notes)
    covered = set(doubts) | ({"mass"} if "clock" in doubts else set()) | ({"clock", "mass"} if "kind" in doubts else set())
    silent = [why for about, why in problems if not (fits and about in covered)]
    if silent:
        open_ = f"; open ({', '.join(doubts)}): {shortened(notes)}" if doubts else "; no question"
        return Verdict("wrong", "; ".join(silent) + open_, interval, not doubts)
    if recording.says and not re.search(recording.says, notes):
        return Verdict("wrong", f"does not say {recording.says!r}", interval)
    if doubts and not fits:
        missing = "names no option that settles it" if any(re.search(a, notes) for a, _ in recording.asks) else "asks without reason"
        return Verdict("wrong", f"{missing} ({', '.join(doubts)}): {shortened(notes)}", interval)
    return Verdict("asked" if doubts else "right", "", interval)
