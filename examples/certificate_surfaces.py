"""Certificates about surfaces at one valence: the eigenvalues of the subdivision matrix, regular parts, and the theorem on C^1 of
Reif, Peters and Zorin.

Everything is derived from the word again: rows of one round, blocks by frequencies, masks and their difference schemes, the ring.
"""
from fractions import Fraction

from certificate_algebra import CannotCheck, characteristic, divided, entries, fraction, integer, require, trimmed
from certificate_enclosures import (ONE, Enclosure, cosine, cyclotomic, enclose_eigenpair, enclosed, is_radius_above,
                                    is_radius_below, number, total, unit)
from certificate_lattices import CENTRE, Lattice, Round, check_word, describe
from certificate_masks import Regular, is_rational, regular_mask
from certificate_rings import Net, Ring, check_bernstein, check_hulls


# Rows and blocks ------------------------------------------------------------------------------------------------------------------

class Local:
    """Rows around the point, and the radius (half steps) of the smallest neighbourhood that later points do not add eigenvalues to."""

    def __init__(self, word, valence):
        self.lattice = Lattice(valence, word["triangles"], check_word(word, valence))
        one_round = Round(word, self.lattice)
        self.row, self.reach = one_round.row, one_round.reach
        self.check_rows(self.reach)
        # A row at radius q uses radii up to (q + reach)/2 only: less than q from reach + 1 on.
        used = {q: max(self.lattice.radius(old) for place in self.places(q) if self.lattice.radius(place) == q
                       for old in self.row(place)) for q in self.radii(self.reach)}
        inner = used.pop(0, 0)
        self.radius = next(r for r in self.radii(self.reach + 2) if r > 0 and inner <= r and
                           all(u <= r if q <= r else u < q for q, u in used.items()))
        self.units = [unit(Fraction(q, valence)) for q in range(2 * valence)]

    def places(self, radius):
        return ([] if self.lattice.dual else [CENTRE]) + self.lattice.orbits(radius)

    def radii(self, most):
        return range(1, most + 1, 2) if self.lattice.dual else range(0, most + 1, 2)

    def check_rows(self, radius):
        """Sums 1, and the mirror image of each row is the row of the mirror image."""
        for place in self.places(radius):
            row, image = self.row(place), self.lattice.mirrored(place) if place != CENTRE else CENTRE
            require(sum(row.values(), Fraction(0)) == 1, "the rows around the point do not sum to 1")
            mirrored = {self.lattice.mirrored(old) if old != CENTRE else CENTRE: weight for old, weight in row.items()}
            require(mirrored == self.row(image), "the rows around the point are not mirror symmetric")

    def coordinates(self):
        """A net of frequency m that equals its mirror image is e^(2 pi i m s/n) at sector s times: x on the spoke,
        x e^(i pi m/n) on the diagonal, x + iy and e^(2 pi i m/n) (x - iy) at pairs (a, b) and (b, a), a > b."""
        result = []
        for _, a, b in self.lattice.orbits(self.radius):
            if a >= b:
                result += [(a, b, False)] + ([(a, b, True)] if 0 < b < a else [])
        return result

    def turn(self, place, frequency):
        s, a, b = place
        return frequency * (2 * s + (1 if a == b else 2 if a < b else 0)) % (2 * self.lattice.valence)

    def value(self, place, frequency, coordinates, values):
        """Of the net with these coordinates, at a place within the radius."""
        s, a, b = place
        if place == CENTRE:
            return Enclosure(0, 0), Enclosure(0, 0)
        k = coordinates.index((max(a, b), min(a, b), False))
        x, y = values[k], values[k + 1] if 0 < b != a else Enclosure(0, 0)
        re, im = self.units[self.turn(place, frequency)]
        y = -y if a < b else y
        return re * x - im * y, re * y + im * x

    def functional(self, row, turn, imaginary, frequency, coordinates):
        """The real or imaginary part of e^(-i pi turn/n) times the new value."""
        exact = {}
        for old, weight in row.items():
            if old != CENTRE:
                key = (max(old[1:]), min(old[1:])), (self.turn(old, frequency) - turn) % (2 * self.lattice.valence), old[1] < old[2]
                exact[key] = exact.get(key, 0) + weight
        result = {name: Enclosure(0, 0) for name in coordinates}
        for ((a, b), angle, swapped), weight in exact.items():
            w, (re, im) = enclosed(weight), self.units[angle]
            result[a, b, False] += w * (im if imaginary else re)
            if 0 < b < a:
                of_y = w * (re if imaginary else -im)
                result[a, b, True] += -of_y if swapped else of_y
        return list(result.values())

    def block(self, frequency):
        """The block of the subdivision matrix; for frequency 0 on nets modulo constants, which vanish at the centre or, where there
        is none, in the first coordinate."""
        names = self.coordinates()
        result = [self.functional(self.row((0, a, b)), frequency if a == b else 0, imaginary, frequency, names)
                  for a, b, imaginary in names]
        if frequency > 0:
            return result
        base = result[0] if self.lattice.dual else self.functional(self.row(CENTRE), 0, False, 0, names)
        result = [row if imaginary else [x - y for x, y in zip(row, base)] for row, (_, _, imaginary) in zip(result, names)]
        return [row[1:] for row in result[1:]] if self.lattice.dual else result


# Eigenvalues ----------------------------------------------------------------------------------------------------------------------

STEP = Fraction(1, 2 ** 40)  # of the approximations in certificates


def check_eigenpair(local, data):
    """The enclosed pair of frequency 1, above all other eigenvalues but the 1 of the constants."""
    entries(data, ["lambda", "vector"], "the eigenpair")
    require(isinstance(data["vector"], list), "the eigenvector must be a list")
    near = [fraction(x, "the eigenpair") for x in [data["lambda"], *data["vector"]]]
    first = local.block(1)
    value, vector = enclose_eigenpair(first, near[0], near[1:])
    for x, exact in zip(near, [value, *vector]):
        difference = exact - enclosed(x)
        require((x / STEP).denominator == 1 and difference.magnitude() <= STEP * ONE * Fraction(501, 1000),
                "the eigenpair is not the one of frequency 1 in its precision")
    require(0 < value.low and value.high < ONE, "the subdominant eigenvalue is not between 0 and 1")
    deflated = [[row[0] - value * v] + row[1:] for row, v in zip(first, vector)]  # Wielandt: this one becomes 0
    others = [deflated] + [local.block(m) for m in range(local.lattice.valence // 2 + 1) if m != 1]
    require(all(is_radius_below(block, value.low) for block in others), "other eigenvalues are not bounded below the subdominant one")
    return value, vector


def check_frequency(local, frequency):
    """Some eigenvalue of this frequency has a modulus above all of frequency 1. The place between them is found by halving."""
    first, other = local.block(1), local.block(frequency)
    low, high = 0, 64 * ONE
    require(is_radius_below(first, high), "the eigenvalues of frequency 1 are too large")
    while high - low > ONE >> 48:
        middle = (low + high) // 2
        low, high = (low, middle) if is_radius_below(first, middle) else (middle, high)
    require(is_radius_above(other, high), "no eigenvalue of the frequency is bounded above those of frequency 1")


class Cyclotomic:
    """A number of Q(z), z = e^(2 pi i/n), as a polynomial in z."""

    def __init__(self, n, coefficients):
        self.n, self.p = n, divided(trimmed(coefficients), cyclotomic(n))[1]

    def other(self, x):
        return x.p if isinstance(x, Cyclotomic) else trimmed([Fraction(x)])

    def __add__(self, x):
        a, b = sorted([self.p, self.other(x)], key=len)
        return Cyclotomic(self.n, [y + (a[k] if k < len(a) else 0) for k, y in enumerate(b)])

    def __mul__(self, x):
        b = self.other(x)
        result = [Fraction(0)] * (len(self.p) + len(b))
        for i, s in enumerate(self.p):
            for j, t in enumerate(b):
                result[i + j] += s * t
        return Cyclotomic(self.n, result)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1

    def __truediv__(self, x):
        return self * (1 / Fraction(x))

    def __eq__(self, x):
        return self.p == self.other(x)

    __hash__ = None

    def real_part(self):
        return total(enclosed(c) * cosine(Fraction(2 * k, self.n)) for k, c in enumerate(self.p))


def check_multiple(local, root):
    """The root is an eigenvalue of frequency 1 at least twice, and all others of this frequency are smaller."""
    n, orbits = local.lattice.valence, local.lattice.orbits(local.radius)
    size = len(orbits)
    if size ** 4 * n ** 2 > 3e6:
        raise CannotCheck("exact characteristic polynomials of this size are not checked here")
    block = [[Cyclotomic(n, []) for _ in orbits] for _ in orbits]
    for i, place in enumerate(orbits):
        row = local.row(place)
        if not is_rational(row):
            raise CannotCheck("multiple eigenvalues of irrational matrices are not checked here")
        for old, weight in row.items():
            if old != CENTRE:
                block[i][orbits.index((0, *old[1:]))] += Cyclotomic(n, [Fraction(0)] * old[0] + [weight])
    p, multiplicity = characteristic(block), -1  # highest coefficient first
    rest = Fraction(0)
    while rest == 0:
        multiplicity += 1
        p, quotient, rest = (p if multiplicity == 0 else quotient), [], Fraction(0)
        for c in p:
            quotient.append(rest * root + c)
            rest = quotient[-1]
        quotient.pop()
    require(root > 0 and multiplicity >= 2, "the number is no multiple eigenvalue of frequency 1")
    degree = len(p) - 1
    companion = [[enclosed(int(i == j + 1)) for j in range(degree)] for i in range(degree)]
    for i in range(degree):
        companion[i][-1] = companion[i][-1] - (p[degree - i] * Cyclotomic(n, [Fraction(1)])).real_part()
    require(is_radius_below(companion, enclosed(root).low), "the number is not the largest of frequency 1")


# One function per kind of certificate: from the data to the statement that they prove ------------------------------------------

def subject(data):
    return Local(data["word"], integer(data["valence"], 3, 200, "the valence"))


def place_of(local):
    n = local.lattice.valence
    return f"at interior faces of {n} corners" if local.lattice.dual else f"at interior vertices of valence {n}"


def surface_spectrum(data):
    kind = "multiple" if isinstance(data, dict) and "multiple" in data else "frequency"
    entries(data, ["word", "valence", kind], "the data")
    local = subject(data)
    of, n = f"of the subdivision matrix of {describe(data['word'])} {place_of(local)}", local.lattice.valence
    if kind == "multiple":
        root = fraction(data["multiple"], "the eigenvalue")
        check_multiple(local, root)
        return (f"the largest modulus of the eigenvalues of frequency 1 {of} is {root}, a multiple eigenvalue: "
                "the theorem on C^1 does not apply")
    frequency = integer(data["frequency"], 0, n // 2, "the frequency")
    require(frequency != 1, "the frequency must not be 1")
    check_frequency(local, frequency)
    return (f"{of[3:]} has an eigenvalue of frequency {frequency}, other than the 1 of the constants, above all eigenvalues of the "
            f"frequencies 1 and {n - 1}: the limit surfaces are not C^1 there in general")


def surface_c1(data):
    entries(data, ["word", "valence", "regular", "eigenpair", "ring"], "the data")
    local = subject(data)
    entries(data["regular"], ["rounds", "norm"], "the regular part")
    regular = Regular(regular_mask(data["word"], local.lattice.dual), local.lattice.triangles)
    norm = regular.norm(integer(data["regular"]["rounds"], 1, 7, "the rounds of the regular part"))
    require(norm == number(data["regular"]["norm"], "the norm") and norm < 1, "the regular part does not contract like this")
    value, vector = check_eigenpair(local, data["eigenpair"])
    ring = Ring(local, regular)
    net = Net(local, ring, value, vector)
    if isinstance(data["ring"], dict) and data["ring"].get("method") == "hull":
        entries(data["ring"], ["method", "cells"], "the ring")
        check_hulls(ring, net, data["ring"]["cells"])
    else:
        entries(data["ring"], ["method"], "the ring")
        require(data["ring"]["method"] == "bernstein", "an unknown method for the ring")
        check_bernstein(ring, net)
    return f"the limit surfaces of {describe(data['word'])} are C^1 {place_of(local)} for almost all control nets"


CHECKERS = {"surface-c1": surface_c1, "surface-spectrum": surface_spectrum}
