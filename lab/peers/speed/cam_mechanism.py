"""Double-dwell roller cam of the package `mechanism` with 3600 points: motion and pitch curve only, without
pictures (the package has no roller envelope)."""

import importlib.metadata

import numpy as np
import common as c
from mechanism import Cam

BASE, ROLLER = 40.0, 10.0
MOTION = [("Rise", 20, 90), ("Dwell", 90), ("Fall", 20, 90), ("Dwell", 90)]


def exact(theta):
    """True profile, the envelope of the roller."""
    turn = 2.0 * np.pi
    x = np.mod(theta, turn) / (turn / 4.0)
    rise = lambda u: (u - np.sin(turn * u) / turn, 1.0 - np.cos(turn * u))
    s = np.select([x < 1, x < 2, x < 3], [20 * rise(x)[0], 20.0 + 0 * x, 20 * (1 - rise(x - 2)[0])], 0.0)
    rate = 20 / (turn / 4.0)
    v = np.select([x < 1, x < 2, x < 3], [rate * rise(x)[1], 0 * x, -rate * rise(x - 2)[1]], 0.0)
    up = BASE + ROLLER + s
    lean = np.arctan2(v, up)
    px, py = ROLLER * np.sin(lean), up - ROLLER * np.cos(lean)
    return np.hypot(px, py), theta + np.arctan2(px, py)


def main():
    def run():
        cam = Cam(motion=MOTION, degrees=True, omega=1, h=2.0 * np.pi / 3600)
        radius = BASE + cam.cycloidal.S
        return cam.thetas, radius

    seconds, (theta, radius) = c.median_time(run, 11)
    angle = exact(theta)[1]
    order = np.argsort(angle)
    true = np.interp(theta, angle[order], exact(theta)[0][order])
    worst = np.abs(np.asarray(radius) - true).max()
    # The result and the true profile as x and y at the same angles.
    true_x, true_y = true * np.cos(theta), true * np.sin(theta)
    off = np.hypot(radius * np.cos(theta) - true_x, radius * np.sin(theta) - true_y).max()
    words = (
        f"{len(theta)} points, radius off by {worst:.2f} mm, x and y by {off:.2f} mm "
        "(base circle + lift, no roller)"
    )
    c.tell("double-dwell roller cam, 3600 points", importlib.metadata.version("mechanism"), seconds, words)


main()
