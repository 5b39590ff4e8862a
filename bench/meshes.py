"""Meshes of the comparison, made by formulas; a mesh is (points, faces), faces as tuples of vertex numbers counted from 0."""
import math
import random
from pathlib import Path


def read_obj(path):
    points, faces = [], []
    for line in Path(path).read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(float(x) for x in words[1:4]))
        elif words[:1] == ["f"]:
            faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    return points, faces


def write_obj(path, mesh):
    points, faces = mesh
    lines = ["v %r %r %r" % p for p in points] + ["f " + " ".join(str(v + 1) for v in f) for f in faces]
    Path(path).write_text("\n".join(lines) + "\n")


def cube():
    points = [(x, y, z) for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]
    return points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    points = [p for a in (-1.0, 1.0) for b in (-g, g) for p in ((0.0, a, b), (a, b, 0.0), (b, 0.0, a))]
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                sides = [math.dist(points[u], points[v]) for u, v in ((i, j), (j, k), (i, k))]
                if max(sides) < 2.1:
                    faces.append((i, j, k) if volume(points, i, j, k) > 0 else (i, k, j))
    return points, faces


def volume(points, i, j, k):
    (a, b, c), (d, e, f), (g, h, m) = points[i], points[j], points[k]
    return a * (e * m - f * h) - b * (d * m - f * g) + c * (d * h - e * g)


def icosphere(n):
    """Every edge of an icosahedron in n parts: 20 n^2 triangles, all vertices of valence 6 but the twelve of valence 5."""
    corners, faces = icosahedron()
    points, number, triangles = [], {}, []

    def vertex(weights):  # the same corners and weights are the same point, from whichever face they come
        key = tuple(sorted((v, w) for v, w in weights if w))
        if key not in number:
            number[key] = len(points)
            p = [sum(corners[v][c] * w for v, w in key) for c in range(3)]
            length = math.hypot(*p)
            points.append(tuple(bump(p, length)[c] for c in range(3)))
        return number[key]

    for a, b, c in faces:
        at = {(i, j): vertex(((a, n - i - j), (b, i), (c, j))) for i in range(n + 1) for j in range(n + 1 - i)}
        for i in range(n):
            for j in range(n - i):
                triangles.append((at[i, j], at[i + 1, j], at[i, j + 1]))
                if i + j < n - 1:
                    triangles.append((at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]))
    return points, triangles


def bump(p, length):
    """Off the sphere, so that no two faces have the same shape."""
    x, y, z = (c / length for c in p)
    r = 1 + 0.1 * math.sin(3 * x + 1) * math.cos(4 * y) + 0.05 * math.sin(5 * z + 2 * x)
    return x * r, y * r, z * r


def centre(points, face):
    return tuple(sum(points[v][c] for v in face) / len(face) for c in range(3))


def split_into_quads(mesh):
    """A face of n corners becomes n quads around a vertex of valence n: of triangles, every quad has a vertex of valence 3."""
    points, faces = list(mesh[0]), []
    middle = {}
    for face in mesh[1]:
        n = len(face)
        for u, v in zip(face, face[1:] + face[:1]):
            key = (min(u, v), max(u, v))
            if key not in middle:
                middle[key] = len(points)
                points.append(centre(points, key))
        hub = len(points)
        points.append(centre(points, face))
        for k in range(n):
            before, v, after = face[k - 1], face[k], face[(k + 1) % n]
            faces.append((v, middle[min(v, after), max(v, after)], hub, middle[min(v, before), max(v, before)]))
    return points, faces


def split_at_centres(mesh):
    """A vertex inside every triangle: each of the new triangles has a vertex of valence 3."""
    points, faces = list(mesh[0]), []
    for a, b, c in mesh[1]:
        hub = len(points)
        points.append(centre(points, (a, b, c)))
        faces += [(a, b, hub), (b, c, hub), (c, a, hub)]
    return points, faces


def flip_edges(mesh, share, seed=1):
    """Turns a share of the edges of a triangle mesh, at random: valences from 3 to 9, hardly two neighbourhoods alike."""
    points, faces = mesh[0], [tuple(f) for f in mesh[1]]
    rng = random.Random(seed)
    valence = [0] * len(points)
    opposite = {}  # half-edge (u, v): its face
    for f, face in enumerate(faces):
        for k in range(3):
            opposite[face[k], face[(k + 1) % 3]] = f
            valence[face[k]] += 1
    edges = sorted((u, v) for u, v in opposite if u < v)
    for u, v in rng.sample(edges, int(share * len(edges))):
        if (u, v) not in opposite or (v, u) not in opposite:
            continue  # turned away by an earlier flip
        left, right = opposite[u, v], opposite[v, u]
        p = next(w for w in faces[left] if w not in (u, v))
        q = next(w for w in faces[right] if w not in (u, v))
        if (p, q) in opposite or (q, p) in opposite or min(valence[u], valence[v]) < 4 or max(valence[p], valence[q]) > 8:
            continue
        del opposite[u, v], opposite[v, u]
        faces[left], faces[right] = (p, q, v), (q, p, u)
        opposite.update({(p, q): left, (q, v): left, (v, p): left, (q, p): right, (p, u): right, (u, q): right})
        for w, change in ((u, -1), (v, -1), (p, 1), (q, 1)):
            valence[w] += change
    return points, faces


def torus(m, n):
    """m times n quads, all vertices of valence 4."""
    points = []
    for i in range(m):
        for j in range(n):
            s, t = 2 * math.pi * i / m, 2 * math.pi * j / n
            r = 1 + 0.1 * math.sin(3 * s) * math.cos(2 * t)
            points.append(((3 + r * math.cos(t)) * math.cos(s), (3 + r * math.cos(t)) * math.sin(s), r * math.sin(t)))
    number = lambda i, j: (i % m) * n + j % n
    faces = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)) for i in range(m) for j in range(n)]
    return points, faces


def make_all(root, folder):
    """Writes every mesh of the comparison as OBJ; returns name -> (path, (vertices, corners, faces))."""
    shipped = Path(root) / "tests" / "data"
    blub, spot = read_obj(shipped / "meshes" / "blub_control.obj"), read_obj(shipped / "offset" / "spot188.obj")
    meshes = {
        "ico_quads": split_into_quads(icosphere(13)),
        "flipped_quads": split_into_quads(flip_edges(icosphere(13), 0.5)),
        "torus": torus(102, 100),
        "icosphere": icosphere(22),
        "ico_hubs": split_at_centres(icosphere(13)),
        "flipped": flip_edges(icosphere(22), 0.5),
        "cube": cube(),
        "blub_1776": split_into_quads(split_into_quads(blub)),
        "spot_1116": split_into_quads(spot),
        "spot": read_obj(Path(root) / "examples" / "spot_control.obj"),
    }
    Path(folder).mkdir(parents=True, exist_ok=True)
    written = {}
    for name, mesh in meshes.items():
        path = Path(folder) / (name + ".obj")
        write_obj(path, mesh)
        written[name] = (path, (len(mesh[0]), sum(map(len, mesh[1])), len(mesh[1])))
    return written
