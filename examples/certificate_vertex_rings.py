"""Catmull-Clark surfaces around an interior vertex of valence n: rings of regular patches, and why all small rings are regular.

X, the points of two rings around the vertex, goes to A X on the next level. With left and right eigenvectors w and 1 of 1, L and E
of the double eigenvalue lambda, L E = 1, and p = L X, the points of level m are 1 w X + lambda^m (E p + R). A u- and a v-difference
in a patch of the next ring, times lambda^-m, are c p + e and d p + f, where c, d are the differences of E and |e|, |f| <= eta. So
their cross product has N = p_1 x p_2 times it at least |N|^2 kappa - |N| (2 G sigma eta + eta^2), for det(c, d) >= kappa,
|c|, |d| <= G and the norm sigma of p. Where that is positive the patches are regular, on this ring and all smaller ones, as
eta = D C max |row of R| bounds them, too. With the characteristic map regular and injective the surface is C^1 at the vertex.
"""
import math
from fractions import Fraction
from functools import lru_cache

from certificate_algebra import CannotCheck, require
from certificate_enclosures import BITS, ONE, Enclosure, around, cosine, enclosed, total, unit
from certificate_lattices import CENTRE, Lattice, Round
from certificate_patches import BEZIER, HALVES, Net, cross, minus

MOST_LEVELS, MOST_NEIGHBOURS = 40, 30
ZERO = Enclosure(0, 0)


def scaled(enclosure, k):
    """Times an integer."""
    ends = sorted((enclosure.low * k, enclosure.high * k))
    return Enclosure(*ends)


def root(x):
    require(x.low >= 0, "a root of what may be negative")
    return Enclosure(math.isqrt(x.low << BITS), math.isqrt(x.high << BITS) + 1)


def square(x):
    low = 0 if x.low <= 0 <= x.high else min(x.low * x.low, x.high * x.high) >> BITS
    return Enclosure(low, -(-max(x.low * x.low, x.high * x.high) >> BITS))


def length(vector):
    return root(total(map(square, vector)))


def largest(values):
    values = list(values)
    return Enclosure(max(x.low for x in values), max(x.high for x in values))


def smallest(values):
    values = list(values)
    return Enclosure(min(x.low for x in values), min(x.high for x in values))


class Constants:
    """What depends on n alone. Places are those of the lattice, two rings first, three in all."""

    def __init__(self, n):
        self.n, self.lattice = n, Lattice(n, False, False)
        inner, outer = self.lattice.orbits(4), [place for place in self.lattice.orbits(6) if self.lattice.radius(place) == 6]
        self.places = [CENTRE] + [self.lattice.rotated(place, s) for part in (inner, outer) for s in range(n) for place in part]
        self.index = {place: k for k, place in enumerate(self.places)}
        self.size, self.inner = 1 + n * len(inner), inner
        self.find_rows()
        self.check_first_ring()
        self.find_mean()
        self.find_eigenvectors()
        self.bound_ring()
        self.bound_rows()
        self.bound_powers()

    def at(self, s, x, y):
        return self.index[self.lattice.fold(s, x, y)]

    def find_rows(self):
        """A and the rows of the third ring from one round of the word, as integers over one denominator."""
        delta = {str(valence): str(Fraction(valence - 4, valence)) for valence in {4, self.n}}
        word = {"triangles": False, "items": [{"atom": "U", "sections": 2}, {"atom": "C", "f": "1", "ngon": "classic"},
                                              {"atom": "P", "omega": "0", "omega_face": None, "delta": delta}]}
        row = Round(word, self.lattice).row
        rows = []
        for place in self.places:
            weights = row((0, *place[1:]))
            rows.append({self.index[self.lattice.rotated(old, place[0])]: weight for old, weight in weights.items()})
        require(all(sum(row.values()) == 1 and max(row) < self.size for row in rows), "rows around a vertex see too much")
        self.denominator = math.lcm(*(weight.denominator for row in rows for weight in row.values()))
        self.rows = [[(k, int(weight * self.denominator)) for k, weight in row.items()] for row in rows]

    def check_first_ring(self):
        """The new points e on spokes and f between them are those for which lambda, L and E are known in closed form."""
        for s in range(self.n):
            centre, before, e, after = CENTRE, (s - 1, 2, 0), (s, 2, 0), (s + 1, 2, 0)
            diagonals = (s - 1, 2, 2), (s, 2, 2)
            of_e = {centre: 6, e: 6, before: 1, after: 1, diagonals[0]: 1, diagonals[1]: 1}
            of_f = {centre: 4, e: 4, after: 4, diagonals[1]: 4}
            for place, weights in ((e, of_e), (diagonals[1], of_f)):
                expected = {self.at(*old): Fraction(weight, 16) for old, weight in weights.items()}
                require({k: Fraction(weight, self.denominator) for k, weight in self.rows[self.at(*place)]} == expected,
                        "rows around a vertex are not those of Catmull and Clark")

    def find_mean(self):
        """w: n^2 at the vertex, 4 at the points e, 1 at the points f."""
        n, self.mean = self.n, [Fraction(0)] * self.size
        self.mean[0] = Fraction(n, n + 5)
        for s in range(n):
            self.mean[self.at(s, 2, 0)], self.mean[self.at(s, 2, 2)] = Fraction(4, n * (n + 5)), Fraction(1, n * (n + 5))
        image = [Fraction(0)] * self.size
        for weight, row in zip(self.mean, self.rows):
            for k, a in row:
                image[k] += weight * Fraction(a, self.denominator)
        require(image == self.mean and sum(self.mean) == 1, "the limit weights of a vertex are no eigenvector")

    def find_eigenvectors(self):
        """e_j = z^j, f_j = (z^j + z^(j+1))/(4 lambda - 1) for z = e^(2 pi i/n) is an eigenvector on the first ring, a z^j on e_j
        and z^j + z^(j+1) on f_j, a = 16 lambda - 4, a left one, both if 16 lambda = 5 + c + sqrt((1 + c) (9 + c)), c = cos 2 pi/n."""
        n, one = self.n, enclosed(1)
        c = cosine(Fraction(2, n))
        a = one + c + root((one + c) * (enclosed(9) + c))
        self.value = (a + enclosed(4)).over(enclosed(16))
        divisor = scaled(self.value, 4) - one
        e = [unit(Fraction(2 * s, n)) for s in range(n)]
        f = [tuple(x + y for x, y in zip(e[s], e[(s + 1) % n])) for s in range(n)]
        product = scaled(a.over(enclosed(2)) + (one + c).over(divisor), n)  # of the left and the right vector
        self.left, self.right = [(ZERO, ZERO)] * self.size, [(ZERO, ZERO)] * self.size
        for s in range(n):
            on_spoke, between = self.at(s, 2, 0), self.at(s, 2, 2)
            self.left[on_spoke] = tuple((a * x).over(product) for x in e[s])
            self.left[between] = tuple(x.over(product) for x in f[s])
            self.right[on_spoke], self.right[between] = e[s], tuple(x.over(divisor) for x in f[s])
        for part in (0, 1):
            self.extend(part)

    def extend(self, part):
        """E on the second ring, x = (A_21 x_1 + A_22 x)/lambda: by iteration, and a bound of what then is wrong."""
        ring = [k for k in range(self.size) if self.lattice.radius(self.places[k]) == 4]
        norm = max(sum(abs(a) for j, a in self.rows[k] if j in set(ring)) for k in ring)  # of A_22, times the denominator
        x = [(pair[part].low + pair[part].high) // 2 for pair in self.right]
        step = self.denominator * ((self.value.low + self.value.high) // 2)
        for _ in range(6 * BITS):
            following = {k: (sum(a * x[j] for j, a in self.rows[k]) << BITS) // step for k in ring}
            close = all(abs(x[k] - y) <= 1 for k, y in following.items())
            for k, y in following.items():
                x[k] = y
            if close:
                break
        values = [pair[part] for pair in self.right]
        for k in ring:
            values[k] = around(x[k], 0)
        images = self.times_rows(values)
        wrong = max((self.value * values[k] - images[k]).magnitude() for k in ring)
        gap = self.value.low * self.denominator - (norm << BITS)  # of lambda - |A_22|, times the denominator
        require(gap > 0, "the second ring is not determined by the first")
        error = (wrong * self.denominator << BITS) // gap + 1
        for k in ring:
            pair = list(self.right[k])
            pair[part] = around(x[k], error)
            self.right[k] = tuple(pair)

    def times_rows(self, values):
        whole = enclosed(self.denominator)
        return [total(scaled(values[k], a) for k, a in row).over(whole) for row in self.rows]

    def patch(self, number, values):
        """The net of patch 3 s + k of the ring from values at all places: the faces (1, 0), (1, 1), (0, 1) of sector s."""
        (i, j), s = ((1, 0), (1, 1), (0, 1))[number % 3], number // 3
        return [[values[self.at(s, 2 * (i - 1 + column), 2 * (j - 1 + row))] for column in range(4)] for row in range(4)]

    def bound_ring(self):
        """kappa > 0 and G. The other sectors are rotated copies. For n >= 9 all patches are split once. By kappa > 0 the
        characteristic map is regular; as sectors lie in the half planes of their bisectors it winds round once and is injective."""
        self.splits = 1 if self.n >= 9 else 0
        ring = list(zip(*(self.times_rows(values) for values in zip(*self.right))))
        bisector = unit(Fraction(1, self.n))
        determinants, sizes = [], []
        for number in range(3):
            rows = self.patch(number, ring)
            require(all((x * bisector[0] + y * bisector[1]).low > 0 for row in tensor(BEZIER, rows) for x, y in row),
                    "the image of a sector is not in its half plane")
            for net in quarters(rows) if self.splits else [rows]:
                u = [minus(b, a) for row in net for a, b in zip(row, row[1:])]
                v = [minus(b, a) for first, second in zip(net, net[1:]) for a, b in zip(first, second)]
                sizes += map(length, u + v)
                determinants += [c[0] * d[1] - c[1] * d[0] for c in u for d in v]
        self.kappa, self.span = smallest(determinants), largest(sizes)
        require(self.kappa.low > 0, "the differences of the characteristic ring have no positive bound")

    def bound_rows(self):
        """D: the norm of the differences as rows over X. Those of a split patch are sums with weights of sum 1/2."""
        worst = 0
        for number in range(3):
            rows = self.patch(number, [dict(row) for row in self.rows])
            pairs = [pair for line in rows for pair in zip(line, line[1:])]
            pairs += [pair for first, second in zip(rows, rows[1:]) for pair in zip(first, second)]
            worst = max([worst] + [sum(abs(b.get(k, 0) - a.get(k, 0)) for k in {**a, **b}) for a, b in pairs])
        self.difference = Fraction(worst, self.denominator * 2 ** self.splits)

    def bound_powers(self):
        """C: of Q B^r, Q = 1 - 1 w - E L, B = A Q/lambda, for all r, as some power of B has at most the norm 1/2. The rows of one
        sector and the vertex are enough. Q B^r is (A^r - 1 w - lambda^r E L)/lambda^r."""
        chosen = [0] + [self.index[place] for place in self.inner]
        mean = list(map(enclosed, self.mean))
        projection = [[total(x * y for x, y in zip(self.right[k], left)) for left in self.left] for k in chosen]
        rows, whole, scale, self.bound = [[int(j == k) for j in range(self.size)] for k in chosen], 1, enclosed(1), 0
        for power in range(1000):
            norm = 0
            for row, shadow in zip(rows, projection):
                parts = (enclosed(Fraction(a, whole)) - w - scale * x for a, w, x in zip(row, mean, shadow))
                norm = max(norm, sum(x.magnitude() for x in parts))
            norm = Enclosure(norm, norm).over(scale).high
            if power > 0 and 2 * norm <= ONE:
                return
            self.bound = max(self.bound, norm)
            rows = [self.advanced(row) for row in rows]
            whole, scale = whole * self.denominator, scale * self.value
        raise CannotCheck("the powers of the matrix around a vertex do not contract soon enough")

    def advanced(self, row):
        result = [0] * self.size
        for x, weights in zip(row, self.rows):
            if x:
                for k, a in weights:
                    result[k] += x * a
        return result


constants = lru_cache(maxsize=None)(Constants)


# Points of the plane as enclosures ------------------------------------------------------------------------------------------------

def weighted(weights, points):
    terms = [(w, p) for w, p in zip(weights, points) if w]
    return tuple(total(scaled(p[part], w) for w, p in terms) for part in (0, 1))


def tensor(matrix, rows):
    lines = [[weighted(weights, column) for column in zip(*rows)] for weights in matrix]
    return [[weighted(weights, line) for weights in matrix] for line in lines]


def quarters(rows):
    fine = [[tuple(x.over(enclosed(64)) for x in point) for point in line] for line in tensor(HALVES, rows)]
    return [[line[c:c + 4] for line in fine[r:r + 4]] for r in (0, 1) for c in (0, 1)]


# The rings of one vertex ----------------------------------------------------------------------------------------------------------

def two_rings(mesh, v, at):
    """The numbers of the vertices of two rings, listed by at(sector, x, y)."""
    result = {0: v}
    for s, out in enumerate(mesh.fans[v]):
        side = mesh.next[out]  # from (2, 0) to (2, 2), with faces of the second ring across this and the following side
        right, above = mesh.next[mesh.twin[side]], mesh.next[mesh.twin[mesh.next[side]]]
        beyond = mesh.next[mesh.twin[mesh.next[mesh.next[right]]]]
        places = (2, 0), (2, 2), (4, 0), (4, 2), (2, 4), (4, 4)
        for (x, y), h in zip(places, (out, side, right, mesh.next[right], above, beyond)):
            result[at(s, x, y)] = mesh.tip(h)
    return [result[k] for k in range(len(result))]


class VertexRings:
    def __init__(self, covered, v):
        mesh = covered.mesh
        require(covered.classes[v] == "extraordinary" and covered.is_isolated(v), "a vertex has no rings of regular patches")
        require(3 <= len(mesh.fans[v]) <= MOST_NEIGHBOURS, "rings are known for the valences 3 to 30 only")
        self.constants = constants(len(mesh.fans[v]))
        points = [covered.points[w] for w in two_rings(mesh, v, self.constants.at)]
        whole = math.lcm(*(w.denominator for w in self.constants.mean))
        weights = [int(w * whole) for w in self.constants.mean]
        middle = [sum(w * p[c] for w, p in zip(weights, points)) for c in range(3)]
        self.levels = [[tuple(whole * x - m for x, m in zip(p, middle)) for p in points]]  # A^m (X - 1 w X) times whole d^m

    def following(self, level):
        """All three rings of the level after this one."""
        require(0 <= level < MOST_LEVELS, "there are 40 levels only")
        while len(self.levels) <= level:
            self.levels.append(self.outer(self.levels[-1])[:self.constants.size])
        return self.outer(self.levels[level])

    def outer(self, points):
        return [tuple(sum(a * points[k][c] for k, a in row) for c in range(3)) for row in self.constants.rows]

    def nets(self, ring):
        points = self.following(ring - 1)
        return [Net(self.constants.patch(number, points)) for number in range(3 * self.constants.n)]

    def check_closing(self, level):
        c, size = self.constants, max(abs(x) for p in self.levels[0] for x in p)
        require(size > 0, "all points around a vertex are the same")
        points = self.levels[0] if level == 0 else self.following(level - 1)[:c.size]
        start = [tuple(enclosed(Fraction(x, size)) for x in p) for p in self.levels[0]]
        p = [[total(left[part] * q[k] for left, q in zip(c.left, start)) for k in range(3)] for part in (0, 1)]
        power, whole = enclosed(1), size * c.denominator ** level
        for _ in range(level):
            power = power * c.value
        rest = [[enclosed(Fraction(x, whole)).over(power) - e[0] * p[0][k] - e[1] * p[1][k] for k, x in enumerate(q)]
                for e, q in zip(c.right, points)]
        eta = enclosed(c.difference) * Enclosure(c.bound, c.bound) * largest(map(length, rest))
        first, second, mixed = (total(x * y for x, y in zip(p[i], p[j])) for i, j in ((0, 0), (1, 1), (0, 1)))
        two = enclosed(2)
        sigma = root((first + second).over(two) + root(square((first - second).over(two)) + square(mixed)))
        gain, loss = length(cross(*p)) * c.kappa, scaled(c.span * sigma * eta, 2) + square(eta)
        if gain.low <= loss.high:
            require(gain.high > loss.low, "the rings around a vertex do not close at this level")
            raise CannotCheck("whether the rings around a vertex close is not seen in the precision here")
