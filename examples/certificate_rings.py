"""The characteristic map on the ring of cells around an extraordinary point: regular and injective there.

The image of a sector's ring lies in a half plane around its bisector and the Jacobian is positive: so the map winds round once.
"""
import math
from fractions import Fraction

from certificate_algebra import CannotCheck, require
from certificate_enclosures import ONE, Enclosure, enclosed, total
from certificate_lattices import CENTRE
from certificate_masks import denominator, is_rational, powers

CHILDREN = ((0, 0), (2, 0), (0, 2), (2, 2))
DEEPEST = 10
SCALE = 80  # bits of the fixed numbers in hulls


def closed_set(mask, start):
    """The points that the limit over a cell depends on: with every point those that carry weight to it in a child cell."""
    known, unseen = set(start), list(start)
    parity = start[0][0] % 2, start[0][1] % 2
    while unseen:
        x, y = unseen.pop()
        for ex, ey in CHILDREN:
            for ox, oy in mask:
                k = (x + ex - ox) // 2, (y + ey - oy) // 2
                if (2 * k[0] + ox, 2 * k[1] + oy) == (x + ex, y + ey) and (k[0] % 2, k[1] % 2) == parity and k not in known:
                    known.add(k)
                    unseen.append(k)
    return sorted(known)


class Ring:
    def __init__(self, local, regular):
        self.local, self.regular, self.lattice = local, regular, local.lattice
        if self.lattice.dual:
            starts = [(1, 1)], [(0, 1), (2, 1)], [(1, 0), (1, 2)]
        else:
            starts = [(0, 0), (2, 0), (0, 2), (2, 2)], [(1, 0), (1, 2)], [(0, 1), (2, 1)]
        self.sets = [closed_set(mask, start) for mask, start in zip([regular.mask] + regular.derivatives, starts)]
        points = set(self.sets[0])
        for (dx, dy), differences in zip(((1, 0), (0, 1)), self.sets[1:]):
            points |= {(x + sign * dx, y + sign * dy) for x, y in differences for sign in (-1, 1)}
        self.points = sorted(points)
        self.extent = max(max(abs(x), abs(y), abs(x + y) if self.lattice.triangles else 0) for x, y in points)
        self.first = self.first_ring()
        self.cells = self.cells_between(self.first, 2 * self.first)
        self.check_rows()

    @staticmethod
    def cells_between(low, high):
        return [(2 * i, 2 * j) for i in range(high) for j in range(high) if max(i, j) >= low]

    def first_ring(self):
        """No cell from this ring on depends on points beyond both spokes of the sector. Farther out than the extent none can."""
        irregular = [max(cell) // 2 for cell in self.cells_between(1, self.extent + 2)
                     if any(cell[0] + x < 0 for x, _ in self.points) and any(cell[1] + y < 0 for _, y in self.points)]
        first = max(irregular, default=0) + 1
        require(first <= 6, "the mask is too wide for a ring of regular cells")
        return first

    def check_rows(self):
        """All rounds on the ring use the regular mask: the first is looked at, the second and later ones do not see the centre."""
        lattice, odd = self.lattice, int(self.lattice.dual)
        fine = {(2 * i + ex + x, 2 * j + ey + y) for i, j in self.cells for x, y in self.sets[0] for ex, ey in CHILDREN}
        for x, y in fine:
            expected = {}
            for (ox, oy), weight in self.regular.mask.items():
                if (x - ox) % 4 == (y - oy) % 4 == 2 * odd:
                    old = lattice.fold(0, (x - ox) // 2, (y - oy) // 2)
                    expected[old] = expected.get(old, 0) + weight
            place = lattice.fold(0, x, y)
            actual = self.local.row((0, *place[1:]))
            require({lattice.rotated(old, place[0]): weight for old, weight in actual.items()} == expected,
                    "rows near the extraordinary point differ from the regular ones on the ring")
        second = min(lattice.radius(lattice.fold(0, 4 * i + ex + x, 4 * j + ey + y)) for i, j in self.cells
                     for x, y in self.sets[0] for ex in range(0, 8, 2) for ey in range(0, 8, 2))
        require(second > self.local.reach and 16 * self.first - self.extent > self.local.reach,
                "later rounds on the ring see the extraordinary point")


class Net:
    """The net of the eigenvector: v(place) = row(place) v/lambda, as pairs of enclosures."""

    def __init__(self, local, ring, value, vector):
        self.local, names, self.values = local, local.coordinates(), {}
        lattice = local.lattice
        extent = max(lattice.radius(lattice.fold(0, i + x, j + y)) for i, j in ring.cells for x, y in ring.points)
        for place in sorted(lattice.orbits(extent), key=lattice.radius):  # beyond the invariant radius rows look inwards
            if lattice.radius(place) <= local.radius:
                self.values[place[1:]] = local.value(place, 1, names, vector)
                continue
            terms = [(enclosed(weight), self.at(old)) for old, weight in local.row(place).items()]
            self.values[place[1:]] = tuple(total(weight * x[part] for weight, x in terms).over(value) for part in (0, 1))

    def at(self, place):
        if place == CENTRE:
            return Enclosure(0, 0), Enclosure(0, 0)
        (re, im), (x, y) = self.local.units[2 * place[0]], self.values[place[1:]]
        return re * x - im * y, re * y + im * x

    def seen(self, x, y):
        """At a place of the frame of sector 0."""
        return self.at(self.local.lattice.fold(0, x, y))


# Bernstein: all coefficients of the Jacobian of bicubic patches are positive -------------------------------------------------------

BEZIER = ((1, 4, 1, 0), (0, 4, 2, 0), (0, 2, 4, 0), (0, 1, 4, 1))  # over 6, from uniform B-splines


def check_bernstein(ring, net):
    cubic = dict(zip((-4, -2, 0, 2, 4), (1, 4, 6, 4, 1)))
    mask = {(x, y): Fraction(cubic[x] * cubic[y], 64) for x in cubic for y in cubic}
    require(not net.local.lattice.triangles and ring.regular.mask == mask, "the regular part is not bicubic")
    re, im = net.local.units[1]
    for i, j in ring.cells:
        control = [[net.seen(i + 2 * (k - 1), j + 2 * (m - 1)) for m in range(4)] for k in range(4)]
        patch = [[tuple(total(enclosed(Fraction(a * b, 36)) * control[k][m][part] for k, a in enumerate(p)
                              for m, b in enumerate(q) if a * b) for part in (0, 1)) for q in BEZIER] for p in BEZIER]
        require(all((re * x + im * y).low > 0 for row in patch for x, y in row), "the image of a sector is not in its half plane")

        def step(a, b):
            return patch[b[0]][b[1]][0] - patch[a[0]][a[1]][0], patch[b[0]][b[1]][1] - patch[a[0]][a[1]][1]
        sums = {}
        for a in range(3):
            for b in range(4):
                u = step((a, b), (a + 1, b))
                for c in range(4):
                    for d in range(3):
                        v = step((c, d), (c, d + 1))
                        share = Fraction(math.comb(2, a) * math.comb(3, c) * math.comb(3, b) * math.comb(2, d),
                                         math.comb(5, a + c) * math.comb(5, b + d))
                        sums.setdefault((a + c, b + d), []).append(enclosed(share) * (u[0] * v[1] - u[1] * v[0]))
        require(len(sums) == 36 and all(total(terms).low > 0 for terms in sums.values()),
                "the Jacobian of the characteristic map has no positive bound")


# Hulls: boxes for limits from the data that they depend on -------------------------------------------------------------------------

def runs(points):
    """The points as horizontal runs (x, y, length)."""
    result = []
    for y, x in sorted((y, x) for x, y in points):
        if result and (result[-1][0] + 2 * result[-1][2], result[-1][1]) == (x, y):
            result[-1] = (result[-1][0], y, result[-1][2] + 1)
        else:
            result.append((x, y, 1))
    return result


def slid(row, length, choose):
    """choose(row[i : i + length]) for all i."""
    return list(map(choose, *(row[k:] for k in range(length)))) if length > 1 else row


def cut(values, first, length):
    """values[first : first + length] with zeros outside."""
    before = max(0, min(-first, length))
    inside = values[max(first, 0):max(first + length, 0)]
    return [0] * before + inside + [0] * (length - before - len(inside))


def subcells(mask, points, period):
    """How many subcells to look at along x and y: the others are mirror images."""
    def is_symmetric(sx, sy):  # about the origin, and the points about the middle of the cell
        return ({(sx * x, sy * y): weight for (x, y), weight in mask.items()} == mask and
                sorted((1 + sx * (x - 1), 1 + sy * (y - 1)) for x, y in points) == points)
    if is_symmetric(-1, 1) and is_symmetric(1, -1):
        return (period + 1) // 2, (period + 1) // 2
    return period, (period + 1) // 2 if is_symmetric(-1, -1) else period


def windows(power, points, rounds, count):
    """For data in [-1, 1] at the points, the data of a subcell lie in [-alpha - beta, alpha + beta]: alpha sums the middles of the
    data of the basis functions, beta their half widths. The largest of each over the subcells, twice and times the scale."""
    period, pieces, height = 2 ** rounds, runs(points), len(power.rows)
    longest = max(length for _, _, length in pieces)
    padded = [[0] * longest + row + [0] * longest for row in power.rows]
    extremes = {length: [[slid(row, length, choose) for row in padded] for choose in (min, max)]
                for length in {length for _, _, length in pieces}}
    alpha, beta = [[0] * count[0] for _ in range(count[1])], [[0] * count[0] for _ in range(count[1])]
    for kx, ky in points:
        for wy in range(count[1]):
            ends = []
            for which, choose in ((0, min), (1, max)):
                columns = []
                for x, y, length in pieces:
                    j = (y + 2 * wy - period * ky - power.y) // 2
                    row = extremes[length][which][j] if 0 <= j < height else []
                    columns.append(cut(row, (x - period * kx - power.x) // 2 + longest, count[0]))
                ends.append(map(choose, *columns) if len(columns) > 1 else columns[0])
            for wx, (low, high) in enumerate(zip(*ends)):
                alpha[wy][wx] += abs(low + high)
                beta[wy][wx] += high - low
    return max(map(max, alpha)), max(map(max, beta))


def hull_constant(mask, points):
    """For data in [-1, 1] at the points the limit over the cell is at most this: L <= alpha + beta L, and L is finite."""
    if min(mask.values()) >= 0:
        return Fraction(1)
    best = None
    for rounds, power in powers(mask, max(k for k in range(1, 9) if k == 1 or 4 ** k * len(points) ** 2 < 5e7)):
        alpha, beta = (Fraction(x, 2 * power.scale) for x in windows(power, points, rounds, subcells(mask, points, 2 ** rounds)))
        if beta < Fraction(99, 100):
            best = alpha / (1 - beta)
        if 2 * beta <= 1:
            break
    require(best is not None, "the limits over a cell cannot be bounded")
    return best


class CellScheme:
    """Data of cells are complex numbers at the points, in units of 2^-SCALE, with one bound of the errors."""

    def __init__(self, mask, points, hull):
        self.points, self.hull, self.scale = points, hull, denominator(mask)
        weights = {place: int(weight * self.scale) for place, weight in mask.items()}
        self.children = [[[(k, weights[x + ex - 2 * i, y + ey - 2 * j]) for k, (i, j) in enumerate(points)
                           if (x + ex - 2 * i, y + ey - 2 * j) in weights] for x, y in points] for ex, ey in CHILDREN]
        self.norm = max(sum(abs(weight) for _, weight in row) for child in self.children for row in child)

    def child(self, data, number):
        real, imaginary, error = data
        rows, scale = self.children[number], self.scale
        return ([sum(w * real[k] for k, w in row) // scale for row in rows],
                [sum(w * imaginary[k] for k, w in row) // scale for row in rows], self.norm * error // scale + 2)

    def box(self, data, turn):
        """Bounds of the limits over the cell times the integers turn: (least, most) of real and imaginary parts."""
        (a, b), (real, imaginary, error) = turn, data
        slack, result = (abs(a) + abs(b)) * error, []
        for values in ([a * x - b * y for x, y in zip(real, imaginary)], [a * y + b * x for x, y in zip(real, imaginary)]):
            middle, half = min(values) + max(values), max(values) - min(values)  # twice
            radius = (half + 2 * slack) * self.hull.numerator // self.hull.denominator + 1 + 2 * slack
            result.append((middle - radius, middle + radius))
        return result


def rounded_data(values):
    shift = ONE >> SCALE
    middles = [[(x.low + x.high) // (2 * shift) for x in part] for part in zip(*values)]
    return middles[0], middles[1], max(x.high - x.low for value in values for x in value) // (2 * shift) + 2


def direction(x, y):
    """Integers near 2^40 times the unit vector, for boxes that are turned."""
    x, y = x >> SCALE - 60, y >> SCALE - 60
    length = math.isqrt(x * x + y * y)
    require(length > 0, "a cell of the ring has no direction")
    return (x << 40) // length, (y << 40) // length


class HullTest:
    def __init__(self, ring, net):
        masks = [ring.regular.mask] + ring.regular.derivatives
        if not all(map(is_rational, masks)):
            raise CannotCheck("the regular part and the eigenvalue order were checked, the ring of an irrational mask was not")
        hulls = [hull_constant(mask, points) for mask, points in zip(masks[:2], ring.sets)]
        swapped = ({(y, x): weight for (x, y), weight in masks[2].items()}, sorted((y, x) for x, y in ring.sets[2]))
        hulls.append(hulls[1] if swapped == (masks[1], ring.sets[1]) else hull_constant(masks[2], ring.sets[2]))
        self.schemes, self.net = [CellScheme(*all_of) for all_of in zip(masks, ring.sets, hulls)], net
        re, im = net.local.units[1]
        self.back = (re.low >> 120, -(im.low >> 120))  # 2^40 times the unit vector back from the bisector

    def data(self, cell):
        i, j = cell
        result = [rounded_data([self.net.seen(i + x, j + y) for x, y in self.schemes[0].points])]
        for (dx, dy), scheme in zip(((1, 0), (0, 1)), self.schemes[1:]):
            ends = [(self.net.seen(i + x + dx, j + y + dy), self.net.seen(i + x - dx, j + y - dy)) for x, y in scheme.points]
            result.append(rounded_data([(p[0] - q[0], p[1] - q[1]) for p, q in ends]))
        return result

    def accepts(self, data):
        position, du, dv = data
        x, y = direction(sum(du[0]), sum(du[1]))
        u, v = self.schemes[1].box(du, (x, -y)), self.schemes[2].box(dv, (x, -y))
        least = min(a * b for a in u[0] for b in v[1])
        most = max(a * b for a in u[1] for b in v[0])
        image = self.schemes[0].box(position, self.back)[0]
        size = max(map(abs, position[0])) + max(map(abs, position[1])) + position[2]
        # The turn back is off by less than 2 units of 2^-40 in each part; limits are at most the hull constant times the data.
        slack = 4 * (size * self.schemes[0].hull.numerator // self.schemes[0].hull.denominator + 1)
        return least > most and image[0] > 2 * slack

    def read(self, data, code, depth):
        """Follows the code of a cell: '1' is a cell in four children, '0' one to accept. Returns what is left of the code."""
        require(code and depth <= DEEPEST and code[0] in "01", "the text of a cell of the ring is not as it should be")
        if code[0] == "0":
            require(self.accepts(data), "a cell of the ring has no positive bound")
            return code[1:]
        code = code[1:]
        for number in range(4):
            code = self.read([scheme.child(part, number) for scheme, part in zip(self.schemes, data)], code, depth + 1)
        return code


def check_hulls(ring, net, cells):
    require(isinstance(cells, list) and len(cells) == len(ring.cells) and all(isinstance(code, str) for code in cells),
            f"the ring needs {len(ring.cells)} texts for its cells")
    test = HullTest(ring, net)
    for cell, code in zip(ring.cells, cells):
        require(test.read(test.data(cell), code, 0) == "", "the text of a cell goes on after its end")
