"""Law of the footbridge with limits on acceleration and jerk at 95 % of the law without limits, in the form of users of three solvers.

The Bernstein coefficients of acceleration and jerk on every span are limited. These 448 rows also hold between the samples and are
slightly stricter than the limits. The time of a solver contains its setup and solution, but not the assembly of the matrices. Each
solver gets its best form: no free level (the first coefficient is 0 and left out), and both sides of a row in one if possible.
"""

import importlib.metadata

import numpy as np
import common as c
from fit_cvxpy import basis

SHARE = 0.95
TASK = "acceleration and jerk at 95 %, quintic 32 spans"


def bernstein(order):
    """Rows of the Bernstein coefficients of a derivative on every span."""
    degree = c.DEGREE - order
    inside = (np.arange(degree + 1) + 0.5) / (degree + 1)
    powers = [np.array([binomial(degree, k) * u**k * (1 - u) ** (degree - k) for k in range(degree + 1)]) for u in inside]
    back = np.linalg.inv(np.array(powers))
    step = 2.0 * np.pi / c.SPANS
    return np.vstack([back @ basis(step * (span + inside), order) for span in range(c.SPANS)])


def binomial(n, k):
    from math import comb

    return comb(n, k)


def problem():
    """Least squares ½xᵀHx + gᵀx with |rows·x| ≤ 1, where x is scaled so that all coefficients are near one."""
    a = basis(c.THETA, 2)[:, 1:]
    wanted = (c.force(c.THETA) - c.WEIGHT) / (c.MASS * c.OMEGA**2)
    free = np.linalg.lstsq(a, wanted, rcond=None)[0]
    rows = []
    for order in (2, 3):
        dense = np.linspace(0.0, 2.0 * np.pi, 20011)[:-1]
        most = SHARE * np.abs(basis(dense, order)[:, 1:] @ free).max()
        rows.append(bernstein(order)[:, 1:] / most)
    unit = np.abs(free).max()
    a, wanted = a * unit / np.abs(wanted).max(), wanted / np.abs(wanted).max()
    h = a.T @ a / len(wanted)
    g = -a.T @ wanted / len(wanted)
    return h, g, np.vstack(rows) * unit, unit


def daqp(h, g, rows):
    import daqp

    ones = np.ones(len(rows))

    def run():
        x, _, flag, _ = daqp.solve(h, g, rows, ones, -ones)
        assert flag == 1
        return x

    return run


def daqp_one_sided(h, g, rows):
    """Least squares with a row for each side of a limit."""
    import daqp

    both = np.vstack([rows, -rows])
    ones = np.ones(len(both))

    def run():
        x, _, flag, _ = daqp.solve(h, g, both, ones)
        assert flag == 1
        return x

    return run


def piqp(h, g, rows):
    import piqp

    ones = np.ones(len(rows))
    h, rows = np.asfortranarray(h), np.asfortranarray(rows)

    def run():
        solver = piqp.DenseSolver()
        solver.setup(h, g, None, None, rows, -ones, ones)
        assert solver.solve() == piqp.PIQP_SOLVED
        return solver.result.x

    return run


def clarabel(h, g, rows):
    import clarabel
    from scipy import sparse

    both = sparse.csc_matrix(np.vstack([rows, -rows]))
    ones = np.ones(2 * len(rows))
    upper = sparse.csc_matrix(np.triu(h))
    settings = clarabel.DefaultSettings()
    settings.verbose = False

    def run():
        cones = [clarabel.NonnegativeConeT(len(ones))]
        solution = clarabel.DefaultSolver(upper, g, both, ones, cones, settings).solve()
        assert str(solution.status) == "Solved"
        return np.array(solution.x)

    return run


def main():
    h, g, rows, unit = problem()
    dense = np.linspace(0.0, 2.0 * np.pi, 20011)[:-1]
    wanted = c.force(dense)
    free = np.linalg.lstsq(basis(c.THETA, 2)[:, 1:], (c.force(c.THETA) - c.WEIGHT) / (c.MASS * c.OMEGA**2), rcond=None)[0]
    solvers = {
        "DAQP": (daqp, "daqp"),
        "DAQP, 448 rows of one side": (daqp_one_sided, "daqp"),
        "PIQP": (piqp, "piqp"),
        "Clarabel": (clarabel, "clarabel"),
    }
    for name, (solver, package) in solvers.items():
        seconds, x = c.median_time(solver(h, g, rows), 201)
        x = unit * x
        made = c.MASS * c.OMEGA**2 * (basis(dense, 2)[:, 1:] @ x) + c.WEIGHT
        error = np.sqrt(np.mean((made - wanted) ** 2)) / c.WEIGHT
        excess = -1.0
        for order in (2, 3):
            all_round = basis(dense, order)[:, 1:]
            most = SHARE * np.abs(all_round @ free).max()
            excess = max(excess, np.abs(all_round @ x).max() / most - 1.0)
        version = f"{name} {importlib.metadata.version(package)}"
        c.tell(TASK, version, seconds, f"{100 * error:.4f} % RMS, limits {excess:+.1e}")


if __name__ == "__main__":
    main()
