// Shapes made from numbers. Double unless `exact = yes`.
#include "interpreter/arguments.h"
#include "interpreter/formula.h"
#include "operators/shapes.h"

namespace udcp {

namespace {

bool wants_exact(const Arguments& a) { return flag_or(a, a.positional.size(), "exact", false); }

template <class F>
Value mesh_value(const Arguments& a, F f) {
  return Value{MeshValue{with_number_type(wants_exact(a), f), "", nullptr}};
}
template <class F>
Value curve_value(const Arguments& a, F f) {
  return Value{CurveValue{with_number_type(wants_exact(a), f)}};
}

Value make_cube(CallContext&, const Arguments& a) {
  return mesh_value(a, []<class S>(std::type_identity<S>) { return cube<S>(); });
}
Value make_tetrahedron(CallContext&, const Arguments& a) {
  return mesh_value(a, []<class S>(std::type_identity<S>) { return tetrahedron<S>(); });
}
Value make_octahedron(CallContext&, const Arguments& a) {
  return mesh_value(a, []<class S>(std::type_identity<S>) { return octahedron<S>(); });
}
Value make_icosahedron(CallContext&, const Arguments& a) {
  return mesh_value(a, []<class S>(std::type_identity<S>) { return icosahedron<S>(); });
}

Value make_polygon(CallContext&, const Arguments& a) {
  const int corners = need_whole(a, 0, "corners", 3, 1'000'000);
  const NumberValue radius = a.get(1, "radius") ? need_number(a, 1, "radius") : NumberValue{Quantity<Algebraic>(1)};
  return curve_value(a, [&]<class S>(std::type_identity<S>) { return polygon<S>(corners, number_as<S>(radius)); });
}

Value make_curve(CallContext&, const Arguments& a) {
  const bool closed = flag_or(a, 1, "closed", true);
  const Value* corners = a.find("corners");
  return curve_value(a, [&]<class S>(std::type_identity<S>) {
    Polyline<S> curve;
    curve.points = points_from<S>(need(a, 0, "points"), "points");
    curve.closed = closed;
    validate(curve);
    if (!corners) return curve;
    curve.corner.assign(static_cast<std::size_t>(curve.size()), 0);
    for (const int i : indices_from(*corners, "corners", curve.size())) curve.corner[static_cast<std::size_t>(i)] = 1;
    return curve;
  });
}

std::vector<std::vector<int>> faces_from(const Value& list) {
  std::vector<std::vector<int>> faces;
  for (const Value& face : list_items(list, "faces")) {
    std::vector<int> corners;
    for (const Value& corner : list_items(face, "face " + std::to_string(faces.size())))
      corners.push_back(whole_number(corner, "a corner of face " + std::to_string(faces.size()), std::numeric_limits<int>::min(),
                                     std::numeric_limits<int>::max()));
    faces.push_back(std::move(corners));
  }
  return faces;
}

Value make_mesh_from_lists(CallContext&, const Arguments& a) {
  const std::vector<std::vector<int>> faces = faces_from(need(a, 1, "faces"));
  return mesh_value(a, [&]<class S>(std::type_identity<S>) {
    Surface<S> surface;
    surface.points = points_from<S>(need(a, 0, "points"), "points");
    surface.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(surface.points.rows()), faces));
    validate(surface);
    return surface;
  });
}

/// Sizes are checked against max_faces before anything is made.
void check_size(const CallContext& context, std::int64_t faces) {
  if (faces > context.settings.max_faces)
    throw Error(
        ErrorKind::limit, "E_MAX_FACES",
        "this mesh would have " + std::to_string(faces) + " faces; the limit is " + std::to_string(context.settings.max_faces),
        "raise it with: set max_faces = …");
}

constexpr int most = 1'000'000;

Value make_grid(CallContext& context, const Arguments& a) {
  const int nx = need_whole(a, 0, "nx", 1, most), ny = need_whole(a, 1, "ny", 1, most);
  check_size(context, std::int64_t{nx} * ny);
  return mesh_value(a, [&]<class S>(std::type_identity<S>) { return grid<S>(nx, ny); });
}

Value make_tube(CallContext& context, const Arguments& a) {
  const int m = need_whole(a, 0, "m", 3, most);
  const bool closed = flag_or(a, 2, "closed", false);
  check_size(context, m * static_cast<std::int64_t>(list_items(need(a, 1, "profile"), "profile").size()));
  return mesh_value(a, [&]<class S>(std::type_identity<S>) {
    const Points<S> profile = points_from<S>(need(a, 1, "profile"), "profile");
    if (profile.cols() != 2)
      throw Error(ErrorKind::input, "E_DIMENSION", "the rows of 'profile' must be [radius, height], two numbers each");
    return tube<S>(m, profile, closed);
  });
}

Value make_torus(CallContext& context, const Arguments& a) {
  const int m = need_whole(a, 0, "m", 3, most), k = need_whole(a, 1, "k", 3, most);
  check_size(context, std::int64_t{m} * k);
  const NumberValue large = need_number(a, 2, "R"), small = need_number(a, 3, "r");
  return mesh_value(a, [&]<class S>(std::type_identity<S>) { return torus<S>(m, k, number_as<S>(large), number_as<S>(small)); });
}

}  // namespace

std::vector<Builtin> builtins_geometry() {
  return {
      {"cube", "cube(exact = no)", "The cube [-1, 1]^3.", 0, 0, {"exact"}, make_cube},
      {"tetrahedron", "tetrahedron(exact = no)", "The tetrahedron with corner (1, 1, 1).", 0, 0, {"exact"}, make_tetrahedron},
      {"octahedron", "octahedron(exact = no)", "The octahedron with corners on the axes.", 0, 0, {"exact"}, make_octahedron},
      {"icosahedron", "icosahedron(exact = no)", "The icosahedron.", 0, 0, {"exact"}, make_icosahedron},
      {"polygon",
       "polygon(corners, radius = 1, exact = no)",
       "A regular polygon around the origin.",
       1,
       2,
       {"corners", "radius", "exact"},
       make_polygon},
      {"curve",
       "curve(points, closed = yes, corners = [], exact = no)",
       "A curve through a list of points.",
       1,
       2,
       {"points", "closed", "corners", "exact"},
       make_curve},
      {"mesh",
       "mesh(points, faces, exact = no)",
       "A mesh from a list of points and a list of index cycles.",
       2,
       2,
       {"points", "faces", "exact"},
       make_mesh_from_lists},
      {"grid", "grid(nx, ny, exact = no)", "nx by ny unit squares in the plane z = 0.", 2, 2, {"nx", "ny", "exact"}, make_grid},
      {"tube",
       "tube(m, profile, closed = no, exact = no)",
       "A tube of m-gons; the profile is a list of [radius, height].",
       2,
       3,
       {"m", "profile", "closed", "exact"},
       make_tube},
      {"torus",
       "torus(m, k, R, r, exact = no)",
       "A torus of m by k quads with radii R and r.",
       4,
       4,
       {"m", "k", "R", "r", "exact"},
       make_torus},
  };
}

}  // namespace udcp
