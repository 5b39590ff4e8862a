"""Numbers that are not fractions: enclosures with ends in units of 2^-BITS, always rounded outwards, and the fields Q(cos(2 pi/N)).

Nothing here knows what the numbers are for.
"""
import math
from fractions import Fraction
from functools import lru_cache

from certificate_algebra import CannotCheck, divided, entries, fraction, integer, require, trimmed

BITS = 160
ONE = 1 << BITS


class Enclosure:
    """All real numbers from low to high, both in units of 2^-BITS."""
    __slots__ = ("low", "high")

    def __init__(self, low, high):
        self.low, self.high = low, high

    def __add__(self, other):
        return Enclosure(self.low + other.low, self.high + other.high)

    def __sub__(self, other):
        return Enclosure(self.low - other.high, self.high - other.low)

    def __neg__(self):
        return Enclosure(-self.high, -self.low)

    def __mul__(self, other):
        ends = (self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high)
        return Enclosure(min(ends) >> BITS, -(-max(ends) >> BITS))

    def over(self, other):
        require(other.low > 0, "a division by what may not be positive")
        low = (self.low << BITS) // (other.high if self.low >= 0 else other.low)
        high = -((-self.high << BITS) // (other.low if self.high >= 0 else other.high))
        return Enclosure(low, high)

    def magnitude(self):
        return max(abs(self.low), abs(self.high))


def enclosed(x):
    if isinstance(x, Irrational):
        return x.enclosure()
    x = Fraction(x)
    scaled = x.numerator << BITS
    return Enclosure(scaled // x.denominator, -(-scaled // x.denominator))


def around(middle, radius):
    return Enclosure(middle - radius, middle + radius)


def total(values):
    result = Enclosure(0, 0)
    for value in values:
        result = result + value
    return result


# Cosines --------------------------------------------------------------------------------------------------------------------------

def arc_tangent(k):
    """atan(1/k) by its series, in units of 2^-(BITS + 20): the value and a bound of its error."""
    scale = 1 << (BITS + 20)
    power, result, n = scale // k, 0, 0
    while power:
        result += (-1) ** n * (power // (2 * n + 1))
        power //= k * k
        n += 1
    return result, 3 * n + 3  # every power and every quotient is rounded down once, and a tail below the last power


@lru_cache(maxsize=None)
def pi():
    (a, ea), (b, eb) = arc_tangent(5), arc_tangent(239)  # Machin
    middle, radius = 16 * a - 4 * b, 16 * ea + 4 * eb
    return Enclosure((middle - radius) >> 20, -(-(middle + radius) >> 20))


def cosine_series(x):
    """cos(x 2^-BITS) for 0 <= x 2^-BITS <= 2: the partial sum and a bound of its error."""
    square, term, result, k = x * x >> BITS, ONE, 0, 0
    while term:
        result += -term if k % 2 else term
        k += 1
        term = (term * square >> BITS) // ((2 * k - 1) * 2 * k)
    return result, 4 * k + 4  # the terms fall from the second on, and each is off by less than 4 units


@lru_cache(maxsize=None)
def cosine(q):
    """cos(q pi) for a fraction q."""
    q = abs(q) % 2
    q = min(q, 2 - q)
    if q > Fraction(1, 2):
        return -cosine(1 - q)
    x = enclosed(q) * pi()
    (least, below), (most, above) = cosine_series(x.high), cosine_series(max(x.low, 0))
    return Enclosure(least - below, min(most + above, ONE))


def unit(q):
    """e^(i pi q) as real and imaginary part."""
    return cosine(q), cosine(q - Fraction(1, 2))


# Fields Q(2 cos(2 pi/N)) ----------------------------------------------------------------------------------------------------------

@lru_cache(maxsize=None)
def cyclotomic(n):
    p = [Fraction(-1)] + [Fraction(0)] * (n - 1) + [Fraction(1)]
    for d in range(1, n):
        if n % d == 0:
            p = divided(p, cyclotomic(d))[0]
    return p


@lru_cache(maxsize=None)
def minimal_polynomial(order):
    """Of 2 cos(2 pi/order): the cyclotomic polynomial is z^k times it at z + 1/z."""
    p = cyclotomic(order)
    half = len(p) // 2
    result, before, now = [p[half]] + [Fraction(0)] * half, [Fraction(2)], [Fraction(0), Fraction(1)]
    for k in range(1, half + 1):  # now: z^k + z^-k in powers of z + 1/z
        for j, c in enumerate(now):
            result[j] += p[half - k] * c
        following = [Fraction(0)] + now
        for j, c in enumerate(before):
            following[j] -= c
        before, now = now, following
    return result


def in_field(order, p):
    """The polynomial p in 2 cos(2 pi/order), reduced; a plain fraction where it is one."""
    modulus = minimal_polynomial(order)
    p = trimmed(divided(p, modulus)[1])
    if len(p) < 2:
        return p[0] if p else Fraction(0)
    return Irrational(order, p + [Fraction(0)] * (len(modulus) - 1 - len(p)))


class Irrational:
    """A number of the field that is no fraction, by its coefficients in powers of 2 cos(2 pi/order), lowest first."""

    def __init__(self, order, coefficients):
        self.order, self.coefficients = order, coefficients

    def like(self, other):
        if not isinstance(other, Irrational):
            return [Fraction(other)]
        if other.order != self.order:
            raise CannotCheck("irrational numbers of different fields together")
        return other.coefficients

    def __add__(self, other):
        a, b = self.coefficients, self.like(other)
        return in_field(self.order, [x + (b[k] if k < len(b) else 0) for k, x in enumerate(a)])

    def __mul__(self, other):
        b = self.like(other)
        result = [Fraction(0)] * (len(self.coefficients) + len(b) - 1)
        for i, x in enumerate(self.coefficients):
            for j, y in enumerate(b):
                result[i + j] += x * y
        return in_field(self.order, result)

    def inverse(self):
        """Euclid: `one` is `factor` times this number, up to multiples of the minimal polynomial."""
        rest, one = minimal_polynomial(self.order), trimmed(self.coefficients)
        before, factor = Fraction(0), Fraction(1)
        while len(one) > 1:
            quotient, following = divided(rest, one)
            rest, one, before, factor = one, following, factor, before - in_field(self.order, quotient) * factor
        return factor / one[0]

    def __neg__(self):
        return self * -1

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __truediv__(self, other):
        return self * (other.inverse() if isinstance(other, Irrational) else 1 / Fraction(other))

    def __rtruediv__(self, other):
        return self.inverse() * other

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other):
        return isinstance(other, Irrational) and (self.order, self.coefficients) == (other.order, other.coefficients)

    __hash__ = None

    def sign(self):
        value = self.enclosure()
        if value.low <= 0 <= value.high:
            raise CannotCheck("an irrational number is too close to zero for the precision here")
        return 1 if value.low > 0 else -1

    def __lt__(self, other):
        difference = other - self
        return (difference.sign() if isinstance(difference, Irrational) else difference) > 0

    def __gt__(self, other):
        difference = self - other
        return (difference.sign() if isinstance(difference, Irrational) else difference) > 0

    def __abs__(self):
        return self if self.sign() > 0 else -self

    def enclosure(self):
        generator = Enclosure(2 * cosine(Fraction(2, self.order)).low, 2 * cosine(Fraction(2, self.order)).high)
        result = Enclosure(0, 0)
        for c in reversed(self.coefficients):
            result = result * generator + enclosed(c)
        return result

    def quadratic(self):
        """(a, b, d) with the value a + b sqrt(d), or None."""
        square = (self * self).coefficients if isinstance(self * self, Irrational) else [self * self]
        square = square + [Fraction(0)] * (len(self.coefficients) - len(square))
        at = next(k for k, c in enumerate(self.coefficients) if k > 0 and c != 0)
        s = square[at] / self.coefficients[at]
        if any(x != s * y for x, y in zip(square[1:], self.coefficients[1:])):
            return None
        a = s / 2
        under = square[0] - s * self.coefficients[0] + a * a  # (x - a)^2
        for d in range(2, self.order + 1):
            part = under / d
            b = Fraction(math.isqrt(part.numerator), math.isqrt(part.denominator))
            if self.order % d == 0 and b * b == part:
                return a, b if self > a else -b, d
        return None

    def __str__(self):
        text = ""

        def say(weight, name, behind):
            nonlocal text
            if weight == 0:
                return
            text += ("-" if weight < 0 else "") if not text else (" - " if weight < 0 else " + ")
            size = abs(weight)
            if not name:
                text += str(size)
                return
            front = size.numerator if behind else size
            text += ("" if front == 1 else f"{front}*") + name + (f"/{size.denominator}" if behind and size.denominator > 1 else "")
        roots = self.quadratic()
        if roots:
            say(roots[0], "", True)
            say(roots[1], f"sqrt({roots[2]})", True)
            return text
        for k, c in enumerate(self.coefficients):
            name = f"cos(2*pi/{self.order})" + (f"^{k}" if k > 1 else "")
            say(c * 2 ** k, name if k else "", False)
        return text


def number(value, where):
    """A fraction, or an irrational number of a field that is not too large."""
    if not isinstance(value, dict):
        return fraction(value, where)
    require("formula" not in value and "names" not in value, f"{where} must be a number: functions are no constant parameters")
    entries(value, ["order", "coefficients"], where)
    order = integer(value["order"], 5, 4000, where)
    if order > 400:
        raise CannotCheck("irrational numbers of such a high order are not known here")
    require(order % 2 == 1 or order % 4 == 0, f"{where}: the field has a smaller order")
    require(isinstance(value["coefficients"], list), f"{where} must have a list of coefficients")
    coefficients = [fraction(c, where) for c in value["coefficients"]]
    require(len(coefficients) == len(minimal_polynomial(order)) - 1 and any(coefficients[1:]), f"{where} is not in reduced form")
    return Irrational(order, coefficients)


# Matrices -------------------------------------------------------------------------------------------------------------------------

def row_norm(matrix):
    return max(sum(x.magnitude() for x in row) for row in matrix)


def scaled_powers(matrix, t):
    """(matrix/t)^(2^p) for p = 0, 1, .., 14 as middles with one bound of the row-sum norm of the error; t in units of 2^-BITS."""
    size = len(matrix)
    middles = [[((x.low + x.high) << BITS) // (2 * t) for x in row] for row in matrix]
    error = max(sum(((x.high - x.low) << BITS) // (2 * t) + 2 for x in row) for row in matrix)
    for _ in range(15):
        norm = max(sum(map(abs, row)) for row in middles)
        yield middles, norm, error
        if norm.bit_length() > 4 * BITS:
            return
        columns = list(zip(*middles))
        middles = [[sum(x * y for x, y in zip(row, column)) >> BITS for column in columns] for row in middles]
        error = ((2 * norm * error + error * error) >> BITS) + 1 + size


def is_radius_below(matrix, t):
    """Whether powers show that all eigenvalues have a modulus below t 2^-BITS."""
    return not matrix or any(norm + error < ONE for _, norm, error in scaled_powers(matrix, t))


def is_radius_above(matrix, t):
    """Whether the trace of a power, the sum of as many eigenvalues as there are rows, shows one of modulus t 2^-BITS or more."""
    return any(abs(sum(row[k] for k, row in enumerate(middles))) - error * len(matrix) >= ONE * len(matrix)
               for middles, _, error in scaled_powers(matrix, t))


def rough_inverse(matrix):
    """Floating point; what it is used for is proved afterwards."""
    n = len(matrix)
    rows = [[(x.low + x.high) / (2 * ONE) for x in row] + [float(i == k) for k in range(n)] for i, row in enumerate(matrix)]
    for k in range(n):
        found = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[found] = rows[found], rows[k]
        require(rows[k][k] != 0, "the Jacobian of the eigenpair is singular")
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    require(all(math.isfinite(x) for row in rows for x in row), "the Jacobian of the eigenpair is nearly singular")
    return [[enclosed(Fraction(x)) for x in row[n:]] for row in rows]


def enclose_eigenpair(matrix, value, vector):
    """The one eigenpair (first component 1) near fractions: Newton and Kantorovich for F(v, l) = (matrix v - l v, v_0 - 1).

    Where r bounds the distance, the defect of one Newton step R F is at most |1 - R F'| r + |R| r^2, and below r it maps into itself.
    """
    n = len(matrix)
    require(len(vector) == n, "the eigenvector has another length")
    at, v = enclosed(value), [enclosed(x) for x in vector]
    residual = [total(a * x for a, x in zip(row, v)) - at * v[i] for i, row in enumerate(matrix)] + [v[0] - enclosed(1)]
    slope = [[a - at if i == j else a for j, a in enumerate(row)] + [-v[i]] for i, row in enumerate(matrix)]
    slope.append([enclosed(int(j == 0)) for j in range(n + 1)])
    inverse = rough_inverse(slope)
    step = [total(a * x for a, x in zip(row, residual)) for row in inverse]
    columns = list(zip(*slope))
    defect = [[enclosed(int(i == j)) - total(a * x for a, x in zip(row, column)) for j, column in enumerate(columns)]
              for i, row in enumerate(inverse)]
    alpha, beta, norm = max(x.magnitude() for x in step), row_norm(defect), row_norm(inverse)
    require(beta < ONE, "the eigenpair is not near one of frequency 1")
    r = (2 * alpha << BITS) // (ONE - beta) + 1
    change = ((beta * r >> BITS) + 1) + ((norm * r * r >> 2 * BITS) + 1)
    require(alpha + change <= r and beta * ONE + 2 * norm * r < ONE * ONE, "the eigenpair is not near one of frequency 1")
    exact = [x - d + around(0, change) for x, d in zip(v + [at], step)]
    return exact[-1], exact[:-1]
