// The input of interpolation proofs as JSON, what of it the theorems cover, and the texts of statements.
#include <set>

#include "proofs/interpolation_facts.h"
#include "proofs/regularity/certificate_json.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

std::string plural(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

Json to_json(const Points<Rational>& rows) {
  Json result = Json::array();
  for (Eigen::Index v = 0; v < rows.rows(); ++v) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < rows.cols(); ++c) row.push_back(to_json(rows(v, c)));
    result.push_back(std::move(row));
  }
  return result;
}

Points<Rational> rows_from(const Json& json, int count, const std::string& where) {
  require(json.is_array() && json.size() == at(count), where + " must have " + std::to_string(count) + " rows");
  Points<Rational> rows(count, 3);
  for (int v = 0; v < count; ++v) {
    const Json& row = json[at(v)];
    require(row.is_array() && row.size() == 3, where + ": a row must have three numbers");
    for (int c = 0; c < 3; ++c) rows(v, c) = rational_from(row[at(c)], where);
  }
  return rows;
}

Json to_json(const ExactInterpolation& what) {
  return Json{{"mesh", to_json(what.cage)},
              {"normals", to_json(what.normals)},
              {"step1", what.global ? "global" : "local"},
              {"lambda", what.global ? to_json(what.lambda) : Json(nullptr)},
              {"step2", what.tied ? "tied" : "free"}};
}

std::string not_covered(const ExactInterpolation& what) {
  const Mesh& mesh = *what.cage.mesh;
  if (mesh.vertices() > most_interpolation_vertices)
    return "exact interpolation is decided for meshes of up to " + std::to_string(most_interpolation_vertices) + " vertices";
  if (what.cage.points.cols() != 3) return "the points must have three coordinates";
  for (int v = 0; v < mesh.vertices(); ++v) {
    const std::string name = "vertex " + std::to_string(v);
    if (mesh.on_boundary(v)) return name + " lies on the boundary; the theorem is for closed meshes";
    if (what.cage.tags.is_corner(v)) return name + " is a corner; the theorem is for meshes without";
    if (mesh.valence(v) < 3 || mesh.valence(v) > largest_interpolation_valence)
      return name + " has valence " + std::to_string(mesh.valence(v)) + "; the theorem is checked for 3 to " +
             std::to_string(largest_interpolation_valence);
    if (what.normals(v, 0).is_zero() && what.normals(v, 1).is_zero() && what.normals(v, 2).is_zero())
      return "the normal at " + name + " is zero";
  }
  if (what.global && (what.lambda <= Rational(7) / Rational(20) || what.lambda > Rational(1)))
    return "lambda = " + what.lambda.to_string() + " is outside (7/20, 1]";
  return {};
}

ExactInterpolation interpolation_from(const Json& data) {
  ExactInterpolation what;
  what.cage = surface_from(entry(data, "mesh"));
  what.normals = rows_from(entry(data, "normals"), what.cage.mesh->vertices(), "normals");
  const Json &step1 = entry(data, "step1"), &step2 = entry(data, "step2"), &lambda = entry(data, "lambda");
  require(step1 == "global" || step1 == "local", "step1 must be \"global\" or \"local\"");
  require(step2 == "free" || step2 == "tied", "step2 must be \"free\" or \"tied\"");
  what.global = step1 == "global";
  what.tied = step2 == "tied";
  if (what.global)
    what.lambda = rational_from(lambda, "lambda");
  else
    require(lambda.is_null(), "lambda must be null for local");
  const std::string reason = not_covered(what);
  require(reason.empty(), reason);
  return what;
}

std::string name_of_cage(const Json& data) {
  return "the mesh with " + plural(data["mesh"]["points"].size(), "vertex", "vertices") + " and " +
         plural(data["mesh"]["faces"].size(), "face", "faces") + " (digest " + digest(data["mesh"].dump()) + ")";
}

namespace {

std::string method_of(const Json& data) {
  std::string text = "two-level Catmull-Clark interpolation (step 1 " + data["step1"].get<std::string>();
  if (data["step1"] == "global") text += " with lambda = " + data["lambda"].get<std::string>();
  return text + ", step 2 " + data["step2"].get<std::string>() + ") of " + name_of_cage(data) + " and its normals (digest " +
         digest(data["normals"].dump()) + ")";
}

}  // namespace

std::string interpolation_statement(const Json& data) {
  return "the surface by " + method_of(data) +
         " passes exactly through every vertex and has there exactly the direction and side of its normal";
}

std::string reversed_statement(const Json& data, int vertex) {
  return "the surface by " + method_of(data) + " does not have the normal of vertex " + std::to_string(vertex) +
         ": before step 2 it is 90 degrees off or more, and projected tangents stay on their side";
}

std::string threshold_statement(const std::vector<int>& valences) {
  std::string list;
  for (const int n : valences) list += (list.empty() ? "" : ", ") + std::to_string(n);
  return "on every closed quad mesh with vertices of valence " + list +
         " only and for 7/20 < lambda <= 1 the map from control points to the limits of the modified Catmull-Clark step has real "
         "eigenvalues, at most 1 and at least the smallest n (20 lambda - 7)/(13 (n + 5)): the iteration over the mesh converges";
}

std::string checkerboard_statement(const Json& data) {
  return "on the mesh with " + plural(data["vertices"].get<std::size_t>(), "vertex", "vertices") + " and " +
         plural(data["faces"].size(), "face", "faces") + " (digest " + digest(data["faces"].dump()) +
         ") and for lambda = " + data["lambda"].get<std::string>() +
         " the map from control points to the limits of the modified Catmull-Clark step has an eigenvalue that is not positive: "
         "the iteration over the mesh does not converge for all points";
}

Json faces_to_json(const Mesh& mesh) {
  Json faces = Json::array();
  for (int f = 0; f < mesh.faces(); ++f) {
    Json row = Json::array();
    for (const int v : mesh.corners(f)) row.push_back(v);
    faces.push_back(std::move(row));
  }
  return faces;
}

Mesh mesh_from(const Json& vertices, const Json& faces) {
  const int count = integer_from(vertices, 3, 1'000'000, "vertices");
  require(faces.is_array() && faces.size() <= 1'000'000, "faces must be a list");
  std::vector<int> begin{0}, corners;
  for (const Json& face : faces) {
    require(face.is_array() && face.size() == 4, "faces must be lists of 4 vertices");
    for (const Json& v : face) corners.push_back(integer_from(v, 0, count - 1, "faces"));
    begin.push_back(static_cast<int>(corners.size()));
  }
  try {
    return make_mesh(count, std::move(begin), std::move(corners));
  } catch (const Error& error) {
    throw Rejected(std::string("faces: ") + error.what());
  }
}

}  // namespace udcp
