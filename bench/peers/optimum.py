"""Runs searches of SciPy and of a CMA-ES for bench/optimum. The two programs talk over a socket (bench/peers.cpp).

A task is a line 'method;dimension;residuals;seed;budget'. The script sends points of the unit box, many at once;
bench/optimum evaluates them and remembers the best. A search starts again from other random numbers until its budget is spent.
"""
import os
import struct
import sys

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

try:
    import numpy as np
    from scipy.optimize import differential_evolution, least_squares
except ImportError as error:
    sys.exit(f"python3-scipy is not installed: {error}")
try:
    import cmaes
except ImportError:
    cmaes = None
    print("skipped: CMA-ES; python3-cmaes is not installed", file=sys.stderr)

DONE, VALUES, RESIDUALS = 0, 1, 2
DIFFERENCE = 1e-6
WORST = 1e10  # takes the place of infinity, which some methods cannot handle


class BudgetSpent(Exception):
    pass


class Problem:
    def __init__(self, dimension, residuals, budget):
        self.dimension, self.count, self.left = dimension, residuals, budget

    def ask(self, kind, points, width):
        if self.left <= 0:
            raise BudgetSpent
        points = np.ascontiguousarray(np.atleast_2d(points), dtype=float)
        self.left -= len(points)
        sys.stdout.buffer.write(struct.pack("=ii", kind, len(points)) + points.tobytes())
        sys.stdout.buffer.flush()
        answer = np.frombuffer(bytearray(sys.stdin.buffer.read(8 * width * len(points))))
        return answer.reshape(len(points), width)

    def values(self, points):
        return self.ask(VALUES, points, 1)[:, 0]

    def residuals(self, points):
        return self.ask(RESIDUALS, points, self.count)

    def jacobian(self, x):
        steps = np.where(x > 0.5, -DIFFERENCE, DIFFERENCE)
        r = self.residuals(np.vstack([x, x + np.diag(steps)]))
        with np.errstate(invalid="ignore"):
            return np.nan_to_num(((r[1:] - r[0]) / steps[:, None]).T, nan=0.0, posinf=0.0, neginf=0.0)


def descents(problem, generator):
    """Least squares from random starts. soft_l1 rounds the corner of the absolute value: first much, then little."""
    while True:
        x = generator.random(problem.dimension)
        for rounding in (0.3, 0.01):
            size = np.abs(problem.residuals(x)[0]).mean()
            if not np.isfinite(size):
                break
            x = least_squares(lambda x: problem.residuals(x)[0], x, problem.jacobian, (0.0, 1.0), loss="soft_l1",
                              f_scale=rounding * size, max_nfev=100).x


def evolution(problem, generator):
    while True:
        differential_evolution(lambda x: problem.values(x.T) if x.ndim > 1 else problem.values(x)[0],
                               [(0.0, 1.0)] * problem.dimension, seed=generator, vectorized=True, updating="deferred")


def mirrored(points):
    """Reflects points at the faces of the unit box."""
    return 1.0 - np.abs(np.mod(points, 2.0) - 1.0)


def adaptation(problem, generator):
    """Runs CMA-ES again and again, each time with twice the population."""
    size = None
    while True:
        search = cmaes.CMA(generator.random(problem.dimension), 0.3, seed=int(generator.integers(2**31)),
                           population_size=size)
        while not search.should_stop():
            points = [search.ask() for _ in range(search.population_size)]
            values = np.nan_to_num(problem.values(mirrored(np.array(points))), nan=WORST, posinf=WORST)
            search.tell(list(zip(points, values)))
        size = 2 * search.population_size


METHODS = {"SciPy least squares, random starts": descents, "SciPy differential evolution": evolution}
if cmaes is not None:
    METHODS["CMA-ES"] = adaptation

print(";".join(METHODS), flush=True)
for line in iter(sys.stdin.buffer.readline, b""):
    method, dimension, residuals, seed, budget = line.decode().split(";")
    try:
        METHODS[method](Problem(int(dimension), int(residuals), int(budget)), np.random.default_rng(int(seed)))
    except BudgetSpent:
        pass
    sys.stdout.buffer.write(struct.pack("=ii", DONE, 0))
    sys.stdout.buffer.flush()
