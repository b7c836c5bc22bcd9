"""Tasks of the comparison, the same as in the Rust benchmark `peers`."""

import json
import math
import statistics
import sys
import time

import numpy as np

PERIOD = 1.0 / 1.85
OMEGA = 2.0 * np.pi / PERIOD
WEIGHT, GRAVITY = 700.0, 9.81
MASS = WEIGHT / GRAVITY
SAMPLES, SPANS, DEGREE = 1024, 32, 5
# Young's load factors and phases at 1.85 Hz, as in the model "young" of gaitcam.
F = 1.85
FACTORS = [0.37 * (F - 0.95), 0.054 + 0.0044 * F, 0.026 + 0.0050 * F, 0.010 + 0.0051 * F]
THETA = 2.0 * np.pi * np.arange(SAMPLES) / SAMPLES


def force(theta):
    """Target force, N. The phases of the harmonics have no influence on time and error."""
    return WEIGHT * (1.0 + sum(a * np.sin((i + 1) * theta) for i, a in enumerate(FACTORS)))


def median_time(run, repeats=31):
    """Median processor time of `run` in all threads after a warm-up, s, and its result."""
    answer = run()
    if "once" in sys.argv:
        # The time of the whole process is measured from outside.
        return math.nan, answer
    times = []
    for _ in range(repeats):
        start = time.process_time_ns()
        answer = run()
        times.append(1e-9 * (time.process_time_ns() - start))
    return statistics.median(times), answer


def tell(task, version, seconds, error):
    print(json.dumps({"task": task, "version": version, "seconds": seconds, "error": error}))
