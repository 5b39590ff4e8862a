"""Regular parts of surfaces: the mask {(x, y): weight} of a word on the plane, new point at y = sum of mask[y - 2k] old point at k in
half steps, its difference schemes and powers."""
import math
from fractions import Fraction

from certificate_algebra import CannotCheck, require
from certificate_enclosures import Irrational
from certificate_lattices import Lattice, Round


def regular_mask(word, dual):
    row, odd, result = Round(word, Lattice(None, word["triangles"], dual)).row, int(dual), {}
    for x, y in ((odd, odd), (odd + 2, odd), (odd, odd + 2), (odd + 2, odd + 2)):
        weights = row((0, x, y))
        require(sum(weights.values(), Fraction(0)) == 1, "the rows of the regular part do not sum to 1")
        result.update({(x - 2 * i, y - 2 * j): weight for (_, i, j), weight in weights.items()})
    return result


def is_rational(mask):
    return not any(isinstance(weight, Irrational) for weight in mask.values())


def difference(mask, direction):
    """mask/(1 + z^direction), of differences at midpoints; None if it does not divide."""
    dx, dy = direction
    lines, result = {}, {}
    for x, y in mask:
        lines.setdefault(x * dy - y * dx, []).append((x * dx + y * dy, x, y))
    for line in lines.values():
        (first, x, y), (last, _, _) = min(line), max(line)
        value = Fraction(0)
        for k in range((last - first) // (2 * (dx * dx + dy * dy)) + 1):
            at = x + 2 * k * dx, y + 2 * k * dy
            value = mask.get(at, Fraction(0)) - value
            if value != 0:
                result[at[0] + dx, at[1] + dy] = value
        if value != 0:
            return None
    return result


def denominator(mask):
    return math.lcm(*(weight.denominator for weight in mask.values()))


class Power:
    """The mask of some rounds, over scale: integers rows[j][i] at (x + 2i, y + 2j); new points at y - 2^rounds k."""

    def __init__(self, x, y, scale, rows):
        self.x, self.y, self.scale, self.rows = x, y, scale, rows


def powers(mask, most):
    """The masks of 1, 2, .. rounds of a rational mask: A(z) A(z^2) A(z^4) .. with every row of coefficients packed in one integer,
    so that a row times a weight is one product."""
    x0, y0, scale = min(x for x, _ in mask), min(y for _, y in mask), denominator(mask)
    weights = [((x - x0) // 2, (y - y0) // 2, int(weight * scale)) for (x, y), weight in mask.items()]
    wide, high = max(i for i, _, _ in weights), max(j for _, j, _ in weights)
    size = sum(abs(weight) for _, _, weight in weights).bit_length() * most // 8 + 1  # bytes of a coefficient with its sign
    packed, width = [1], 1
    for rounds in range(1, most + 1):
        step = 2 ** (rounds - 1)
        following = [0] * (len(packed) + high * step)
        for j, row in enumerate(packed):
            for i, v, weight in weights:
                following[j + v * step] += weight * row << 8 * size * i * step
        packed, width = following, width + wide * step
        yield rounds, Power(x0 * (2 * step - 1), y0 * (2 * step - 1), scale ** rounds, unpacked(packed, width, size))


def unpacked(packed, width, size):
    half = 1 << 8 * size - 1
    bias = ((1 << 8 * size * width) - 1) // ((1 << 8 * size) - 1) * half
    rows = [(row + bias).to_bytes(size * width, "little") for row in packed]
    return [[int.from_bytes(row[k:k + size], "little") - half for k in range(0, len(row), size)] for row in rows]


def contraction(mask, rounds):
    """The sup norm of so many rounds: the largest sum of moduli over the residues modulo 2^rounds."""
    if not is_rational(mask):
        return contraction_by_terms(mask, rounds)
    if 4 ** rounds * max(x for x, _ in mask) * max(y for _, y in mask) > 1e6:
        raise CannotCheck("so many rounds of the regular part are not checked here")
    power, period = list(powers(mask, rounds))[-1][1], 2 ** rounds
    columns = [[sum(map(abs, row[i::period])) for i in range(period)] for row in power.rows]
    return Fraction(max(sum(column) for j in range(period) for column in zip(*columns[j::period])), power.scale)


def contraction_by_terms(mask, rounds):
    if rounds > 3:
        raise CannotCheck("so many rounds of an irrational regular part are not checked here")
    power, sums = {(0, 0): Fraction(1)}, {}
    for _ in range(rounds):
        following = {}
        for (x, y), value in power.items():
            for (ox, oy), weight in mask.items():
                at = ox + 2 * x, oy + 2 * y
                following[at] = following.get(at, 0) + weight * value
        power = following
    for (x, y), value in power.items():
        residue = x % 2 ** (rounds + 1), y % 2 ** (rounds + 1)
        sums[residue] = sums.get(residue, 0) + abs(value)
    return max(sums.values())


class Regular:
    def __init__(self, mask, triangles):
        self.mask, self.derivatives, self.differences = mask, [], []
        directions = [(1, 0), (0, 1)] + ([(-1, 1)] if triangles else [])
        for axis in directions[:2]:
            derivative = difference(mask, axis)
            require(derivative is not None, "the regular part is not factorable")
            self.derivatives.append({place: 2 * weight for place, weight in derivative.items()})
            found = [difference(self.derivatives[-1], direction) for direction in directions]
            self.differences.append([mask for mask in found if mask is not None])
            require(len(self.differences[-1]) >= 2, "the regular part is not factorable twice")

    def norm(self, rounds):
        """The least bound such that the differences of each derivative along two directions contract by it in these rounds."""
        return max(sorted(contraction(mask, rounds) for mask in differences)[1] for differences in self.differences)
