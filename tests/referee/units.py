"""Quantities of scene files in SI units."""

import math
import re

INCH, POUND_FORCE, GRAVITY = 0.0254, 4.4482216152605, 9.80665
FACTORS = {
    "m": 1.0, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "µm": 1e-6, "in": INCH, "inch": INCH, "ft": 12 * INCH,
    "rad": 1.0, "deg": math.pi / 180, "°": math.pi / 180, "rev": 2 * math.pi,
    "s": 1.0, "ms": 1e-3, "min": 60.0, "Hz": 1.0, "kHz": 1e3, "rpm": 2 * math.pi / 60,
    "N": 1.0, "kN": 1e3, "daN": 10.0, "lbf": POUND_FORCE, "lb": POUND_FORCE, "kgf": GRAVITY,
    "kg": 1.0, "g": 1e-3, "lbm": 0.45359237, "Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "GPa": 1e9, "bar": 1e5,
    "psi": POUND_FORCE / INCH**2, "W": 1.0, "kW": 1e3, "%": 1e-2, "": 1.0,
}


def factor(unit):
    """SI value of a product of units such as `N m s/rad` or `psi/in^3`."""
    value = 1.0
    for place, part in enumerate(unit.split("/")):
        for word in part.replace("·", " ").split():
            name, _, power = word.partition("^")
            name = name.replace("²", "").replace("³", "")
            power = int(power) if power else (2 if "²" in word else 3 if "³" in word else 1)
            value *= FACTORS[name] ** (power if place == 0 else -power)
    return value


def quantity(value):
    """Number in SI units from a number or a text with a unit; `None` if the text is not a quantity."""
    if isinstance(value, bool) or value is None:
        return None
    if isinstance(value, (int, float)):
        return float(value)
    match = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(.*?)\s*", value)
    if not match:
        return None
    try:
        return float(match[1]) * factor(match[2])
    except KeyError:
        return None
