"""Runs one search of SciPy's differential evolution on one record with a law in vectorised NumPy. Prints JSON.

The law is integrated as `isolaw --integration paper` does: one classical Runge-Kutta step in displacement per sample.
Usage: scipy_de.py RECORD.csv LAW PARAMETERS EVALUATIONS. LAW is bilinear or bouc-wen. PARAMETERS is a JSON object with
an entry name: [lower, upper] for each parameter, in the order of the law.
"""
import json
import sys
import time

import numpy as np
from scipy.optimize import differential_evolution

POPULATION = 100


def bilinear(parameters, disp):
    K1, K2, xy = parameters
    strength, force = np.abs((K1 - K2) * xy), np.empty((disp.size, K1.size))
    z, before = np.zeros_like(K1), disp[0]
    for i, x in enumerate(disp):
        z = np.clip(z + (K1 - K2) * (x - before), -strength, strength)
        force[i] = K2 * x + z
        before = x
    return force


def bouc_wen(parameters, disp):
    alpha, Ke, A, beta, n, gamma = parameters
    same, opposite = gamma + beta, gamma - beta
    force = np.empty((disp.size, Ke.size))
    z = np.zeros_like(Ke)
    force[0] = alpha * Ke * disp[0]
    for i in range(1, disp.size):
        dx = disp[i] - disp[i - 1]
        direction = 1.0 if dx > 0 else -1.0

        def slope(z):
            return A - np.abs(z) ** n * np.where(direction * z < 0, opposite, same)

        k1 = slope(z)
        k2 = slope(z + 0.5 * dx * k1)
        k3 = slope(z + 0.5 * dx * k2)
        k4 = slope(z + dx * k3)
        z = z + dx / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        force[i] = alpha * Ke * disp[i] + (1.0 - alpha) * Ke * z
    return force


def main(record, law, parameters, evaluations):
    time_s, disp, measured = np.loadtxt(record, delimiter=",", skiprows=1, usecols=(0, 1, 2)).T
    force_of = {"bilinear": bilinear, "bouc-wen": bouc_wen}[law]
    interval = np.diff(time_s)
    weight = 0.5 * (np.append(interval, 0.0) + np.insert(interval, 0, 0.0)) / (time_s[-1] - time_s[0]) / measured.std()
    counted = 0

    def objective(points):  # shape (parameters, candidates)
        nonlocal counted
        counted += points.shape[1]
        with np.errstate(all="ignore"):
            return np.nan_to_num(weight @ np.abs(measured[:, None] - force_of(points, disp)), nan=np.inf)

    bounds = np.array(list(json.loads(parameters).values()))
    middle = float(objective(bounds.mean(axis=1)[:, None])[0])
    counted = 0
    generator = np.random.default_rng(1)
    initial = bounds[:, 0] + generator.random((POPULATION, len(bounds))) * (bounds[:, 1] - bounds[:, 0])
    start, start_cpu = time.perf_counter(), time.process_time()
    found = differential_evolution(objective, bounds, init=initial, maxiter=int(evaluations) // POPULATION - 1, tol=0,
                                   polish=False, seed=generator, vectorized=True, updating="deferred")
    print(json.dumps({"seconds": time.perf_counter() - start, "cpu": time.process_time() - start_cpu,
                      "evaluations": counted, "samples": disp.size, "best": float(found.fun), "objective": middle}))


if __name__ == "__main__":
    main(*sys.argv[1:])
