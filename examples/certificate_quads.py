"""Meshes for certificates of regularity: the textbook rules of Catmull and Clark in fractions, classes of vertices, nets of patches.

Half-edges are numbered face by face; after a step come the old vertices, then the edge points in order of the first half-edge of
their edges, then the face points. Half-edge h becomes the quad at its corner: vertex, edge point, face point, edge point before.
"""
import math
from fractions import Fraction

from certificate_algebra import CannotCheck, Rejected, entries, fraction, integer, require
from certificate_patches import Net, cross, dot, minus

MOST_FACES = 100000


class Mesh:
    """An oriented manifold, boundary allowed, every vertex in some face; anything else is rejected."""

    def __init__(self, points, faces, corners):
        self.points, self.faces, self.corners = points, faces, corners  # corners: the set of tagged vertices
        require(faces, "the mesh has no face")
        self.start, self.vertex, self.face, self.next, self.prev = [], [], [], [], []
        for f, face in enumerate(faces):
            require(len(set(face)) == len(face), f"face {f} repeats a vertex")
            first, n = len(self.vertex), len(face)
            self.start.append(first)
            self.vertex += face
            self.face += [f] * n
            self.next += [first + (k + 1) % n for k in range(n)]
            self.prev += [first + (k - 1) % n for k in range(n)]
        ends = {}
        for h, v in enumerate(self.vertex):
            require((v, self.tip(h)) not in ends, "two faces run along an edge in the same direction")
            ends[v, self.tip(h)] = h
        self.twin = [ends.get((self.tip(h), v)) for h, v in enumerate(self.vertex)]  # None on the boundary
        self.fans = self.find_fans()

    def tip(self, h):
        return self.vertex[self.next[h]]

    def find_fans(self):
        """Per vertex the half-edges that leave it, counter-clockwise: from the one on the boundary, else from the lowest on."""
        first, count = [None] * len(self.points), [0] * len(self.points)
        for h, v in enumerate(self.vertex):
            count[v] += 1
            if first[v] is None or self.twin[h] is None:
                first[v] = h
        fans = []
        for v, h in enumerate(first):
            require(h is not None, f"vertex {v} is used by no face")
            fan = [h]
            while (h := self.twin[self.prev[h]]) not in (None, fan[0]):
                fan.append(h)
            require(len(fan) == count[v], f"several fans of faces meet in vertex {v}")
            fans.append(fan)
        return fans

    def on_boundary(self, v):
        return self.twin[self.fans[v][0]] is None

    def is_closed(self):
        return None not in self.twin

    def vertex_class(self, v):
        faces = len(self.fans[v])
        if not self.on_boundary(v):
            return "interior" if faces == 4 else "extraordinary"
        if v in self.corners:
            return "corner" if faces == 1 else "tagged"
        return "smooth1" if faces == 1 else "boundary" if faces == 2 else "bextraordinary"


def mesh_from(data):
    entries(data, ["points", "faces", "corners"], "the mesh")
    points, faces, corners = data["points"], data["faces"], data["corners"]
    require(all(isinstance(x, list) for x in (points, faces, corners)) and points, "the mesh must consist of lists")
    if len(points) > 4 * MOST_FACES or len(faces) > MOST_FACES:
        raise CannotCheck("meshes of this size are not checked here")
    require(isinstance(points[0], list) and len(points[0]) in (2, 3) and
            all(isinstance(p, list) and len(p) == len(points[0]) for p in points), "points need two coordinates each, or three")
    exact = [tuple(fraction(x, "a coordinate") for x in p) + (Fraction(0),) * (3 - len(p)) for p in points]
    require(all(isinstance(face, list) and 3 <= len(face) <= 1000 for face in faces), "faces need 3 to 1000 vertices")
    mesh = Mesh(exact, [[integer(v, 0, len(points) - 1, "a vertex") for v in face] for face in faces], set())
    last = -1
    for v in corners:
        last = integer(v, last + 1, len(points) - 1, "a corner (in rising order)")
        require(mesh.on_boundary(v), "corners must be boundary vertices")
        mesh.corners.add(v)
    return mesh


# Catmull and Clark (1978), with cubic B-splines for boundary curves -------------------------------------------------------------

def combined(*terms):
    return tuple(sum(weight * p[c] for weight, p in terms) for c in range(3))


def mean(points):
    return tuple(sum(x) / Fraction(len(points)) for x in zip(*points))


def new_vertex_point(mesh, v, face_points):
    fan, own = mesh.fans[v], mesh.points[v]
    if v in mesh.corners:
        return own
    if mesh.on_boundary(v):
        ends = mesh.points[mesh.tip(fan[0])], mesh.points[mesh.vertex[mesh.prev[fan[-1]]]]
        return combined((Fraction(6, 8), own), *((Fraction(1, 8), p) for p in ends))
    n = len(fan)
    middles = mean([mean([own, mesh.points[mesh.tip(h)]]) for h in fan])
    around = mean([face_points[mesh.face[h]] for h in fan])
    return combined((Fraction(1, n), around), (Fraction(2, n), middles), (Fraction(n - 3, n), own))


def refine(mesh):
    face_points = [mean([mesh.points[v] for v in face]) for face in mesh.faces]
    edge_points, edge = [], []
    for h, (v, twin) in enumerate(zip(mesh.vertex, mesh.twin)):
        if twin is not None and twin < h:
            edge.append(edge[twin])
            continue
        edge.append(len(edge_points))
        ends = [mesh.points[v], mesh.points[mesh.tip(h)]]
        edge_points.append(mean(ends if twin is None else ends + [face_points[mesh.face[h]], face_points[mesh.face[twin]]]))
    olds, edges = len(mesh.points), len(edge_points)
    points = [new_vertex_point(mesh, v, face_points) for v in range(olds)] + edge_points + face_points
    faces = [[v, olds + edge[h], olds + edges + mesh.face[h], olds + edge[mesh.prev[h]]] for h, v in enumerate(mesh.vertex)]
    return Mesh(points, faces, mesh.corners)


def flattened(points):
    """Points of a plane but not of a line in coordinates of the plane, x along p, from the first point to the next, and y along q; others as they are.
    An affine map: refinement commutes with it, and whether the surface is regular does not depend on it."""
    offsets = [minus(x, points[0]) for x in points]
    p = next(filter(any, offsets), (0, 0, 0))
    normal = next(filter(any, (cross(p, x) for x in offsets)), (0, 0, 0))
    if all(x[2] == 0 for x in points) or not any(normal) or any(dot(normal, x) for x in offsets):
        return points
    q = cross(normal, p)
    return [(dot(x, p), dot(x, q), Fraction(0)) for x in offsets]


# What covers the faces ------------------------------------------------------------------------------------------------------------

class Covered:
    """The mesh after exact steps, with integer points up to one scale, its patches, and what else covers faces."""

    def __init__(self, data):
        mesh = mesh_from(data["mesh"])
        self.mode, self.steps = data["mode"], integer(data["steps"], 0, 6, "the steps")
        require(self.mode in ("interior", "bspline"), "the mode must be interior or bspline")
        require(self.steps == 0 or self.mode == "bspline" or mesh.is_closed(), "mode interior has no rule for boundaries")
        if len(mesh.vertex) * 4 ** max(self.steps - 1, 0) > MOST_FACES:
            raise CannotCheck("meshes of this size are not checked here")
        mesh.points = flattened(mesh.points)
        for _ in range(self.steps):
            mesh = refine(mesh)
        self.mesh = mesh
        require(all(len(face) == 4 for face in mesh.faces), "a face is no quad")
        self.classes = [mesh.vertex_class(v) for v in range(len(mesh.points))]
        self.scale_points()
        self.is_planar = all(p[2] == 0 for p in self.points)
        kinds = [self.kind(face) for face in mesh.faces]
        self.patches = [f for f, kind in enumerate(kinds) if kind == "patch"]
        self.rings = [v for v, name in enumerate(self.classes) if name == "extraordinary" and self.is_isolated(v)]
        ringed = set(self.rings)
        self.uncovered = [f for f, kind in enumerate(kinds) if kind == "excluded" and not ringed & set(mesh.faces[f])]
        self.blamed = {v for f in self.uncovered for v in mesh.faces[f]
                       if self.classes[v] not in ("interior", "boundary", "corner")}

    def scale_points(self):
        scale = 1
        for p in self.mesh.points:
            scale = math.lcm(scale, *(x.denominator for x in p))
            if scale.bit_length() > 10000:
                raise CannotCheck("coordinates with so many different denominators are not checked here")
        self.points = [tuple(int(x * scale) for x in p) for p in self.mesh.points]

    def kind(self, face):
        names = {self.classes[v] for v in face}
        if names <= ({"interior"} if self.mode == "interior" else {"interior", "boundary", "corner"}):
            return "patch"
        return "excluded" if self.mode == "bspline" or "extraordinary" in names else "outside"

    def is_isolated(self, v):
        """All other corners of the faces at v are inside and of valence 4, so that all rings around v but v are regular."""
        return all(self.classes[w] == "interior" for h in self.mesh.fans[v] for w in self.mesh.faces[self.mesh.face[h]] if w != v)

    def groups(self):
        """Per patch face a name of its group: patches connected through vertices, where regular surfaces have a tangent plane."""
        group, patches = {}, set(self.patches)
        for start in self.patches:
            reached = [start] if start not in group else []
            while reached:
                f = reached.pop()
                if f not in group:
                    group[f] = start
                    reached += [self.mesh.face[h] for v in self.mesh.faces[f] for h in self.mesh.fans[v]
                                if self.mesh.face[h] in patches]
        return group

    def net(self, f):
        """Rows along v, columns along u, the four corners of the face inside. At every corner the walk across its side finds the
        outer points of this side and the diagonal point; missing rows and columns are reflections."""
        mesh, points, rows = self.mesh, self.points, [[None] * 4 for _ in range(4)]
        sides = [((1, 1), (0, 1), (0, 2), (0, 0)), ((1, 2), (1, 3), (2, 3), (0, 3)),
                 ((2, 2), (3, 2), (3, 1), (3, 3)), ((2, 1), (2, 0), (1, 0), (3, 0))]
        flags = []
        for h, (corner, first, second, diagonal) in enumerate(sides, mesh.start[f]):
            across = mesh.twin[h]
            flags.append(across is None)
            found = {corner: mesh.vertex[h]}
            if across is not None:
                away = mesh.next[across]
                found[first], found[second] = mesh.tip(away), mesh.vertex[mesh.prev[across]]
                if mesh.twin[away] is not None:
                    found[diagonal] = mesh.tip(mesh.next[mesh.next[mesh.twin[away]]])
            for (i, j), v in found.items():
                rows[i][j] = points[v]
        bottom, right, top, left = flags
        for row in rows[bottom:4 - top]:
            if left:
                row[0] = reflected(row[1], row[2])
            if right:
                row[3] = reflected(row[2], row[1])
        if bottom:
            rows[0] = list(map(reflected, rows[1], rows[2]))
        if top:
            rows[3] = list(map(reflected, rows[2], rows[1]))
        if any(p is None for row in rows for p in row):
            raise Rejected("a patch has no complete net")
        return Net(rows, tuple(flags))


def reflected(first, second):
    return tuple(2 * a - b for a, b in zip(first, second))
