"""Certificates about curves: words run on closed polygons, difference schemes, products of transition matrices, polytopes."""
import math
from fractions import Fraction

from certificate_algebra import (characteristic, divided, entries, fraction, gcd, has_unit_zero, integer,
                                 require, times, trimmed, value_at)


def check_item(item, where):
    require(isinstance(item, dict) and item.get("atom") in ("U", "D", "C", "P"), f"{where} is no atom")
    atom = item["atom"]
    if atom == "U":
        entries(item, ["atom", "sections"], where)
        integer(item["sections"], 2, 1000, where)
    elif atom == "P":
        entries(item, ["atom", "omega", "omega_face", "delta"], where)
        require(item["omega_face"] is None, f"{where}: omega_face means nothing on curves")
        entries(item["delta"], ["4"], f"{where}.delta")
        fraction(item["omega"], f"{where}.omega")
        fraction(item["delta"]["4"], f"{where}.delta")
    else:
        entries(item, ["atom", "f"] if atom == "D" else ["atom", "f", "ngon"], where)
        require(item.get("ngon", "dual") == "dual", f"{where}: ngon means nothing on curves")
        fraction(item["f"], f"{where}.f")


def average(points, f, sections):
    """D from points to edges; every `sections`-th point weighs f."""
    def weight(i):
        return f if i % sections == 0 else Fraction(1)
    result = []
    for i, point in enumerate(points):
        j = (i + 1) % len(points)
        total = weight(i) + weight(j)
        require(total != 0, "the weights of an average sum to zero")
        result.append((weight(i) * point + weight(j) * points[j]) / total)
    return result


def split(points, d):
    n = len(points)
    return [((d - s) * points[i] + s * points[(i + 1) % n]) / d for i in range(n) for s in range(d)]


class Curve:
    """A closed polygon under a word. `reach`: the indices that old point 0 can have influenced."""

    def __init__(self, points):
        self.points, self.edges = points, None
        self.sections, self.averages, self.before = 0, 0, None
        self.reach, self.reach_before = (0, 0), (0, 0)

    def realise(self):
        if self.edges is not None:
            self.points, self.edges = self.edges, None

    def up(self, d):
        self.realise()
        self.before, self.reach_before, self.sections, self.averages = self.points, self.reach, d, 0
        self.points = split(self.points, d)
        self.reach = (d * self.reach[0] - d + 1, d * self.reach[1] + d - 1)

    def down(self, f):
        low, high = self.reach
        if self.edges is not None:
            n = len(self.edges)
            self.points, self.edges = [(self.edges[i - 1] + self.edges[i]) / 2 for i in range(n)], None
            self.reach = (low, high + 1)
            require(f == 1, "an f that does not act")
        else:
            acts = self.sections > 0 and (self.averages == 0 or f != 1)
            require(acts or f == 1, "an f that does not act")
            self.edges = average(self.points, f if acts else Fraction(1), self.sections or 1)
            self.reach = (low - 1, high)
        self.averages += 1

    def push_back(self, omega, delta):
        require(self.before is not None and self.edges is None, "P needs an earlier U and points")
        d = self.sections
        spread = split([delta * (old - self.points[d * i]) for i, old in enumerate(self.before)], d)
        self.points = [p + (1 if i % d == 0 else omega) * s for i, (p, s) in enumerate(zip(self.points, spread))]
        low = min(self.reach_before[0], -(-self.reach[0] // d))
        high = max(self.reach_before[1], self.reach[1] // d)
        self.reach = (min(self.reach[0], d * low - d + 1), max(self.reach[1], d * high + d - 1))

    def run(self, items):
        for item in items:
            if item["atom"] == "U":
                self.up(item["sections"])
            elif item["atom"] == "P":
                self.push_back(Fraction(item["omega"]), Fraction(item["delta"]["4"]))
            else:
                self.down(Fraction(item["f"]))
                if item["atom"] == "C":
                    self.down(Fraction(1))
        self.realise()


def mask_of(word):
    """Arity, first index and coefficients of new_i = sum a_(i - A j) old_j."""
    entries(word, ["triangles", "items"], "the word")
    require(word["triangles"] is False and isinstance(word["items"], list) and 1 <= len(word["items"]) <= 200, "no word for curves")
    arity = 1
    for k, item in enumerate(word["items"]):
        check_item(item, f"item {k}")
        arity *= item.get("sections", 1)
        require(arity <= 1000000, "the word multiplies the points too much")
    require(arity > 1, "a word without U")
    states = sum({"D": 1, "C": 2}.get(item["atom"], 0) for item in word["items"])
    require(states < 1000, "a word with too many averages")
    count = 8
    while True:
        curve = Curve([Fraction(int(i == 0)) for i in range(count)])
        curve.run(word["items"])
        low, high = curve.reach
        if arity * count > high - low + 4 * arity:  # the two ends do not meet round the back
            break
        count *= 2
    values = {i: curve.points[i % len(curve.points)] for i in range(low, high + 1)}
    kept = [i for i in values if values[i] != 0]
    return arity, min(kept), [values[i] for i in range(min(kept), max(kept) + 1)]


def describe(word):
    splits = sum(item["atom"] == "U" for item in word["items"])
    pushes = sum(item["atom"] == "P" for item in word["items"])
    atoms, parameters, averages = [], [], 0
    for item in word["items"]:
        own = [str(item["sections"])] if item.get("sections", 2) != 2 else []
        if item.get("f", "1") != "1":
            (parameters if splits == 1 and averages == 0 else own).append(f"f = {item['f']}")
        averages += item["atom"] in "CD"
        if item["atom"] == "P":
            (parameters if pushes == 1 else own).extend([f"omega = {item['omega']}", f"delta = {item['delta']['4']}"])
        atoms.append(item["atom"] + (f"[{', '.join(own)}]" if own else ""))
    return f"({' '.join(atoms)})*" + (" where " + ", ".join(parameters) if parameters else "")


def is_stable(arity, first, mask):
    at = dict(enumerate(mask, first))
    if at.get(0) == 1 and all(c == 0 or i % arity != 0 or i == 0 for i, c in at.items()):
        return True
    if arity != 2:
        return False
    pairs = gcd(mask, [-c if k % 2 else c for k, c in enumerate(mask)])
    if has_unit_zero(pairs[::2]):
        return False
    rest = trimmed(mask)
    while value_at(rest, -1) == 0:
        rest = divided(rest, [Fraction(1), Fraction(1)])[0]
    degree = len(rest) - 1
    require(degree <= 60, "the mask is too long to decide stability")
    cyclotomic = {}
    for n in range(1, 2 * degree * degree + 1, 2):
        if sum(1 for k in range(1, n + 1) if math.gcd(k, n) == 1) > max(degree, 1):
            continue
        p = [Fraction(1)] + [Fraction(0)] * (n - 1) + [Fraction(1)]
        for d in range(1, n, 2):
            if n % d == 0:
                p = divided(p, cyclotomic[d])[0]
        cyclotomic[n] = p
        if n > 1 and not divided(rest, p)[1]:
            return False
    return True


def difference(arity, mask):
    """The mask of the scheme of differences, or None."""
    result = []
    for i in range(len(mask) + 1):
        c = (mask[i] if i < len(mask) else 0) - (mask[i - 1] if i > 0 else 0)
        result.append(c + (result[i - arity] if i >= arity else 0))
    degree = len(mask) - arity + 1
    return result[:degree] if degree > 0 and all(c == 0 for c in result[degree:]) else None


def all_differences(arity, mask):
    """The masks of the schemes of differences of orders 0, 1, .. up to the number of sum rules."""
    result = [mask]
    while sum(mask) == arity:
        following = difference(arity, result[-1])
        if following is None:
            break
        result.append(following)
    return result


def norm(arity, mask, rounds):
    result, stride = [Fraction(1)], 1
    for _ in range(rounds):
        require(len(mask) * stride < 1000000, "too many rounds")
        following = [Fraction(0)] * ((len(mask) - 1) * stride + len(result))
        for i, c in enumerate(mask):
            for j, r in enumerate(result):
                following[i * stride + j] += c * r
        result, stride = following, stride * arity
    return max(sum(abs(c) for c in result[r::stride]) for r in range(stride))


def transition(arity, mask):
    m = max(1, -(-(len(mask) - 1) // (arity - 1)))
    require(arity * m * m <= 50000, "the transition matrices are too large")

    def c(k):
        return mask[k] if 0 <= k < len(mask) else Fraction(0)
    return [[[c(arity * t + e - s) for t in range(m)] for s in range(m)] for e in range(arity)]


def reaches(matrices, letters, bound):
    """Has the product an eigenvalue of modulus bound^length or more? Otherwise Schur and Cohn's test finds all zeros inside."""
    product = matrices[letters[0]]
    for letter in letters[1:]:
        product = times(product, matrices[letter])
    radius = bound ** len(letters)
    p = [c / radius ** k for k, c in enumerate(characteristic(product))]  # of the product over the radius
    while len(p) > 1:
        if abs(p[-1]) >= 1:
            return True
        p = [(x - p[-1] * y) / (1 - p[-1] ** 2) for x, y in zip(p[:-1], p[:0:-1])]
    return False


def combination(value, count):
    require(isinstance(value, dict) and list(value) == sorted(value, key=lambda name: name.zfill(9)), "a combination names vectors in order")
    require(all(name.isdecimal() and str(int(name)) == name and int(name) < count for name in value), "no such vector")
    result = {int(name): fraction(weight, "a weight") for name, weight in value.items()}
    require(0 not in result.values(), "a weight is zero")
    return result


def rest_of(x, terms, vectors):
    return sum(abs(x[i] - sum(w * vectors[k][i] for k, w in terms.items())) for i in range(len(x)))


def polytope_bound(matrices, data):
    """With the gauge of the polytope, gauge(x) <= sum |w| + reach |x - sum w_k v_k|_1."""
    entries(data, ["kind", "bound", "vectors", "units", "images"], "the polytope")
    bound, n = fraction(data["bound"], "the bound"), len(matrices[0])
    require(isinstance(data["vectors"], list) and all(isinstance(v, list) and len(v) == n for v in data["vectors"]),
            "the vectors of the polytope do not fit")
    vectors = [[fraction(x, "a vector") for x in v] for v in data["vectors"]]
    require(isinstance(data["units"], list) and len(data["units"]) == n, "the polytope needs a combination for every unit vector")
    units = [combination(value, len(vectors)) for value in data["units"]]
    rest = max(rest_of([Fraction(int(i == j)) for j in range(n)], terms, vectors) for i, terms in enumerate(units))
    require(rest < 1, "the vectors are not shown to span the space")
    reach = max(sum(map(abs, terms.values())) for terms in units) / (1 - rest)
    require(isinstance(data["images"], list) and len(data["images"]) == len(matrices), "the polytope needs images for each matrix")
    for matrix, images in zip(matrices, data["images"]):
        require(isinstance(images, list) and len(images) == len(vectors), "the polytope needs an image for each vector")
        for vector, value in zip(vectors, images):
            image = [sum((x * y for x, y in zip(row, vector)), Fraction(0)) for row in matrix]
            terms = combination(value, len(vectors))
            require(sum(map(abs, terms.values())) + reach * rest_of(image, terms, vectors) <= bound, "an image is outside")
    return bound


def letters_from(value, matrices):
    require(isinstance(value, list) and 1 <= len(value) <= 100, "a product is a list of letters")
    return [integer(letter, 0, len(matrices) - 1, "a letter") for letter in value]


# One function per kind of certificate: from the data to the statement that they prove ------------------------------------------

def curve_smoothness(data):
    entries(data, ["word", "smoothness", "order", "bound"], "the data")
    arity, _, mask = mask_of(data["word"])
    k, schemes, bound = integer(data["smoothness"], 0, 1000, "smoothness"), all_differences(arity, mask), data["bound"]
    scheme = schemes[integer(data["order"], k + 1, len(schemes) - 1, "the order")]
    if isinstance(bound, dict) and bound.get("kind") == "norm":
        entries(bound, ["kind", "length", "value"], "the bound")
        length = integer(bound["length"], 1, 40, "the length")
        value = arity ** (k * length) * norm(arity, scheme, length)
        require(value == fraction(bound["value"], "the value") and value < 1, "the difference scheme does not contract like this")
    else:
        require(isinstance(bound, dict) and bound.get("kind") == "polytope", "an unknown kind of bound")
        require(arity ** k * polytope_bound(transition(arity, scheme), bound) < 1, "the bound is too large")
    return describe(data["word"]) + (f" is C^{k} on curves" if k else " converges on curves")


def curve_refutation(data):
    entries(data, ["word", "smoothness", "reason"], "the data")
    arity, first, mask = mask_of(data["word"])
    k, schemes, reason = integer(data["smoothness"], 0, 1000, "smoothness"), all_differences(arity, mask), data["reason"]
    if isinstance(reason, dict) and reason.get("kind") == "sum rules":
        entries(reason, ["kind"], "the reason")
        require(len(schemes) - 1 <= k and is_stable(arity, first, mask), "enough sum rules, or not known to be stable")
    else:
        entries(reason, ["kind", "order", "product"], "the reason")
        require(reason["kind"] == "product", "an unknown kind of reason")
        order = integer(reason["order"], 1, len(schemes) - 1, "the order")
        matrices = transition(arity, schemes[order])
        letters = letters_from(reason["product"], matrices)
        if not reaches(matrices, letters, Fraction(1)):
            require(0 < k < order and is_stable(arity, first, mask), "not known to be stable")
            require(reaches(matrices, letters, Fraction(1, arity ** k)), "the product has no such eigenvalue")
    return describe(data["word"]) + (f" is not C^{k} on curves" if k else " does not converge on curves")


def exponent_text(arity, radius):
    whole, rest = 0, radius
    while rest < 1:
        whole, rest = whole + 1, rest * arity
    if rest == 1:
        return str(whole)
    for root in range(2, arity.bit_length()):
        base = round(arity ** (1 / root))
        for k in range(1, root):
            if base ** root == arity and base ** k == rest:
                return str(whole - Fraction(k, root))
    return f"{whole} - log{arity}({rest})"


def curve_regularity(data):
    entries(data, ["word", "upper", "lower"], "the data")
    arity, first, mask = mask_of(data["word"])
    scheme, upper, lower = all_differences(arity, mask)[-1], data["upper"], data["lower"]
    if isinstance(upper, dict) and upper.get("kind") == "norm":
        entries(upper, ["kind", "length", "value", "bound"], "the upper bound")
        length, bound = integer(upper["length"], 1, 40, "the length"), fraction(upper["bound"], "the bound")
        value = norm(arity, scheme, length)
        require(value == fraction(upper["value"], "the value") and 0 < bound, "the norm is another")
        require(value <= bound ** length, "the bound is smaller than the norm allows")
    else:
        require(isinstance(upper, dict) and upper.get("kind") == "polytope", "an unknown kind of upper bound")
        bound = polytope_bound(transition(arity, scheme), upper)
    require(bound < 1, "the bound does not show convergence")
    claim, least = describe(data["word"]) + " has the Hoelder exponent ", exponent_text(arity, bound)
    if lower is None:
        return f"{claim}at least {least} on curves"
    entries(lower, ["product", "value"], "the lower bound")
    require(is_stable(arity, first, mask), "not known to be stable")
    value, matrices = fraction(lower["value"], "the value"), transition(arity, scheme)
    require(value > 0 and reaches(matrices, letters_from(lower["product"], matrices), value), "no such eigenvalue")
    if value == bound:
        return f"{claim}{least} on curves"
    return f"{claim}between {least} and {exponent_text(arity, value)} on curves"


CHECKERS = {
    "curve-smoothness": curve_smoothness,
    "curve-refutation": curve_refutation,
    "curve-regularity": curve_regularity,
}
