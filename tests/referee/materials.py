"""Elastic constants of cam and follower, and the pressure that their contact bears."""

import unicodedata

from units import quantity

# Young's modulus in Pa, Poisson's ratio, yield strength in Pa: typical values of the materials.
MATERIALS = {
    "steel": (206.8e9, 0.30, 430e6),
    "cast-iron": (169e9, 0.275, 320e6),
    "bronze": (95e9, 0.34, 140e6),
    "aluminium": (70e9, 0.33, 250e6),
    "pom": (2.8e9, 0.37, 65e6),
    "pa66": (1.7e9, 0.40, 55e6),
    "pla": (3.3e9, 0.36, 50e6),
    "petg": (2.0e9, 0.38, 45e6),
}
SPANISH = {"acero": "steel", "fundicion": "cast-iron", "bronce": "bronze", "aluminio": "aluminium"}
# Rockwell C, Vickers, Brinell of steel (ASTM E140, table 1).
HARDNESS = ((20, 238, 226), (25, 266, 253), (30, 302, 286), (35, 345, 327), (40, 392, 371), (45, 446, 421), (50, 513, 481), (55, 595, 560),
            (58, 653, 615), (60, 697, 654), (62, 746, 688), (64, 800, 722))


def known(name):
    """The material of a text in a scene; `None` for a designation of steel."""
    plain = unicodedata.normalize("NFD", str(name).strip().lower())
    plain = "".join(c for c in plain if not unicodedata.combining(c))
    return MATERIALS.get(SPANISH.get(plain, plain))


def body(cam, key):
    """Young's modulus, Poisson's ratio, and the pressure that the body bears, or `None`."""
    stated = cam.get(key)
    if isinstance(stated, dict):
        young, poisson = quantity(stated.get("young")), quantity(stated.get("poisson"))
        bears = quantity(stated.get("allowable_pressure"))
        return young or MATERIALS["steel"][0], MATERIALS["steel"][1] if poisson is None else poisson, bears
    row = known(stated) if stated else None
    young, poisson, strength = row or MATERIALS["steel"]
    # Tresca: the greatest shear, 0.300 of the pressure, is half of the yield strength.
    return young, poisson, strength / 0.6 if row else None


def contact_modulus(scene):
    bodies = [body(scene["cam"], key)[:2] for key in ("material", "follower_material")]
    return 1 / sum((1 - poisson**2) / young for young, poisson in bodies)


def brinell(text):
    value, scale = str(text).split()
    column = {"HRC": 0, "HV": 1, "HB": 2}[scale.upper()]
    if float(value) <= HARDNESS[0][column]:
        return float(value) * HARDNESS[0][2] / HARDNESS[0][column]
    for low, high in zip(HARDNESS, HARDNESS[1:]):
        if low[column] <= float(value) <= high[column]:
            part = (float(value) - low[column]) / (high[column] - low[column])
            return low[2] + part * (high[2] - low[2])
    return float(value)


def allowable(scene):
    """The lower pressure of both bodies, Pa; that of the cam from its hardness where it is not stated. `None` if nothing is known."""
    cam = scene["cam"]
    own = body(cam, "material")[2]
    stated = isinstance(cam.get("material"), dict) and own is not None
    if not stated and cam.get("hardness") is not None:
        own = 2.76e6 * brinell(cam["hardness"]) - 70e6
    found = [p for p in (own, body(cam, "follower_material")[2]) if p is not None]
    return min(found, default=None)
