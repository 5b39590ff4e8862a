// Regularity certificates as JSON.
#include "proofs/regularity/certificate_json.h"

namespace udcp {
namespace {

constexpr std::size_t most_points = 4'000'000;

Json to_json(const Vector3& w) {
  Json list = Json::array();
  for (const Rational& x : w) list.push_back(udcp::to_json(x));
  return list;
}

Vector3 vector_from(const Json& json, const std::string& where) {
  require(json.is_array() && json.size() == 3, where + " must have three entries");
  return {rational_from(json[0], where), rational_from(json[1], where), rational_from(json[2], where)};
}

}  // namespace

Json to_json(const Surface<Rational>& surface) {
  Json points = Json::array(), faces = Json::array(), corners = Json::array();
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < surface.points.cols(); ++c) row.push_back(to_json(surface.points(v, c)));
    points.push_back(std::move(row));
  }
  for (int f = 0; f < surface.mesh->faces(); ++f) {
    Json row = Json::array();
    for (const int v : surface.mesh->corners(f)) row.push_back(v);
    faces.push_back(std::move(row));
  }
  for (int v = 0; v < surface.mesh->vertices(); ++v)
    if (surface.tags.is_corner(v)) corners.push_back(v);
  return Json{{"points", std::move(points)}, {"faces", std::move(faces)}, {"corners", std::move(corners)}};
}

Surface<Rational> surface_from(const Json& json) {
  require_entries(json, {"points", "faces", "corners"}, "mesh");
  const Json &points = json["points"], &faces = json["faces"], &corners = json["corners"];
  require(points.is_array() && faces.is_array() && corners.is_array(), "mesh.points, mesh.faces and mesh.corners must be lists");
  require(
      !points.empty() && points.size() <= most_points && points[0].is_array() && (points[0].size() == 2 || points[0].size() == 3),
      "mesh.points must be points of two or three coordinates");
  Surface<Rational> surface;
  const std::size_t columns = points[0].size();
  surface.points.resize(static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t v = 0; v < points.size(); ++v) {
    require(points[v].is_array() && points[v].size() == columns, "mesh.points must all have the same number of coordinates");
    for (std::size_t c = 0; c < columns; ++c)
      surface.points(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c)) = rational_from(points[v][c], "mesh.points");
  }
  const int count = static_cast<int>(points.size());
  std::vector<int> begin{0}, list;
  for (const Json& face : faces) {
    require(face.is_array() && face.size() >= 3, "mesh.faces must be lists of at least 3 vertices");
    for (const Json& v : face) list.push_back(integer_from(v, 0, count - 1, "mesh.faces"));
    begin.push_back(static_cast<int>(list.size()));
  }
  try {
    surface.mesh = std::make_shared<const Mesh>(make_mesh(count, std::move(begin), std::move(list)));
  } catch (const Error& error) {
    throw Rejected(std::string("mesh: ") + error.what());
  }
  int last = -1;
  for (const Json& v : corners) {
    const int corner = integer_from(v, last + 1, count - 1, "mesh.corners (rising)");
    require(surface.mesh->on_boundary(corner), "mesh.corners must be boundary vertices");
    if (surface.tags.corner.empty()) surface.tags.corner.assign(points.size(), 0);
    surface.tags.corner[static_cast<std::size_t>(corner)] = 1;
    last = corner;
  }
  return surface;
}

RegularityMode mode_from(const Json& json) {
  require(json == "interior" || json == "bspline", "mode must be \"interior\" or \"bspline\"");
  return json == "interior" ? RegularityMode::interior : RegularityMode::bspline;
}

Json to_json(const std::string& path, RegularityTest test, const RegularityWitness& witness) {
  Json json{{"path", path}, {"test", to_string(test)}};
  if (witness.sign != 0) json["sign"] = witness.sign;
  if (witness.n) json["n"] = to_json(*witness.n);
  if (witness.m) json["m"] = to_json(*witness.m);
  return json;
}

LeafData leaf_from(const Json& json, bool planar) {
  LeafData leaf;
  const Json& test = entry(json, "test");
  require(test.is_string(), "test must be a text");
  const std::optional<RegularityTest> known = regularity_test_from(test.get<std::string>());
  require(known.has_value(), "test must be T2, T3 or T4");
  leaf.test = *known;
  require(entry(json, "path").is_string(), "path must be a text");
  leaf.path = json["path"].get<std::string>();
  if (planar) {
    require_entries(json, {"path", "test", "sign"}, "a patch");
    leaf.witness.sign = integer_from(json["sign"], -1, 1, "sign");
  } else if (leaf.test == RegularityTest::t4) {
    require_entries(json, {"path", "test", "n"}, "a patch");
    leaf.witness.n = vector_from(json["n"], "n");
  } else {
    require_entries(json, {"path", "test", "n", "m"}, "a patch");
    leaf.witness.n = vector_from(json["n"], "n");
    leaf.witness.m = vector_from(json["m"], "m");
  }
  return leaf;
}

Json to_json(const RegularityWitness& separation) { return Json{{"n", to_json(*separation.n)}, {"m", to_json(*separation.m)}}; }

RegularityWitness separation_from(const Json& json) {
  require_entries(json, {"n", "m"}, "global");
  return {0, vector_from(json["n"], "n"), vector_from(json["m"], "m")};
}

}  // namespace udcp
