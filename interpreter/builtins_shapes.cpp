// What a program does with a shape besides refining it: tags and attributes, simple transformations, and a look at its parts.
#include <algorithm>

#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "interpreter/edge_loops.h"
#include "interpreter/formula.h"
#include "interpreter/shape_parts.h"
#include "operators/shapes.h"

namespace udcp {

namespace {

/// loops(axis = z) is asked before the mesh is known, so it is a question that tag answers.
Value ask_loops(CallContext&, const Arguments& a) {
  const std::string axis = a.get(0, "axis") ? need_text(a, 0, "axis") : "z";
  if (axis != "x" && axis != "y" && axis != "z") throw Error(ErrorKind::word, "E_TYPE", "the axis of loops must be x, y or z");
  return Value{ReportValue{"edge loops around " + axis, Json{{"loops", axis}}, {}}};
}

std::vector<int> all_indices(int n) {
  std::vector<int> result;
  for (int i = 0; i < n; ++i) result.push_back(i);
  return result;
}

bool is_text(const Value& value, const std::string& text) {
  return value.as<TextValue>() && value.as<TextValue>()->value == text;
}

std::vector<int> chosen_edges(const MeshValue& mesh, const Value& choice) {
  const Surface<double> surface = as_double(mesh);
  if (is_text(choice, "all")) return all_indices(surface.mesh->edges());
  if (const auto* report = choice.as<ReportValue>(); report && report->json.is_object() && report->json.contains("loops"))
    return planar_edge_loops(surface, report->json["loops"].get<std::string>()[0] - 'x');
  std::vector<int> edges;
  for (const Value& pair : list_items(choice, "edges")) {
    const std::vector<int> ends = indices_from(pair, "edges", surface.mesh->vertices());
    if (ends.size() != 2) throw Error(ErrorKind::input, "E_TAGS", "an edge is a list of two vertices, as in [0, 1]");
    edges.push_back(find_edge(*surface.mesh, ends[0], ends[1]));
  }
  return edges;
}

void set_edges(Tags& tags, const Mesh& mesh, const std::vector<int>& edges, EdgeTag tag) {
  if (tags.edge.empty()) tags.edge.assign(Mesh::i(mesh.edges()), EdgeTag::none);
  for (const int e : edges) tags.edge[Mesh::i(e)] = tag;
}

std::vector<int> chosen_corners(const MeshValue& mesh, const Value& choice) {
  return std::visit(
      [&](const auto& surface) {
        const Mesh& m = *surface.mesh;
        std::vector<int> corners;
        if (is_text(choice, "none")) return corners;
        if (is_text(choice, "one_face")) {
          for (int v = 0; v < m.vertices(); ++v)
            if (m.on_boundary(v) && m.valence(v) == 2) corners.push_back(v);
          return corners;
        }
        corners = indices_from(choice, "corners", m.vertices());
        for (const int v : corners)
          if (!m.on_boundary(v))
            throw Error(ErrorKind::input, "E_CORNER",
                        "vertex " + std::to_string(v) + " is not on the boundary; only boundary vertices can be corners");
        return corners;
      },
      mesh.shape);
}

void set_corners(std::vector<char>& flags, int size, const std::vector<int>& corners, bool replace) {
  if (replace || flags.empty()) flags.assign(static_cast<std::size_t>(size), 0);
  for (const int v : corners) flags[static_cast<std::size_t>(v)] = 1;
}

/// tag(shape, lat | lon, edges) and tag(shape, corner, vertices | one_face | none).
Value set_tag(CallContext& context, const Arguments& a) {
  Value result = need(a, 0, "shape");
  const std::string what = need_text(a, 1, "tag");
  const Value& choice = need(a, 2, what == "corner" ? "vertices" : "edges");
  if (auto* curve = std::get_if<CurveValue>(&result.data)) {
    if (what != "corner") throw Error(ErrorKind::word, "E_TYPE", "the points of a curve can only be tagged as corner");
    std::visit(
        [&](auto& line) {
          const bool none = is_text(choice, "none");
          set_corners(line.corner, line.size(), none ? std::vector<int>{} : indices_from(choice, "corners", line.size()), none);
        },
        curve->shape);
    return result;
  }
  auto* mesh = std::get_if<MeshValue>(&result.data);
  if (!mesh) throw wrong_type("what tag works on", "a curve or a mesh", result);
  if (what != "corner" && what != "lat" && what != "lon")
    throw Error(ErrorKind::word, "E_TYPE", "a tag is lat, lon or corner, not " + what);
  if (what == "corner") {
    const std::vector<int> corners = chosen_corners(*mesh, choice);
    std::visit([&](auto& s) { set_corners(s.tags.corner, s.mesh->vertices(), corners, is_text(choice, "none")); }, mesh->shape);
    return result;
  }
  const std::vector<int> edges = chosen_edges(*mesh, choice);
  if (edges.empty() && context.output.warning) context.output.warning("tag(" + what + ", …) found no edges");
  std::visit([&](auto& s) { set_edges(s.tags, *s.mesh, edges, what == "lat" ? EdgeTag::latitude : EdgeTag::longitude); },
             mesh->shape);
  if (choice.as<ReportValue>()) tag_crossing_edges(*mesh, what == "lat" ? EdgeTag::latitude : EdgeTag::longitude);
  return result;
}

/// untag(shape, lat | lon | corner | all)
Value remove_tag(CallContext&, const Arguments& a) {
  Value result = need(a, 0, "shape");
  const std::string what = a.get(1, "tag") ? need_text(a, 1, "tag") : "all";
  if (what != "all" && what != "corner" && what != "lat" && what != "lon")
    throw Error(ErrorKind::word, "E_TYPE", "a tag is lat, lon, corner or all, not " + what);
  if (auto* curve = std::get_if<CurveValue>(&result.data)) {
    if (what == "all" || what == "corner") std::visit([](auto& line) { line.corner.clear(); }, curve->shape);
    return result;
  }
  auto* mesh = std::get_if<MeshValue>(&result.data);
  if (!mesh) throw wrong_type("what untag works on", "a curve or a mesh", result);
  std::visit(
      [&](auto& s) {
        if (what == "all" || what == "corner") s.tags.corner.clear();
        for (EdgeTag& tag : s.tags.edge)
          if (what == "all" || (what == "lat" && tag == EdgeTag::latitude) || (what == "lon" && tag == EdgeTag::longitude))
            tag = EdgeTag::none;
      },
      mesh->shape);
  return result;
}

/// attribute(shape, name, values): one number, a list with one number per vertex, or a function of the coordinates.
Value set_attribute(CallContext& context, const Arguments& a) {
  Value result = need(a, 0, "shape");
  const std::string name = need_text(a, 1, "name");
  const bool letters =
      !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!letters || std::isdigit(static_cast<unsigned char>(name[0])))
    throw Error(ErrorKind::input, "E_ATTRIBUTE", "the name of an attribute is made of letters, digits and _, not '" + name + "'");
  const Value& values = need(a, 2, "values");
  const auto set = [&](auto& shape) { shape.attributes[name] = attribute_column(shape.points, values, context); };
  if (auto* mesh = std::get_if<MeshValue>(&result.data))
    std::visit(set, mesh->shape);
  else if (auto* curve = std::get_if<CurveValue>(&result.data))
    std::visit(set, curve->shape);
  else
    throw wrong_type("what attribute works on", "a curve or a mesh", result);
  return result;
}

Value cut_into_triangles(CallContext&, const Arguments& a) {
  MeshValue result = need_mesh(a, 0);
  std::visit([](auto& s) { s = triangulate(s); }, result.shape);
  result.scheme = nullptr;
  return Value{std::move(result)};
}

Value turn_around(CallContext&, const Arguments& a) {
  Value result = need(a, 0, "shape");
  if (auto* mesh = std::get_if<MeshValue>(&result.data))
    std::visit([](auto& s) { s = reversed(s); }, mesh->shape);
  else if (auto* curve = std::get_if<CurveValue>(&result.data))
    std::visit([](auto& s) { s = reversed(s); }, curve->shape);
  else
    throw wrong_type("what reverse works on", "a curve or a mesh", result);
  return result;
}

/// Runs f(points) on the points of a shape; limit normals are dropped, they would no longer fit.
template <class F>
Value with_points(const Arguments& a, const char* who, F f) {
  Value result = need(a, 0, "shape");
  if (auto* mesh = std::get_if<MeshValue>(&result.data)) {
    mesh->normals = nullptr;
    std::visit([&](auto& s) { f(s.points); }, mesh->shape);
  } else if (auto* curve = std::get_if<CurveValue>(&result.data)) {
    std::visit([&](auto& s) { f(s.points); }, curve->shape);
  } else {
    throw wrong_type(std::string("what ") + who + " works on", "a curve or a mesh", result);
  }
  return result;
}

template <class S>
std::vector<S> per_coordinate(const Value& value, const Points<S>& points, const char* name) {
  if (const auto* number = value.as<NumberValue>())
    return std::vector<S>(static_cast<std::size_t>(points.cols()), number_as<S>(*number));
  const Points<S> row = points_from<S>(Value{ListValue{{value}}}, name);
  if (row.cols() != points.cols())
    throw Error(ErrorKind::input, "E_DIMENSION",
                std::string("'") + name + "' needs " + std::to_string(points.cols()) + " numbers");
  return {row.data(), row.data() + row.cols()};
}

Value scale_points(CallContext&, const Arguments& a) {
  return with_points(a, "scale", [&]<class S>(Points<S>& points) {
    const std::vector<S> factor = per_coordinate(need(a, 1, "factor"), points, "factor");
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      for (Eigen::Index c = 0; c < points.cols(); ++c) points(i, c) *= factor[static_cast<std::size_t>(c)];
  });
}

Value move_points(CallContext&, const Arguments& a) {
  return with_points(a, "translate", [&]<class S>(Points<S>& points) {
    const std::vector<S> by = per_coordinate(need(a, 1, "vector"), points, "vector");
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      for (Eigen::Index c = 0; c < points.cols(); ++c) points(i, c) += by[static_cast<std::size_t>(c)];
  });
}

Value rotate_points(CallContext&, const Arguments& a) {
  const NumberValue angle = need_number(a, 1, "angle");
  const std::string axis = a.get(2, "axis") ? need_text(a, 2, "axis") : "z";
  if (axis != "x" && axis != "y" && axis != "z") throw Error(ErrorKind::word, "E_TYPE", "the axis must be x, y or z");
  return with_points(a, "rotate", [&]<class S>(Points<S>& points) {
    const S c = cos(quantity<S>(angle)).value(), s = sin(quantity<S>(angle)).value();
    const Eigen::Index u = axis == "z" ? 0 : axis == "x" ? 1 : 2, w = axis == "z" ? 1 : axis == "x" ? 2 : 0;
    if (u >= points.cols() || w >= points.cols())
      throw Error(ErrorKind::input, "E_DIMENSION", "the points have too few coordinates to turn around this axis");
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const S p = points(i, u), q = points(i, w);
      points(i, u) = c * p - s * q;
      points(i, w) = s * p + c * q;
    }
  });
}

}  // namespace

std::vector<Builtin> builtins_shapes() {
  return {
      {"loops", "loops(axis = z)", "For tag: the closed edge loops in planes across an axis.", 0, 1, {"axis"}, ask_loops},
      {"tag",
       "tag(shape, lat | lon | corner, edges | vertices)",
       "Marks edges as latitude or longitude, or vertices as corners.",
       3,
       3,
       {},
       set_tag},
      {"untag", "untag(shape, lat | lon | corner | all)", "Takes marks away.", 1, 2, {}, remove_tag},
      {"attribute",
       "attribute(shape, \"name\", values)",
       "Sets v.name: a number, a list with a number per vertex, or a function of the coordinates.",
       3,
       3,
       {},
       set_attribute},
      {"triangulate", "triangulate(mesh)", "Cuts every face into a fan of triangles.", 1, 1, {}, cut_into_triangles},
      {"reverse", "reverse(shape)", "Turns the faces, or the direction of a curve, around.", 1, 1, {}, turn_around},
      {"scale", "scale(shape, factor)", "Multiplies the coordinates by a number, or by one number each.", 2, 2, {}, scale_points},
      {"translate", "translate(shape, vector)", "Adds a vector to all points.", 2, 2, {}, move_points},
      {"rotate",
       "rotate(shape, angle, axis = z)",
       "Turns the shape around an axis through the origin.",
       2,
       3,
       {"axis"},
       rotate_points},
  };
}

}  // namespace udcp
