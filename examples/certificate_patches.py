"""The 4 x 4 net of a uniform bicubic B-spline patch, and when vectors and signs prove the patch regular.

T2 compares the differences of the net, T3 those of its Bezier net, T4 looks at the Bernstein coefficients of S_u x S_v. In the
plane all determinants must have one sign. In space n.u > 0 > n.v and m.u, m.v > 0 for all differences, or n.w > 0 for all
coefficients. Zero vectors may be left out where every corner of the patch keeps others: at each point of the patch S_u and S_v
are sums with positive weights of the vectors that count at some corner, and perhaps more.
"""
import math
from fractions import Fraction

from certificate_algebra import CannotCheck, entries, fraction, integer, require

HALVES = ((4, 4, 0, 0), (1, 6, 1, 0), (0, 4, 4, 0), (0, 1, 6, 1), (0, 0, 4, 4))  # over 8
BEZIER = ((1, 4, 1, 0), (0, 4, 2, 0), (0, 2, 4, 0), (0, 1, 4, 1))  # over 6


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def weighted(weights, points):
    terms = [(w, p) for w, p in zip(weights, points) if w]
    return tuple(sum(w * p[c] for w, p in terms) for c in range(3))


def tensor(matrix, rows):
    """The same weights in both directions."""
    lines = [[weighted(weights, column) for column in zip(*rows)] for weights in matrix]
    return [[weighted(weights, line) for weights in matrix] for line in lines]


def transposed(rows):
    return [list(column) for column in zip(*rows)]


class Net:
    """rows[i][j]: row i along v, column j along u. flags: the sides bottom, right, top, left that are boundaries."""

    def __init__(self, rows, flags=(False,) * 4):
        self.rows, self.flags = rows, flags

    def children(self):
        """The quarters 2 r + c, times 64."""
        fine, (bottom, right, top, left) = tensor(HALVES, self.rows), self.flags
        return [Net([line[c:c + 4] for line in fine[r:r + 4]], (bottom and r == 0, right and c == 1, top and r == 1, left and c == 0))
                for r in (0, 1) for c in (0, 1)]

    def steps(self):
        """The differences along u as lines (first line, first step, table), and those along v, transposed. Reflected lines and
        the steps across a boundary are left out: they repeat others with weights that stay positive."""
        bottom, right, top, left = self.flags
        along_u = [list(map(minus, row[1:], row)) for row in self.rows]
        along_v = [list(map(minus, column[1:], column)) for column in transposed(self.rows)]
        return (Steps(along_u, (bottom, top), (left, right)), Steps(along_v, (left, right), (bottom, top)))

    def derivatives(self, u, v):
        """S_u and S_v at a point, up to positive factors."""
        def basis(t):
            return (1 - t) ** 3, 3 * t ** 3 - 6 * t ** 2 + 4, -3 * t ** 3 + 3 * t ** 2 + 3 * t + 1, t ** 3

        def slopes(t):
            return -(1 - t) ** 2, 3 * t ** 2 - 4 * t, -3 * t ** 2 + 2 * t + 1, t ** 2
        return (weighted(basis(v), [weighted(slopes(u), row) for row in self.rows]),
                weighted(slopes(v), [weighted(basis(u), row) for row in self.rows]))


class Steps:
    """table[line][step]; lines and steps at flagged ends do not count."""

    def __init__(self, table, outer_lines, outer_steps):
        self.table = table
        self.lines = range(int(outer_lines[0]), 4 - outer_lines[1])
        self.steps = range(int(outer_steps[0]), 3 - outer_steps[1])

    def nonzero(self):
        return [self.table[i][j] for i in self.lines for j in self.steps if any(self.table[i][j])]

    def has_corners(self):
        """Beside each corner some vector is not zero: on its line and both neighbours, or on its line alone at a boundary."""
        def stencil(line, position):
            on_boundary = (line == 1 and 0 not in self.lines) or (line == 2 and 3 not in self.lines)
            for i in [line] if on_boundary else [line - 1, line, line + 1]:
                for j in (position - 1, position):
                    if j in self.steps:
                        yield self.table[i][j]
        return all(any(map(any, stencil(line, position))) for line in (1, 2) for position in (1, 2))


def bezier(net):
    """The Bezier net, whose end points alone count at its corners."""
    return Net(tensor(BEZIER, net.rows))


def bezier_steps(net):
    along_u, along_v = bezier(net).steps()
    require(all(any(steps.table[i][j]) for steps in (along_u, along_v) for i in (0, 3) for j in (0, 2)),
            "a difference at a corner of a Bezier net is zero")
    return along_u.nonzero(), along_v.nonzero()


def net_steps(net):
    along_u, along_v = net.steps()
    require(along_u.has_corners() and along_v.has_corners(), "all differences at a corner of a patch are zero")
    return along_u.nonzero(), along_v.nonzero()


def normals(net):
    """The Bernstein coefficients of S_u x S_v, of degree 5 in u and v, but the zeros."""
    along_u, along_v = bezier(net).steps()
    result = [[(0, 0, 0)] * 6 for _ in range(6)]
    for i in range(4):
        for j in range(3):
            for p in range(3):
                for q in range(4):
                    of_u = Fraction(10 * math.comb(2, j) * math.comb(3, q), math.comb(5, j + q))
                    of_v = Fraction(10 * math.comb(3, i) * math.comb(2, p), math.comb(5, i + p))
                    normal = cross(along_u.table[i][j], along_v.table[q][p])
                    result[i + p][j + q] = weighted((1, int(of_u * of_v)), (result[i + p][j + q], normal))
    require(all(any(result[i][j]) for i in (0, 5) for j in (0, 5)), "a normal at a corner of a patch is zero")
    return [w for row in result for w in row if any(w)]


def vector(value, where):
    require(isinstance(value, list) and len(value) == 3, f"{where} must have three entries")
    return tuple(fraction(x, where) for x in value)


def is_positive(n, vectors):
    return all(dot(n, w) > 0 for w in vectors)


def check_separation(data, u, v):
    n, m = vector(data["n"], "n"), vector(data["m"], "m")
    require(is_positive(n, u) and is_positive(tuple(-x for x in n), v) and is_positive(m, u) and is_positive(m, v),
            "n and m do not separate the differences")


def check_leaf(net, data, planar):
    entries(data, ["path", "test", "sign"] if planar else ["path", "test", "n"] + ["m"] * (data.get("test") != "T4"),
            "a part of a patch")
    require(data["test"] in ("T2", "T3", "T4"), "the test must be T2, T3 or T4")
    if data["test"] == "T4":
        vectors = normals(net)
        if not planar:
            require(is_positive(vector(data["n"], "n"), vectors), "the normals are not in the half space of n")
    else:
        u, v = net_steps(net) if data["test"] == "T2" else bezier_steps(net)
        if not planar:
            check_separation(data, u, v)
        vectors = [cross(a, b) for a in u for b in v] if planar else []
    if planar:
        sign = integer(data["sign"], -1, 1, "the sign")
        require(all(sign * w[2] > 0 for w in vectors), "the determinants do not have this sign")


def check_patch(net, leaves, planar):
    """The paths are leaves of a tree in which every inner node has all four children: so they cover the patch."""
    require(isinstance(leaves, list) and leaves, "a patch needs a list of parts")
    if len(leaves) > 100000:
        raise CannotCheck("patches of so many parts are not checked here")
    for leaf in leaves:
        require(isinstance(leaf, dict) and isinstance(leaf.get("path"), str) and len(leaf["path"]) <= 60 and
                set(leaf["path"]) <= set("0123"), "a path must consist of at most 60 digits 0 to 3")
        require(isinstance(leaf.get("test"), str), "the test must be a text")
    unseen = [(net, 0, leaves)]
    while unseen:
        net, depth, leaves = unseen.pop()
        if any(len(leaf["path"]) == depth for leaf in leaves):
            require(len(leaves) == 1, "the paths of a patch cover points twice")
            check_leaf(net, leaves[0], planar)
            continue
        for digit, child in zip("0123", net.children()):
            part = [leaf for leaf in leaves if leaf["path"][depth] == digit]
            require(part, "the paths of a patch do not cover it")
            unseen.append((child, depth + 1, part))
