"""A generated recording with its true values, and the walks for most classes."""

import zlib
from dataclasses import dataclass, field

import numpy as np

from walker import G, Sensor, measured, walk

SEED = 58
CASES = []



def options(names):
    """Pattern for the name of an option in messages: `option mass`, `options period and mass`, `--mass`, `gait.mass`."""
    return rf"(options? ([a-z]+(, | and ))*|--|gait\.)({names})\b|\b({names}) = "


# Words for an observation, and words for the option that settles it.
CLOCK = (r"stride (time|duration)|one (step|stride)|duty", options("mass|period|span|rate|file"))
INSOLE = (r"insole", options("mass") + r"|give the (walker's )?mass")


@dataclass
class Recording:
    """Recording with its files (the first is read), options, true values and the justified questions."""

    files: dict
    truth: dict
    args: list = field(default_factory=list)
    # Pairs of patterns: the observation and the option that settles it.
    asks: list = field(default_factory=list)
    # Pattern that the text must contain if the recording is read.
    says: str = ""
    # Maximum number of stances that may be left out.
    slack: int = 0
    # Whether a rejection or a question is the only correct result.
    only_asks: bool = False
    group: str = ""
    name: str = ""


def case(group, count):
    """Registers a function that generates the i-th recording of a class."""

    def add(make):
        CASES.extend((group, make, i) for i in range(count))
        return make

    return add


def build(group, make, i):
    """The i-th recording of a class. It is the same in every run."""
    name = make.__name__.replace("_", "-")
    rng = np.random.default_rng([SEED, zlib.crc32(name.encode()), i])
    recording = make(rng, i)
    recording.group, recording.name = group, f"{name}-{i:02d}"
    return recording


@dataclass
class Trial:
    """Times from zero, true forces per channel, the walk, and the start time of the trial in it."""

    t: np.ndarray
    forces: np.ndarray
    walk: object
    start: float
    counts: list

    def truth(self, end=None, **more):
        """True values of a reading up to a time of the trial."""
        t1 = self.start + (self.t[-1] if end is None else end)
        n = max(1, sum(self.counts))
        low, high = self.walk.stride_range(self.start - 1e-6, t1)
        return {"mass": self.walk.mass, "mass_error": max(0.01, 3 * self.walk.cv_impulse / np.sqrt(n)), "period": (low, high),
                "counts": self.counts, "kind": "walking", **more}

    def until(self, end):
        """True values of the part before a time."""
        trial = Trial(self.t, self.forces, self.walk, self.start, self.walk.counts(self.start, self.start + end))
        return trial.truth(end)


def belts(rng, rate=200.0, steps=20, idle=False, **of_walk):
    """Trial with a channel for each foot. The recording starts and ends within stances, or with unloaded plates."""
    w = walk(rng, steps=steps, **of_walk)
    start, end = (0.0, w.stances[-1].end + 0.4) if idle else (w.middle(1), w.middle(steps - 2))
    t = np.arange(int((end - start) * rate)) / rate
    return Trial(t, w.feet(t + start), w, start, w.counts(start, start + t[-1]))


def walkway(rng, rate=1000.0, plates=2, first=None, **of_walk):
    """Trial with one stance on each of several plates in a row, which are unloaded before and after."""
    first = int(rng.integers(2)) if first is None else first
    w = walk(rng, steps=plates, first=first, start=rng.uniform(0.4, 0.8), **of_walk)
    t = np.arange(int((w.stances[-1].end + rng.uniform(0.4, 0.8)) * rate)) / rate
    forces = np.array([s.force(t) for s in w.stances])
    return Trial(t, forces, w, 0.0, [1] * plates)


def with_sensor(rng, trial, **sensor):
    return measured(rng, trial.t, trial.forces, Sensor(**sensor))


def weight(trial):
    return trial.walk.mass * G
