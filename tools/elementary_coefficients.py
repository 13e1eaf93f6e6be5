#!/usr/bin/env python3
"""Computes the coefficients of src/isolaw/num/elementary.hpp. Needs mpmath. Usage: tools/elementary_coefficients.py

Each polynomial minimises the squared relative errors at Chebyshev points. Its largest error is then at most twice that
of the best polynomial. The coefficients are rounded to double one by one, the lowest order first. After each rounding
the remaining coefficients are fitted again.
"""
from mpmath import mp, mpf

mp.dps = 60


def fit(function, lower, upper, degree, fixed=()):
    """Returns doubles c[0..degree] with sum c[k] x^k ~ function(x); the caller may give the first ones."""
    count = 6 * (degree + 1)
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    points = [middle + half * mp.cos(mp.pi * (2 * k + 1) / (2 * count)) for k in range(count)]
    values = [function(x) for x in points]
    done = [mpf(c) for c in fixed]
    while len(done) <= degree:
        free = range(len(done), degree + 1)
        rows = mp.matrix(count, len(free))
        right = mp.matrix(count, 1)
        for i, (x, y) in enumerate(zip(points, values)):
            for j, k in enumerate(free):
                rows[i, j] = x**k / y
            right[i] = (y - mp.polyval(done[::-1], x)) / y if done else 1
        best = mp.lu_solve(rows.T * rows, rows.T * right)
        done.append(mpf(float(best[0])))
    return done


def report(name, coefficients, error, lower, upper, samples=2001):
    worst = max(abs(error(lower + (upper - lower) * mpf(k) / (samples - 1))) for k in range(samples))
    print(f"// {name}: largest relative error of the polynomial {mp.nstr(worst, 3)} = 2^{mp.nstr(mp.log(worst, 2), 3)}")
    print("{" + ", ".join(float(c).hex() for c in coefficients) + "}")
    print("{" + ", ".join(repr(float(c)) for c in coefficients) + "}\n")


def power_of(base, degree, half, ones):
    """Reports the coefficients of base^f = 1 + f q(f) on [-half, half]; the first `ones` coefficients are 1."""
    function = lambda f: mp.power(base, f)
    c = fit(function, -half, half, degree, [1] * ones)
    report(f"{mp.nstr(base, 4)}^f, |f| <= {mp.nstr(half, 4)}, degree {degree}", c,
           lambda f: mp.polyval(c[::-1], f) / function(f) - 1, -half, half)


def logarithm_of(name, scale, degree, fixed=()):
    """Reports the coefficients of p in scale ln(m) = s p(s^2), s = (m - 1) / (m + 1), m in [sqrt(1/2), sqrt(2)]."""
    largest = ((mp.sqrt(2) - 1) / (mp.sqrt(2) + 1)) ** 2
    # Near w = s^2 = 0 the formula with the logarithm would lose all digits, so its power series is summed instead.
    function = lambda w: 2 * scale * sum(w**k / (2 * k + 1) for k in range(40))
    c = fit(function, mpf(0), largest, degree, fixed)
    report(f"{name} as s p(s^2), degree {degree} in s^2", c, lambda w: mp.polyval(c[::-1], w) / function(w) - 1, mpf(0),
           largest)


if __name__ == "__main__":
    half = mpf(1) / 2
    print("// ln 2 in two parts, the first with 21 trailing zero bits")
    ln2 = mp.log(2)
    high = mpf(int(ln2 * 2**32)) / 2**32
    print(float(high).hex(), float(ln2 - high).hex(), repr(float(high)), repr(float(ln2 - high)), "\n")
    power_of(mpf(2), 11, half, 1)
    power_of(mp.e, 11, half * ln2 * mpf("1.0001"), 2)
    logarithm_of("ln", 1, 7, [2])
    logarithm_of("log2", 1 / ln2, 6)
