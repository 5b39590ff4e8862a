"""What the checkers of certificates share: exact numbers, polynomials (lowest coefficient first) and matrices, all in fractions."""
import re
import sys
from fractions import Fraction

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)  # lengths are limited where numbers are read


class Rejected(Exception):
    pass


class CannotCheck(Exception):
    pass


def require(condition, message):
    if not condition:
        raise Rejected(message)


def entries(value, names, where):
    require(isinstance(value, dict) and set(value) == set(names), f"{where} needs the entries {', '.join(names)}")


def integer(value, least, most, where):
    require(type(value) is int and least <= value <= most, f"{where} must be an integer from {least} to {most}")
    return value


def fraction(value, where):
    if isinstance(value, dict):
        raise CannotCheck("irrational numbers are not known here")
    require(isinstance(value, str) and len(value) <= 100000 and re.fullmatch(r"-?[0-9]+(/[1-9][0-9]*)?", value),
            f"{where} must be a fraction in quotes")
    result = Fraction(value)
    require(str(result) == value, f"{where} must be in lowest terms")
    return result


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def value_at(p, x):
    result = Fraction(0)
    for c in reversed(p):
        result = result * x + c
    return result


def divided(a, b):
    rest, quotient = list(a), [Fraction(0)] * max(len(a) - len(b) + 1, 0)
    for k in range(len(quotient) - 1, -1, -1):
        quotient[k] = rest[k + len(b) - 1] / b[-1]
        for j, c in enumerate(b):
            rest[k + j] -= quotient[k] * c
    return trimmed(quotient), trimmed(rest)


def gcd(a, b):
    a, b = trimmed(a), trimmed(b)
    while b:
        a, b = b, divided(a, b)[1]
        b = [c / b[-1] for c in b] if b else b
    return [c / a[-1] for c in a]


def roots_between(p, a, b):
    """The number of distinct real roots in (a, b) of a polynomial that is not zero at a and b (Sturm)."""
    p = divided(p, gcd(p, [k * c for k, c in enumerate(p)][1:]))[0]
    chain = [p, [k * c for k, c in enumerate(p)][1:]]
    while trimmed(chain[-1]):
        chain.append([-c for c in divided(chain[-2], chain[-1])[1]])

    def changes(x):
        signs = [v > 0 for v in (value_at(q, x) for q in chain) if v != 0]
        return sum(s != t for s, t in zip(signs, signs[1:]))
    return changes(a) - changes(b)


def has_unit_zero(p):
    if value_at(p, 1) == 0 or value_at(p, -1) == 0:
        return True
    common = gcd(p, p[::-1])
    half = len(common) // 2
    q, before, now = [common[half]] + [Fraction(0)] * half, [Fraction(2)], [Fraction(0), Fraction(1)]
    for k in range(1, half + 1):  # now: z^k + z^-k in powers of z + 1/z
        for j, c in enumerate(now):
            q[j] += common[half - k] * c
        following = [Fraction(0)] + now
        for j, c in enumerate(before):
            following[j] -= c
        before, now = now, following
    return len(trimmed(q)) > 1 and roots_between(trimmed(q), Fraction(-2), Fraction(2)) > 0


def times(a, b):
    return [[sum((x * b[k][j] for k, x in enumerate(row) if x != 0), Fraction(0)) for j in range(len(b[0]))] for row in a]


def characteristic(a):
    """det(x - a), highest coefficient first (Faddeev and LeVerrier)."""
    n = len(a)
    result, m = [Fraction(1)], [[Fraction(0)] * n for _ in range(n)]
    for k in range(1, n + 1):
        m = times(a, m)
        for i in range(n):
            m[i][i] += result[-1]
        result.append(-sum(row[i] for i, row in enumerate(times(a, m))) / k)
    return result
