"""One round of a word near a vertex or face of any valence, on an endless quad or triangle lattice with one exceptional point.

A place is (sector, x, y) in half steps of the lattice: x > 0 along the spoke that begins the sector, y >= 0 along the next spoke;
the centre is (0, 0, 0). The refined mesh has its vertices at even places and its faces at odd ones. An old point that was called
p is the refined vertex 2p; so old points are even themselves around a vertex, and odd around a face (which is a vertex after U).
The places of a plane, a lattice without exception, all have sector 0.
"""
from fractions import Fraction

from certificate_algebra import CannotCheck, Rejected, entries, integer, require
from certificate_enclosures import number

CENTRE = (0, 0, 0)
AROUND = {False: [(2, 0), (0, 2), (-2, 0), (0, -2)], True: [(2, 0), (0, 2), (-2, 2), (-2, 0), (0, -2), (2, -2)]}


class Lattice:
    def __init__(self, valence, triangles, dual):
        self.valence, self.triangles, self.dual = valence, triangles, dual  # valence None: the plane
        self.regular = 6 if triangles else 4

    def fold(self, s, x, y):
        """The name of the point at (x, y) in the frame of sector s."""
        if self.valence is None:
            return s, x, y
        while x <= 0 or y < 0:
            if x == y == 0:
                return CENTRE
            if y < 0:
                s, x, y = s - 1, -y, x + y if self.triangles else x
            else:
                s, x, y = s + 1, x + y if self.triangles else y, -x
        return s % self.valence, x, y

    def is_centre(self, place):
        return self.valence is not None and place == CENTRE

    def shifted(self, place, steps):
        s, x, y = place
        return [self.fold(s, x + dx, y + dy) for dx, dy in steps]

    def every_sector(self, x, y):
        return [(s, x, y) for s in range(self.valence)]

    def neighbours(self, vertex):
        return self.every_sector(2, 0) if self.is_centre(vertex) else self.shifted(vertex, AROUND[self.triangles])

    def faces(self, vertex):
        return self.every_sector(1, 1) if self.is_centre(vertex) else self.shifted(vertex, [(1, 1), (-1, 1), (-1, -1), (1, -1)])

    def corners(self, face):
        return self.shifted(face, [(1, 1), (-1, 1), (-1, -1), (1, -1)])

    def parents(self, vertex):
        """The old points (as refined vertices) whose mean U puts at a vertex: one, the two of an edge, or those of a face."""
        odd = 1 if self.dual else 0
        x, y = (vertex[1] // 2 + odd) % 2, (vertex[2] // 2 + odd) % 2
        if (x, y) == (0, 0):
            return [vertex]
        if self.is_centre(vertex):
            return self.every_sector(2, 2)
        if self.triangles:
            return self.shifted(vertex, {(1, 0): [(2, 0), (-2, 0)], (0, 1): [(0, 2), (0, -2)], (1, 1): [(2, -2), (-2, 2)]}[x, y])
        return self.shifted(vertex, [(dx, dy) for dx in ([2, -2] if x else [0]) for dy in ([2, -2] if y else [0])])

    def radius(self, place):
        return place[1] + place[2] if self.triangles else max(place[1], place[2])

    def rotated(self, place, sectors):
        return place if place == CENTRE else ((place[0] + sectors) % self.valence, place[1], place[2])

    def mirrored(self, place):
        return self.fold(-place[0] - 1, place[2], place[1])

    def orbits(self, radius):
        first = 1 if self.dual else 0
        places = [(0, x, y) for x in range(2 - first, radius + 1, 2) for y in range(first, radius + 1, 2)]
        return [place for place in places if self.radius(place) <= radius]


# Words ----------------------------------------------------------------------------------------------------------------------------

def check_word(word, valence):
    """Exactly one U[2], at the beginning; parameters as numbers, delta at the valences that count."""
    entries(word, ["triangles", "items"], "the word")
    require(list(word) == ["triangles", "items"] and type(word["triangles"]) is bool, "the word is not as it should be")
    items = word["items"]
    require(isinstance(items, list) and 1 <= len(items) <= 200, "the word needs a list of items")
    regular = 6 if word["triangles"] else 4
    averages = 0
    for k, item in enumerate(items):
        require(isinstance(item, dict) and item.get("atom") in ("U", "D", "C", "P"), f"item {k} is no atom")
        names = {"U": ["sections"], "D": ["f"], "C": ["f", "ngon"], "P": ["omega", "omega_face", "delta"]}[item["atom"]]
        require(list(item) == ["atom"] + names, f"item {k} needs the entries atom, {', '.join(names)}")
        require((item["atom"] == "U") == (k == 0), "a round needs one U, at its beginning")
        if item["atom"] == "U":
            integer(item["sections"], 2, 2, "the section number")
        elif item["atom"] == "P":
            require(averages % 2 == 0, "P where the points are dual")
        else:
            require(item["atom"] == "C" or not word["triangles"], "D on triangles")
            require(number(item["f"], f"f of item {k}") == 1 or averages % 2 == 0, "an f that does not act")
            require(item.get("ngon", "dual") in ("dual", "classic"), "an unknown rule for n-gons")
            averages += 1 if item["atom"] == "D" else 2
    dual = averages % 2 == 1
    for item in items:
        if item["atom"] == "P":
            number(item["omega"], "omega")
            if item["omega_face"] is not None:
                number(item["omega_face"], "omega@face")
            wanted = [regular] if dual or valence == regular else sorted([valence, regular])
            require(isinstance(item["delta"], dict) and list(item["delta"]) == [str(n) for n in wanted],
                    "delta must have the valences that count")
            for value in item["delta"].values():
                number(value, "delta")
    return dual


def describe(word):
    pushes = sum(item["atom"] == "P" for item in word["items"])
    atoms, parameters, averages = [], [], 0
    for item in word["items"]:
        own = ["ngon = classic"] if item.get("ngon") == "classic" else []
        if item.get("f", "1") != "1":
            (parameters if averages == 0 else own).append(f"f = {number(item['f'], 'f')}")
        averages += item["atom"] in "CD"
        if item["atom"] == "P":
            texts = parameters if pushes == 1 else own
            texts.append(f"omega = {number(item['omega'], 'omega')}")
            if item["omega_face"] is not None:
                texts.append(f"omega@face = {number(item['omega_face'], 'omega@face')}")
            values = {n: str(number(value, "delta")) for n, value in item["delta"].items()}
            if len(set(values.values())) == 1:
                texts.append(f"delta = {list(values.values())[0]}")
            else:
                texts += [f"delta({n}) = {text}" for n, text in values.items()]
        atoms.append(item["atom"] + (f"[{', '.join(own)}]" if own else ""))
    return (f"({' '.join(atoms)})*" + (" on triangles" if word["triangles"] else "") +
            (" where " + ", ".join(parameters) if parameters else ""))


# Atoms: each gives the function from places to rows {old place: weight}, from that of the atom before ------------------------------

def combined(terms):
    result = {}
    for weight, row in terms:
        for place, value in row.items():
            result[place] = result.get(place, 0) + weight * value
    return {place: value for place, value in result.items() if value != 0}


def mean(rows):
    return combined((Fraction(1, len(rows)), row) for row in rows)


def weighted_mean(pairs):
    whole = sum((weight for weight, _ in pairs), Fraction(0))
    if whole == 0:
        raise Rejected("the weights of an average sum to zero")
    return combined((weight / whole, row) for weight, row in pairs)


def remembered(function):
    known = {}

    def at(place):
        if place not in known:
            known[place] = function(place)
        return known[place]
    return at


class Round:
    """row(place): the weights of the old points in a point after one round; reach: how far (half steps) from 2p old points p act."""

    def __init__(self, word, lattice):
        self.lattice, self.reach = lattice, 2
        self.row, self.averages = remembered(self.split), 0
        for item in word["items"][1:]:
            if item["atom"] == "P":
                self.push_back(item)
            elif word["triangles"]:
                self.convolve_triangles(number(item["f"], "f"))
            else:
                self.average(item)
                if item["atom"] == "C":
                    self.average({"atom": "D", "f": "1"})
            if self.reach > 16:
                raise CannotCheck("a round that reaches so far is not checked here")

    def split(self, vertex):
        parents = self.lattice.parents(vertex)
        return {(s, x // 2, y // 2): Fraction(1, len(parents)) for s, x, y in parents}

    def average(self, item):
        before, lattice, f = self.row, self.lattice, number(item["f"], "f")
        if self.averages % 2 == 1:
            self.row = remembered(lambda vertex: mean([before(face) for face in lattice.faces(vertex)]))
        else:
            weights = {1: f * f, 2: f, 4: Fraction(1)}  # by the number of parents; all faces have four corners after U

            def at_face(face):
                corners = lattice.corners(face)
                return weighted_mean([(weights.get(len(lattice.parents(v)), Fraction(1)), before(v)) for v in corners])
            self.row = remembered(at_face)
        if item.get("ngon") == "classic" and self.averages == 0 and lattice.dual and lattice.valence not in (None, 4):
            self.classic = (before, f)  # the edges of the n-gon, at the end of this C
        elif self.averages == 1 and getattr(self, "classic", None):
            smooth, (points, f) = self.row, self.classic

            def at_vertex(vertex):
                if vertex[1:] != (2, 0):
                    return smooth(vertex)
                ends = lattice.shifted(vertex, [(-2, 0), (2, 0)])
                return weighted_mean([(Fraction(1), points(face)) for face in ends] + [(2 * f, points(vertex))])
            self.row = remembered(at_vertex)
        self.averages += 1
        self.reach += 1

    def convolve_triangles(self, f):
        before, lattice = self.row, self.lattice

        def weight(vertex):
            return f if len(lattice.parents(vertex)) == 1 else Fraction(1)

        def at(vertex):
            ring = lattice.neighbours(vertex)
            share = Fraction(6, len(ring))
            return weighted_mean([(2 * weight(vertex), before(vertex))] + [(share * weight(u), before(u)) for u in ring])
        self.row = remembered(at)
        self.averages += 2
        self.reach += 2

    def push_back(self, item):
        before, lattice = self.row, self.lattice
        delta = {int(n): number(value, "delta") for n, value in item["delta"].items()}
        omega = number(item["omega"], "omega")
        omega_face = omega * omega if item["omega_face"] is None else number(item["omega_face"], "omega@face")

        def difference(vertex):
            s, x, y = vertex
            d = delta[lattice.valence if lattice.is_centre(vertex) else lattice.regular]
            return combined([(d, {(s, x // 2, y // 2): Fraction(1)}), (-d, before(vertex))])
        difference = remembered(difference)

        def at(vertex):
            parents = lattice.parents(vertex)
            factor = Fraction(1) if len(parents) == 1 else omega if is_on_edge(lattice, vertex) else omega_face
            if factor == 0:
                return before(vertex)
            return combined([(Fraction(1), before(vertex))] + [(factor / len(parents), difference(v)) for v in parents])
        self.row = remembered(at)
        if omega != 0 or omega_face != 0:  # old points are four half steps apart, so in them less may act
            self.reach = max(self.reach, 2 + self.reach // 4 * 4)


def is_on_edge(lattice, vertex):
    """Of the vertices that are no old points: the edge points, in contrast to the face points (the centre has n parents)."""
    return len(lattice.parents(vertex)) == 2 and not lattice.is_centre(vertex)
