"""Laws as functions of arrays."""

import numpy as np
import pytest

import gaitcam


def test_the_cycloid_and_its_derivatives_are_exact():
    x = np.linspace(0, 1, 101)[1:-1]
    s, v, a, j = gaitcam.Law("cycloidal")(x)
    w = 2 * np.pi
    assert s == pytest.approx(x - np.sin(w * x) / w, abs=1e-14)
    assert v == pytest.approx(1 - np.cos(w * x), abs=1e-13)
    assert a == pytest.approx(w * np.sin(w * x), abs=1e-12)
    assert j == pytest.approx(w**2 * np.cos(w * x), abs=1e-11)


def test_the_catalogue_has_the_published_peak_factors():
    laws = gaitcam.laws()
    # Norton, Cam Design and Manufacturing Handbook: velocity and acceleration factors.
    for name, cv, ca in [("cycloidal", 2.0, 2 * np.pi), ("3-4-5", 1.875, 5.7735), ("4-5-6-7", 2.1875, 7.5132),
                         ("modified-sine", 1.7596, 5.5280), ("modified-trapezoid", 2.0, 4.8881)]:
        assert laws[name].factors["cv"] == pytest.approx(cv, rel=1e-4)
        assert laws[name].factors["ca"] == pytest.approx(ca, rel=1e-4)


def test_values_have_the_shape_of_the_angles():
    law = gaitcam.Law("3-4-5")
    assert law(np.zeros((2, 3, 4)) + 0.5).v.shape == (2, 3, 4)
    at = law(0.5)
    assert isinstance(at.s, float) and at.s == pytest.approx(0.5)
    assert law([]).s.shape == (0,)
    assert law(range(2)).s == pytest.approx([0, 1])


def test_a_program_of_segments_is_a_closed_law():
    law = gaitcam.program([("cycloidal", "20 mm", "90 deg"), ("dwell", 0, "90 deg"), ("3-4-5", -0.02, np.pi)])
    assert law.closed and law.stroke == pytest.approx(0.02, abs=1e-12)
    assert law(np.pi * 0.75).s == pytest.approx(0.02, abs=1e-12)
    assert law(2 * np.pi + 0.3).s == pytest.approx(law(0.3).s, abs=1e-12)
    (low, _), (high, at) = law.extremes(1)
    assert high == pytest.approx(2 * 0.02 / (np.pi / 2), rel=1e-9) and at == pytest.approx(np.pi / 4, abs=1e-6)


@pytest.mark.parametrize("wrong, error", [("a", TypeError), (None, TypeError), (np.nan, gaitcam.InputError)])
def test_angles_that_are_none_are_refused(wrong, error):
    with pytest.raises(error, match="theta"):
        gaitcam.Law("cycloidal")(wrong)


def test_unknown_laws_and_orders_are_named():
    with pytest.raises(gaitcam.InputError, match="cycloidal"):
        gaitcam.Law("cycloidl")
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Law("cycloidal").extremes(4)
    assert fault.value.key == "order"
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.program([("cycloidal", "20 kg", "90 deg")])
    assert fault.value.key == "segment.1.lift"
