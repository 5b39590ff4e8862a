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


class Table:
    """A mask, or a power of one, over scale: integers (or irrational numbers, over 1) in rows[j][i] at (x + 2i, y + 2j)."""

    def __init__(self, mask):
        self.x, self.y = min(x for x, _ in mask), min(y for _, y in mask)
        self.scale = math.lcm(*(weight.denominator for weight in mask.values())) if is_rational(mask) else 1
        width, height = ((max(place[k] for place in mask) - (self.x, self.y)[k]) // 2 + 1 for k in (0, 1))
        self.rows = [[0] * width for _ in range(height)]
        for (x, y), weight in mask.items():
            value = weight * self.scale
            self.rows[(y - self.y) // 2][(x - self.x) // 2] = int(value) if is_rational(mask) else value

    def after(self, power):
        """The table of one round more than `power`."""
        result = Table.__new__(Table)
        result.x, result.y, result.scale = self.x + 2 * power.x, self.y + 2 * power.y, self.scale * power.scale
        width, n = len(self.rows[0]) + 2 * (len(power.rows[0]) - 1), 2 * len(power.rows[0]) - 1
        result.rows = [[0] * width for _ in range(len(self.rows) + 2 * (len(power.rows) - 1))]
        for j, old in enumerate(power.rows):
            for v, weights in enumerate(self.rows):
                row = result.rows[2 * j + v]
                for u, weight in enumerate(weights):
                    if weight != 0:
                        row[u:u + n:2] = [x + weight * p for x, p in zip(row[u:u + n:2], old)]
        return result

    def size(self):
        return len(self.rows) * len(self.rows[0])


def powers(mask, most, limit):
    """The tables of 1, 2, .. rounds, as long as their work stays below the limit."""
    table = Table(mask)
    power = table
    for rounds in range(1, most + 1):
        yield rounds, power
        if power.size() * table.size() > limit:
            return
        power = table.after(power)


def contraction(mask, rounds):
    """The sup norm of so many rounds: the largest sum of moduli over the residues modulo 2^rounds."""
    for done, power in powers(mask, rounds, 3e7 if is_rational(mask) else 2e5):
        if done == rounds:
            period = 2 ** rounds
            columns = [[sum(map(abs, row[i::period])) for i in range(period)] for row in power.rows]
            norm = max(sum(column) for j in range(period) for column in zip(*columns[j::period]))
            return norm * Fraction(1, power.scale)
    raise CannotCheck("so many rounds of the regular part are not checked here")


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
