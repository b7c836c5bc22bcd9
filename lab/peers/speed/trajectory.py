#!/usr/bin/env python3
"""Compares programs for trajectories on a rise from rest to rest with a jerk limit: writes reports/trajectory.md, which
docs/comparison.md cites.

    pip install ./python scipy toppra ruckig drake && python3 lab/peers/speed/trajectory.py

In units of the rise and its duration, |jerk| ≤ 50. The minimum peak acceleration in time 1 is 5, and with |acceleration| ≤ 5 the
minimum time is 1 (docs/theory/program.md). Peaks are evaluated at 20 011 points that no program uses. For gaitcam they are the exact
peaks of its law for rise and fall, and the time is that of the complete design. Programs that are not installed are left out.
"""

import statistics
import time
from pathlib import Path

import numpy as np

PEAK, JERK = 5.0, 50.0
SCENE = {
    "name": "rise",
    "drive": {"kind": "fixed-axis", "speed": "15 rpm"},
    "law": {"family": "spline", "minimise": "peak-acceleration", "dwell": [
        {"from": "90 deg", "to": "180 deg", "lift": "10 mm"}, {"from": "270 deg", "to": "360 deg", "lift": "0 mm"}]},
    "cam": {"follower": "roller-translating", "roller_radius": "8 mm", "prime_radius": "60 mm"},
    "limits": {"jerk": "0.5 m/s^3"},
}


def peaks(derivative, duration):
    """Maximum acceleration and jerk of a motion at points between all samples."""
    t = np.linspace(0.0, duration, 20011)
    return [max(abs(derivative(x, order)) for x in t) for order in (2, 3)]


def timed(solve, repeats=7):
    answer, times = solve(), []
    for _ in range(repeats):
        start = time.process_time()
        answer = solve()
        times.append(time.process_time() - start)
    return answer, statistics.median(times)


def ruckig():
    import ruckig as r
    given = r.InputParameter(1)
    given.target_position, given.max_velocity = [1.0], [100.0]
    given.max_acceleration, given.max_jerk = [PEAK], [JERK]

    def solve():
        motion = r.Trajectory(1)
        r.Ruckig(1).calculate(given, motion)
        return motion

    motion, seconds = timed(solve)
    # The jerk is constant on every piece.
    t = np.linspace(0.0, motion.duration, 20011)
    a = np.array([motion.at_time(x)[2][0] for x in t])
    return motion.duration, [abs(a).max(), abs(np.diff(a) / np.diff(t)).max()], seconds


def toppra():
    import toppra as ta
    ta.setup_logging("ERROR")
    path = ta.SplineInterpolator([0, 0.5, 1], [[0], [0.5], [1]])
    limits = [ta.constraint.JointVelocityConstraint(np.array([[-100.0, 100.0]])),
              ta.constraint.JointAccelerationConstraint(np.array([[-PEAK, PEAK]]))]
    solve = lambda: ta.algorithm.TOPPRA(limits, path, parametrizer="ParametrizeConstAccel").compute_trajectory(0, 0)
    motion, seconds = timed(solve)
    a = motion(np.linspace(0.0, motion.duration, 20011), 2).ravel()
    jerk = float("inf")  # the acceleration jumps from one bound to the other
    assert abs(np.diff(a)).max() > PEAK
    return motion.duration, [abs(a).max(), jerk], seconds


def drake(points):
    from pydrake.planning import KinematicTrajectoryOptimization
    from pydrake.solvers import Solve
    from pydrake.trajectories import BsplineTrajectory

    def solve():
        k = KinematicTrajectoryOptimization(1, points, 4)
        k.AddDurationConstraint(0.3, 3.0)
        k.AddDurationCost(1.0)
        for s, lift in ((0, 0.0), (1, 1.0)):
            k.AddPathPositionConstraint([lift], [lift], s)
            k.AddPathVelocityConstraint([0.0], [0.0], s)
            k.AddPathAccelerationConstraint([0.0], [0.0], s)
        k.AddAccelerationBounds([-PEAK], [PEAK])
        k.AddJerkBounds([-JERK], [JERK])
        k.SetInitialGuess(BsplineTrajectory(k.basis(), [np.array([[v]]) for v in np.linspace(0.0, 1.0, points)]))
        found = Solve(k.prog())
        assert found.is_success()
        return k.ReconstructTrajectory(found)

    motion, seconds = timed(solve)
    return motion.end_time(), peaks(lambda x, n: motion.EvalDerivative(x, n)[0, 0], motion.end_time()), seconds


def sampled(spans, rows):
    """Quintic spline with limits at the centres of `rows` parts of every span, by a linear program."""
    from scipy.interpolate import BSpline
    from scipy.optimize import linprog
    knots = np.concatenate([[0.0] * 5, np.linspace(0.0, 1.0, spans + 1), [1.0] * 5])
    basis = BSpline(knots, np.eye(spans + 5), 5)
    at = (np.arange(spans * rows) + 0.5) / (spans * rows)
    a, j = basis.derivative(2)(at), basis.derivative(3)(at)
    one, none = np.ones((len(at), 1)), np.zeros((len(at), 1))
    above = np.vstack([np.hstack([a, -one]), np.hstack([-a, -one]), np.hstack([j, none]), np.hstack([-j, none])])
    ends = np.vstack([basis.derivative(n)(x) for x in (0.0, 1.0) for n in range(3)])
    cost, bound = np.eye(spans + 6)[-1], np.repeat([0.0, JERK], 2 * len(at))
    solve = lambda: linprog(cost, above, bound, np.hstack([ends, np.zeros((6, 1))]), [0, 0, 0, 1, 0, 0], (None, None)).x
    x, seconds = timed(solve)
    law = BSpline(knots, x[:-1], 5)
    return 1.0, peaks(lambda t, n: law.derivative(n)(t), 1.0), seconds


def gaitcam(degree, spans):
    import gaitcam as g
    scene = g.Scene(SCENE).set({"law.degree": degree, "law.spans": spans})
    design, seconds = timed(lambda: g.synth(scene))
    law, scale = design.summary["law"], np.pi / 2  # a rise of 10 mm takes a quarter of a turn, 1 s
    peak = max(abs(law[f"a_{e}_m_per_rad2"]) for e in ("max", "min")) * scale**2 / 0.01
    jerk = max(abs(law[f"j_{e}_m_per_rad3"]) for e in ("max", "min")) * scale**3 / 0.01
    return 1.0, [peak, jerk], seconds


def main():
    rows = [
        ("ruckig", ruckig, ()), ("toppra", toppra, ()),
        ("drake, 16 control points", drake, (16,)), ("drake, 32 control points", drake, (32,)),
        ("scipy linprog, 16 spans, 1 row a span", sampled, (16, 1)), ("scipy linprog, 16 spans, 10 rows a span", sampled, (16, 10)),
        ("gaitcam, degree 5, 16 spans a rise", gaitcam, (5, 64)), ("gaitcam, degree 5, 32 spans a rise", gaitcam, (5, 128)),
        ("gaitcam, degree 3, 10 spans a rise", gaitcam, (3, 40)),
    ]
    page = ("# Trajectory programs on one rise\n\nWritten by `lab/peers/speed/trajectory.py` in one run, with medians of processor times.\n\n"
            "| program | duration | peak acceleration | largest jerk | time of the processor |\n|---|---|---|---|---|\n")
    for name, run, arguments in rows:
        try:
            duration, (peak, jerk), seconds = run(*arguments)
        except ImportError as missing:
            page += f"| {name} | skipped: {missing} | | | |\n"
            continue
        page += f"| {name} | {duration:.4f} | {peak:.4f} | {jerk:.3f} | {1e3 * seconds:.3g} ms |\n"
    print(page)
    (Path(__file__).resolve().parents[3] / "reports" / "trajectory.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
