"""Diagrams of a design on axes of matplotlib, which is imported only here."""

from typing import Any, Literal

import numpy as np

from gaitcam._missing import needed


def plot(design: Any, ax: Any = None, what: Literal["force", "law", "profile"] = "force") -> Any:
    """Draws force, law or profile of a design on ``ax``, by default on new axes. Returns the axes."""
    if ax is None:
        ax = needed("matplotlib.pyplot", "matplotlib").subplots()[1]
    if not hasattr(ax, "set_xlabel"):
        raise TypeError(f"ax: axes of matplotlib, not {type(ax).__name__}")
    if what == "profile":
        profile = design.profile
        x, y = (1e3 * np.append(profile[name], profile[name][0]) for name in ("x_m", "y_m"))
        ax.plot(x, y, label="profile")
        ax.set(xlabel="x, mm", ylabel="y, mm", aspect="equal")
        return ax
    law = design.law
    theta = np.degrees(law["theta_rad"])
    if what == "law":
        lift = next(name for name in law.column_names if name.startswith("s_"))
        unit, scale = ("mm", 1e3) if lift == "s_m" else ("°", np.degrees(1.0))
        ax.plot(theta, scale * law[lift], label="lift")
        ax.set(xlabel="cam angle, °", ylabel=f"lift, {unit}")
        return ax
    if np.isfinite(law["target_n"]).all():
        ax.plot(theta, law["target_n"], color="0.6", linewidth=3.0, label="target")
    ax.plot(theta, law["force_n"], label="cam")
    ax.set(xlabel="cam angle, °", ylabel="force, N")
    return ax
