"""Common fixtures and functions of the tests."""

from pathlib import Path

import pytest

import gaitcam

ROOT = Path(__file__).resolve().parents[2]
CURVES = ROOT / "data" / "gait_curves"
WALK = ROOT / "data" / "recordings" / "made_walk.csv"


@pytest.fixture(scope="session")
def footbridge() -> gaitcam.Scene:
    return gaitcam.Scene.builtin("footbridge")


@pytest.fixture(scope="session")
def design(footbridge: gaitcam.Scene) -> gaitcam.Design:
    return gaitcam.synth(footbridge)


@pytest.fixture(scope="session")
def spectral() -> gaitcam.Scene:
    """Scene with a law in closed form, which has the fastest rows."""
    return gaitcam.Scene.builtin("footbridge").set({"law.family": "harmonic"})
