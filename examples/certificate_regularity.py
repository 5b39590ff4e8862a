"""Certificates about whole Catmull-Clark surfaces: regular, as patches and rings of patches cover them, or not, by points.

The mesh is refined by the textbook rules; nets, differences and coefficients are made from it again. All signs are exact, but for
the inequality that ends the rings around a vertex, which is in enclosures.
"""
import json

from certificate_algebra import entries, fraction, integer, require
from certificate_patches import check_patch, check_separation, cross, minus
from certificate_quads import Covered
from certificate_vertex_rings import MOST_LEVELS, VertexRings


def fnv(text):
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 % 2 ** 64
    return f"{value:016x}"


def counted(n, one, many):
    return f"{n} {one if n == 1 else many}"


def surface_name(data):
    mesh = data["mesh"]
    return (f"the Catmull-Clark surface of the mesh with {counted(len(mesh['points']), 'vertex', 'vertices')} and "
            f"{counted(len(mesh['faces']), 'face', 'faces')} (digest {fnv(json.dumps(mesh, separators=(',', ':')))})" +
            (", over the faces without boundary vertices," if data["mode"] == "interior" else ""))


# Regular --------------------------------------------------------------------------------------------------------------------------

def check_rings(covered, records):
    require(isinstance(records, list) and len(records) == len(covered.rings), "rings must have an entry per isolated vertex")
    for v, record in zip(covered.rings, records):
        entries(record, ["vertex", "level", "rings"], "an entry of rings")
        require(integer(record["vertex"], 0, len(covered.points), "the vertex") == v, "the vertices of rings must be in order")
        level, lists = integer(record["level"], 0, MOST_LEVELS, "the level"), record["rings"]
        require(isinstance(lists, list) and len(lists) == level, "a vertex needs a list per ring")
        rings = VertexRings(covered, v)
        rings.check_closing(level)
        for number, patches in enumerate(lists, 1):
            nets = rings.nets(number)
            require(isinstance(patches, list) and len(patches) == len(nets), "a ring needs a list per patch")
            for net, leaves in zip(nets, patches):
                check_patch(net, leaves, covered.is_planar)


def edges_in_frame(mesh):
    """All edges as differences along u and v of one frame, carried from face to face."""
    turns, unseen = {0: 0}, [0]  # per face the side along +u
    for f in unseen:
        for side in range(4):
            across = mesh.twin[mesh.start[f] + side]
            if across is not None:
                g = mesh.face[across]
                wanted = (across - mesh.start[g] + 2 - side + turns[f]) % 4  # a shared side runs the other way round
                if g not in turns:
                    turns[g] = wanted
                    unseen.append(g)
                require(turns[g] == wanted, "the faces have no common frame")
    require(len(turns) == len(mesh.faces), "the mesh is not connected")
    result = [], []
    for h, v in enumerate(mesh.vertex):
        turn = (h - mesh.start[mesh.face[h]] - turns[mesh.face[h]]) % 4
        along = minus(mesh.points[mesh.tip(h)], mesh.points[v])
        result[turn % 2].append(along if turn < 2 else minus((0, 0, 0), along))
    return result


def check_global(covered, data):
    """A connected surface of quads with regular vertices only and four corners has the Euler number 1 and is a rectangle; with
    n and m for all edges, two of its points differ by a combination of u and v that is not zero."""
    entries(data, ["n", "m"], "global")
    names = covered.classes
    require(covered.steps == 0 and covered.mode == "bspline" and set(names) <= {"interior", "boundary", "corner"} and
            names.count("corner") == 4, "global is only for rectangles of quads")
    check_separation(data, *edges_in_frame(covered.mesh))


def regular_surface(data):
    entries(data, ["mesh", "mode", "steps", "except_uncovered", "patches", "rings", "global"], "the data")
    covered = Covered(data)
    patches, blamed = data["patches"], covered.blamed
    require(type(data["except_uncovered"]) is bool and data["except_uncovered"] == bool(covered.uncovered),
            "except_uncovered must say whether faces are left out")
    require(covered.patches or covered.rings, "the mesh has no patch")
    require(all(map(covered.mesh.on_boundary, blamed)), "faces around a vertex inside are left out")
    require(isinstance(patches, list) and len(patches) == len(covered.patches), "patches must have an entry per patch")
    for f, leaves in zip(covered.patches, patches):
        check_patch(covered.net(f), leaves, covered.is_planar)
    check_rings(covered, data["rings"])
    text = surface_name(data) + " is regular"
    if covered.uncovered:
        text += (f" except perhaps on {counted(len(covered.uncovered), 'face', 'faces')} of level {covered.steps} around "
                 f"{counted(len(blamed), 'boundary vertex', 'boundary vertices')}")
    if data["global"] is not None:
        check_global(covered, data["global"])
        text += " and does not meet itself"
    return text


# Not regular ----------------------------------------------------------------------------------------------------------------------

def normal_at(net, data):
    u, v = (fraction(data[name], name) for name in ("u", "v"))
    for x in (u, v):
        require(0 <= x <= 1 and 2 ** 60 % x.denominator == 0, "u and v must be dyadic fractions in [0, 1]")
    return cross(*net.derivatives(u, v))


def irregular_surface(data):
    """At one point S_u x S_v is zero; or the Jacobian of a plane surface has two signs on one connected part and so a zero."""
    entries(data, ["mesh", "mode", "steps", "ring", "points"], "the data")
    covered, points = Covered(data), data["points"]
    if data["ring"] is None:
        groups = covered.groups()
    else:
        entries(data["ring"], ["vertex", "ring"], "the ring")
        rings = VertexRings(covered, integer(data["ring"]["vertex"], 0, len(covered.points) - 1, "the vertex"))
        nets = rings.nets(integer(data["ring"]["ring"], 1, MOST_LEVELS, "the ring"))
        groups = dict.fromkeys(range(len(nets)))
    require(isinstance(points, list) and len(points) in (1, 2), "one or two points are needed")
    normals, parts = [], set()
    for point in points:
        entries(point, ["face", "u", "v"], "a point")
        face = integer(point["face"], 0, len(covered.mesh.faces) * 100, "the face")
        require(face in groups, "a face of the points is no patch")
        normals.append(normal_at(covered.net(face) if data["ring"] is None else nets[face], point))
        parts.add(groups[face])
    if len(points) == 1:
        require(not any(normals[0]), "S_u x S_v is not zero at the point")
    else:
        require(covered.is_planar and len(parts) == 1, "two points refute in the plane and on one connected part only")
        require(normals[0][2] * normals[1][2] < 0, "the Jacobian does not change its sign")
    return surface_name(data) + " is not regular"


CHECKERS = {"regular-surface": regular_surface, "irregular-surface": irregular_surface}
