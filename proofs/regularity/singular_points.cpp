// Evaluation at dyadic points, and the sentences of a refutation.
#include "proofs/regularity/singular_points.h"

#include "proofs/regularity/certificate_json.h"
#include "proofs/regularity/covered_surface.h"
#include "proofs/regularity/ring_certificate.h"

namespace udcp {
namespace {

struct Sample {
  int patch;
  Rational u, v;
  std::string text;  // "u = 1/4, v = 0 of face 3"
  Vector3 normal;
  CornerValues values;
};

/// Where the points of the data lie: the nets by number, and names for them.
struct Stage {
  bool planar = false;
  int patches = 0;
  std::function<BicubicNet(int)> net;
  std::function<int(int)> group;
  std::function<std::string(int, const Rational&, const Rational&)> name;
};

/// Faces of the mesh itself, too, where the refined ones are quarters of them.
std::string place_name(const CoveredSurface& surface, int face, const Rational& u, const Rational& v) {
  std::string text = "u = " + u.to_string() + ", v = " + v.to_string() + " of face " + std::to_string(face);
  if (surface.steps == 0) return text;
  text += " of level " + std::to_string(surface.steps);
  const int parts = 1 << (2 * surface.steps);
  return surface.has_quads ? text + " (in face " + std::to_string(face / parts) + " of the mesh)" : text;
}

Stage stage_of_patches(const std::shared_ptr<const CoveredSurface>& surface) {
  const auto groups = std::make_shared<const std::vector<int>>(surface->mesh.groups(surface->mode));
  return {surface->mesh.is_planar(), surface->mesh.mesh().faces(),
          [surface](int f) {
            require(surface->mesh.kind_of(f, surface->mode) == FaceKind::patch, "a face of the points is no patch");
            return surface->mesh.net(f);
          },
          [groups](int f) { return (*groups)[static_cast<std::size_t>(f)]; },
          [surface](int f, const Rational& u, const Rational& v) { return place_name(*surface, f, u, v); }};
}

Stage stage_of_ring(const std::shared_ptr<const CoveredSurface>& surface, const Json& ring) {
  require_entries(ring, {"vertex", "ring"}, "ring");
  const int v = integer_from(ring["vertex"], 0, surface->mesh.mesh().vertices() - 1, "ring.vertex");
  require(surface->mesh.class_of(v) == VertexClass::extraordinary, "ring.vertex is not extraordinary");
  const int number = integer_from(ring["ring"], 1, largest_ring_level, "ring.ring");
  VertexRings rings = VertexRings::around(surface->mesh.surface(), v);
  const auto nets = std::make_shared<const std::vector<BicubicNet>>(rings.nets(number));
  return {surface->mesh.is_planar(), static_cast<int>(nets->size()),
          [nets](int k) { return (*nets)[static_cast<std::size_t>(k)]; }, [](int) { return 0; },
          [surface, spokes = rings.spokes(), number](int k, const Rational& u, const Rational& w) {
            const FacePoint at = face_point(surface->mesh.mesh(), spokes, number, k, u, w);
            return place_name(*surface, at.face, at.u, at.v);
          }};
}

std::vector<Sample> places(const Stage& stage, const Json& points) {
  require(points.is_array() && (points.size() == 1 || points.size() == 2), "points must be one or two");
  std::vector<Sample> result;
  for (const Json& point : points) {
    require_entries(point, {"face", "u", "v"}, "a point");
    Sample place{integer_from(point["face"], 0, stage.patches - 1, "face"),
                 rational_from(point["u"], "u"),
                 rational_from(point["v"], "v"),
                 {},
                 {},
                 {}};
    place.values = values_at(stage.net(place.patch), place.u, place.v);
    place.normal = cross(place.values.du, place.values.dv);
    place.text = stage.name(place.patch, place.u, place.v);
    result.push_back(std::move(place));
  }
  return result;
}

std::string describe_zero(const Sample& at) {
  require(is_zero(at.normal), "S_u x S_v is not zero at the point");
  const bool no_u = is_zero(at.values.du), no_v = is_zero(at.values.dv);
  if (no_u && no_v) return "both tangents vanish at " + at.text;
  if (no_u || no_v) return std::string("the tangent in ") + (no_u ? "u" : "v") + " vanishes at " + at.text;
  const bool same = dot(at.values.du, at.values.dv).sign() > 0;
  return std::string("the tangents in u and v are parallel") + (same ? "" : ", in opposite directions,") + " at " + at.text +
         ": there is no tangent plane";
}

std::string describe_sign(const Stage& stage, const Sample& a, const Sample& b) {
  require(stage.planar, "two points refute regularity in the plane only");
  require(stage.group(a.patch) == stage.group(b.patch), "the points do not lie in one connected part");
  require(a.normal[2].sign() * b.normal[2].sign() < 0, "the Jacobian does not change its sign between the points");
  const bool first = a.normal[2].sign() > 0;
  return "the surface folds over: the Jacobian is positive at " + (first ? a : b).text + " and negative at " +
         (first ? b : a).text + ", so it vanishes between them";
}

}  // namespace

CornerValues values_at(const BicubicNet& net, Rational u, Rational v) {
  const auto is_inside = [](const Rational& x) { return x >= Rational(0) && x <= Rational(1); };
  require(is_inside(u) && is_inside(v), "u and v must lie in [0, 1]");
  BicubicNet part = net;
  for (int level = 0; level <= 60; ++level) {
    if (u.is_integer() && v.is_integer()) return corner(part, v.to_int(), u.to_int());
    const Rational half = Rational(1) / Rational(2);
    const int c = u >= half ? 1 : 0, r = v >= half ? 1 : 0;
    part = child(part, 2 * r + c);
    u = Rational(2) * u - Rational(c);
    v = Rational(2) * v - Rational(r);
  }
  throw Rejected("u and v must be dyadic fractions of at most 60 bits");
}

std::string describe_singularity(const Json& data, const std::atomic<bool>* stop) {
  require_entries(data, {"mesh", "mode", "steps", "ring", "points"}, "data");
  RunControl control;
  control.stop = stop;
  const Surface<Rational> mesh = surface_from(data["mesh"]);
  const int steps = integer_from(data["steps"], 0, most_regularity_steps, "steps");
  const auto surface = std::make_shared<const CoveredSurface>(cover(mesh, mode_from(data["mode"]), steps, control));
  const Stage stage = data["ring"].is_null() ? stage_of_patches(surface) : stage_of_ring(surface, data["ring"]);
  const std::vector<Sample> found = places(stage, data["points"]);
  return found.size() == 1 ? describe_zero(found[0]) : describe_sign(stage, found[0], found[1]);
}

}  // namespace udcp
