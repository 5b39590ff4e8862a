"""What compare.py measures: the groups of measurements that take turns, and the rows of the table, with what each one demands."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Spec:
    """One measurement; the ways of a program are said at the top of its file in bench/peers."""
    program: str
    mesh: str
    rounds: int
    way: str = "cold"
    real: str = "float"
    scheme: str = "catmull_clark"
    threads: int = 1
    corners: bool = True  # of a floor: whether the corners of the faces belong to the output


@dataclasses.dataclass(frozen=True)
class Row:
    """A ratio: other over ours (faster), or ours over other (at most)."""
    text: str
    ours: Spec
    other: Spec
    wanted: float = 0
    aim: float = 0
    faster: bool = True
    key: str = "seconds"
    other_key: str = ""
    compare: bool = True

    def __post_init__(self):
        object.__setattr__(self, "other_key", self.other_key or self.key)

    def meets(self, ratio):
        return not self.wanted or (ratio >= self.wanted if self.faster else ratio <= self.wanted)

    def wanted_text(self):
        return "" if not self.wanted else f"{'at least' if self.faster else 'at most'} {self.wanted:g}"

    def aim_text(self):
        return f"{self.aim:g}" if self.aim else ""


def output_bytes(spec, counts):
    """Bytes of a result as flat arrays, for a closed mesh of (vertices, corners, faces): Euler's formula gives the vertices."""
    vertices, corners, faces = counts
    euler = vertices - corners // 2 + faces
    triangles = spec.scheme == "loop"
    refined = faces * 4**spec.rounds if triangles else corners * 4**(spec.rounds - 1)
    points = euler + (refined // 2 if triangles else refined)
    return points * 3 * (4 if spec.real == "float" else 8) + (refined * (3 if triangles else 4) * 4 if spec.corners else 0)


def cold(program, mesh, rounds, **more):
    return Spec(program, mesh, rounds, **more)


def everyone(mesh, rounds, **more):
    return [cold(program, mesh, rounds, **more) for program in ("ours", "opensubdiv", "cgal", "openmesh")]


def cold_pair(mesh, rounds, **more):
    return everyone(mesh, rounds, **more)[:2]


def warm_pair(mesh, rounds, **more):
    return [Spec("ours", mesh, rounds, "warm", **more), Spec("opensubdiv", mesh, rounds, "levels", **more)]


def general_pair(scheme, mesh):
    """A plan and the general path, which always works in double."""
    return [Spec("ours", mesh, 4, way, "double", scheme) for way in ("cold", "general")]


UCCP = {"scheme": "uccp"}
LOOP = {"scheme": "loop"}
OURS, OSD = cold("ours", "ico_quads", 5), cold("opensubdiv", "ico_quads", 5)
DOUBLE, GENERAL = cold("ours", "ico_quads", 5, real="double"), Spec("ours", "ico_quads", 5, "general", "double")
FRESH, HUGE = Spec("floors", "ico_quads", 5, "fresh"), Spec("floors", "ico_quads", 5, "fresh_huge")
OURS_UCCP, OURS_TWO = cold("ours", "ico_quads", 5, **UCCP), cold("ours", "ico_quads", 5, threads=2)
WARM, TABLE = warm_pair("ico_quads", 4)
WARM_DOUBLE, TABLE_DOUBLE = warm_pair("ico_quads", 4, real="double")
EVALUATOR = Spec("opensubdiv", "ico_quads", 4, "evaluator")
WARM_UCCP = Spec("ours", "ico_quads", 4, "warm", **UCCP)
WARM_5, WARM_5_TWO = Spec("ours", "ico_quads", 5, "warm"), Spec("ours", "ico_quads", 5, "warm", threads=2)
TRIAD = Spec("floors", "ico_quads", 5, "triad", corners=False)
SPOT = cold("ours", "spot", 6)
LOOP_MESHES = ("icosphere", "ico_hubs", "flipped")
OTHER_WORDS = (("uccp", "flipped_quads"), ("loop", "flipped"))
SMALL = (("cube", 5), ("blub_1776", 2), ("spot_1116", 2))

GROUPS = [
    ("cold", [*everyone("ico_quads", 5), OURS_UCCP, OURS_TWO, FRESH, HUGE]),
    ("double", [*everyone("ico_quads", 5, real="double"), GENERAL]),
    ("general", [spec for name, mesh in OTHER_WORDS for spec in general_pair(name, mesh)]),
    ("torus", [*everyone("torus", 5)]),
    ("flipped", cold_pair("flipped_quads", 5)),
    ("warm", [WARM, TABLE, EVALUATOR, WARM_UCCP, WARM_DOUBLE, TABLE_DOUBLE, WARM_5, WARM_5_TWO, TRIAD]),
    ("loop", [*everyone("icosphere", 5, **LOOP), *(spec for mesh in LOOP_MESHES[1:] for spec in cold_pair(mesh, 5, **LOOP))]),
    ("loop_warm", [spec for mesh in LOOP_MESHES for spec in warm_pair(mesh, 5, **LOOP)]),
    ("small", [spec for mesh, rounds in SMALL for spec in cold_pair(mesh, rounds)]),
    ("spot", [*everyone("spot", 6)]),
]


def against(text, specs, *wanted):
    """Ours, the first of the specs, against each of the others; what is demanded holds for OpenSubdiv, the fastest of them."""
    names = {"opensubdiv": "OpenSubdiv", "cgal": "CGAL", "openmesh": "OpenMesh"}
    return [Row(f"{text}, against {names[other.program]}", specs[0], other, *(wanted if other.program == "opensubdiv" else ()))
            for other in specs[1:]]


def loop_rows():
    for mesh in LOOP_MESHES:
        specs = everyone(mesh, 5, **LOOP) if mesh == "icosphere" else cold_pair(mesh, 5, **LOOP)
        yield from against(f"Loop cold, float, {mesh}", specs, 5, 10)
    for mesh in LOOP_MESHES:
        yield Row(f"Loop warm, float, {mesh}, against OpenSubdiv's table by levels, 4 floats", *warm_pair(mesh, 5, **LOOP), 4, 8)


def small_rows():
    for mesh, rounds in SMALL:
        yield from against(f"small: {mesh}, {rounds} rounds, cold", cold_pair(mesh, rounds), 1, 2)


ROWS = [
    *against("Catmull-Clark cold, float, 10.4 M quads", everyone("ico_quads", 5), 6, 12),
    *against("Catmull-Clark cold, double, 10.4 M quads", everyone("ico_quads", 5, real="double"), 5, 8),
    *against("Catmull-Clark cold, float, regular torus", everyone("torus", 5)),
    *against("Catmull-Clark cold, float, random valences", cold_pair("flipped_quads", 5)),
    Row("Catmull-Clark warm, float, 2.6 M vertices, against OpenSubdiv's table by levels, 4 floats", WARM, TABLE, 6, 14),
    Row("the same, against that table in Osd::CpuEvaluator", WARM, EVALUATOR, 6, 14),
    Row("the same in double, against its table in double", WARM_DOUBLE, TABLE_DOUBLE),
    *loop_rows(),
    Row("(UCCP)* with omega = 1 cold, over our Catmull-Clark", OURS_UCCP, OURS, 2.5, 1.5, faster=False, compare=False),
    Row("(UCCP)* with omega = 1 warm, over our Catmull-Clark", WARM_UCCP, WARM, 2.5, 1.5, faster=False, compare=False),
    Row("warm float, 5 rounds, over the triad of as many bytes", WARM_5, TRIAD, 5, 2.5, faster=False),
    Row("cold float, over the first touch of the output", OURS, FRESH, faster=False),
    Row("cold float, over the first touch of the output in huge pages", OURS, HUGE, faster=False),
    Row("peak memory over output, cold float", OURS, OURS, 1.5, 1.1, faster=False, key="peak_bytes", other_key="output_bytes",
        compare=False),
    Row("peak memory of OpenSubdiv over ours", OURS, OSD, key="peak_bytes", compare=False),
    Row("two threads against one, cold (wall time)", OURS_TWO, OURS, 1.6, 1.9, key="wall", compare=False),
    Row("two threads against one, warm (wall time)", WARM_5_TWO, WARM_5, 1.6, 1.9, key="wall", compare=False),
    *small_rows(),
    *against("spot, 6 rounds, cold, float", everyone("spot", 6)),
    Row("Catmull-Clark cold, float, against our general path", OURS, GENERAL),
    Row("Catmull-Clark cold, double, against our general path", DOUBLE, GENERAL),
    *(Row(f"{name} cold, double, {mesh}, 4 rounds, against our general path", *general_pair(name, mesh))
      for name, mesh in OTHER_WORDS),
]
