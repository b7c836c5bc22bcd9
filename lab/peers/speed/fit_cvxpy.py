"""Law of the footbridge with a jerk limit, in the form of a cvxpy user: limits at sampled angles."""

import numpy as np
import common as c


def basis(theta, order):
    """Values of the derivative of an order of the periodic uniform B-splines (Cox-de Boor by convolution)."""
    from math import comb, factorial
    h = 2.0 * np.pi / c.SPANS
    out = np.zeros((len(theta), c.SPANS))
    n = c.DEGREE
    power = n - order
    for j in range(c.SPANS):
        x = np.mod(theta - j * h, 2.0 * np.pi) / h
        value = np.zeros_like(x)
        for k in range(n + 2):
            d = np.maximum(x - k, 0.0)
            value += (-1) ** k * comb(n + 1, k) * d**power / factorial(power)
        out[:, j] = np.where(x < n + 1, value, 0.0) / h**order
    return out


def main():
    import cvxpy as cp

    a = basis(c.THETA, 2)
    j = basis(c.THETA, 3)
    wanted = (c.force(c.THETA) - c.WEIGHT) / (c.MASS * c.OMEGA**2)
    free = np.linalg.lstsq(a, wanted, rcond=None)[0]
    most = 0.6 * np.abs(j @ free).max()

    def run():
        x = cp.Variable(c.SPANS)
        scale = np.abs(wanted).max()
        distance = cp.sum_squares((a @ x - wanted) / scale)
        problem = cp.Problem(cp.Minimize(distance), [j @ x <= most, j @ x >= -most, x[0] == 0])
        problem.solve(solver=cp.CLARABEL)
        return x.value

    seconds, x = c.median_time(run, 15)
    dense = np.linspace(0.0, 2.0 * np.pi, 20011)[:-1]
    made = c.MASS * c.OMEGA**2 * (basis(dense, 2) @ x) + c.WEIGHT
    error = np.sqrt(np.mean((made - c.force(dense)) ** 2)) / c.WEIGHT
    excess = np.abs(basis(dense, 3) @ x).max() / most - 1.0
    c.tell("jerk limit, quintic 32 spans", cp.__version__, seconds, f"{100 * error:.4f} % RMS, limit {excess:+.1e}")


if __name__ == "__main__":
    main()
