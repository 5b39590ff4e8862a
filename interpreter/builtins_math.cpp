// A look at values: their types, sizes and parts, sums, and comparison within a tolerance.
#include <algorithm>
#include <cmath>

#include "interpreter/apply.h"
#include "interpreter/arguments.h"
#include "interpreter/compare.h"
#include "interpreter/formula.h"

namespace udcp {

namespace {

Value type_of(CallContext&, const Arguments& a) { return Value{TextValue{type_name(a.positional[0])}}; }

Value length_of(CallContext&, const Arguments& a) {
  const Value& x = a.positional[0];
  if (const auto* list = x.as<ListValue>()) return whole_value(static_cast<std::int64_t>(list->items.size()));
  if (const auto* report = x.as<ReportValue>()) return whole_value(static_cast<std::int64_t>(report->parts.size()));
  if (const auto* text = x.as<TextValue>()) return whole_value(static_cast<std::int64_t>(text->value.size()));
  if (const auto* curve = x.as<CurveValue>())
    return whole_value(std::visit([](const auto& c) { return c.size(); }, curve->shape));
  throw wrong_type("what length measures", "a list, a report, a text or a curve", x);
}

Value sum_of(CallContext&, const Arguments& a) {
  NumberValue sum{Quantity<Algebraic>(0)};
  const auto* report = a.positional[0].as<ReportValue>();
  for (const Value& item : report ? report->parts : list_items(a.positional[0], "list")) {
    const auto* number = item.as<NumberValue>();
    if (!number) throw wrong_type("an item of the list", "a number", item);
    sum = apply_operator("+", sum, *number);
  }
  return Value{sum};
}

Value are_close(CallContext&, const Arguments& a) {
  const double tolerance = number_as<double>(need_number(a, 2, "tolerance"));
  if (!(tolerance >= 0)) throw Error(ErrorKind::word, "E_TYPE", "the tolerance must not be negative");
  return Value{Boolean{compare_approximately(a.positional[0], a.positional[1], tolerance).equal}};
}

Value in_double(CallContext& context, const Arguments& a) {
  const Value& x = a.positional[0];
  if (const auto* number = x.as<NumberValue>()) return number_of(number_as<double>(*number));
  if (const auto* mesh = x.as<MeshValue>()) return Value{MeshValue{as_double(*mesh), mesh->word, mesh->normals}};
  if (const auto* curve = x.as<CurveValue>()) return Value{CurveValue{as_double(*curve)}};
  if (const auto* matrix = x.as<MatrixValue>()) {
    Points<double> entries;
    std::visit(
        [&](const auto& m) {
          entries.resize(m.rows(), m.cols());
          for (Eigen::Index i = 0; i < m.size(); ++i) entries.data()[i] = approximate(m.data()[i]);
        },
        matrix->entries);
    return Value{MatrixValue{std::move(entries)}};
  }
  ListValue list;
  for (const Value& item : list_items(x, "what approximate works on"))
    list.items.push_back(in_double(context, Arguments{{item}, {}}));
  return Value{std::move(list)};
}

Value enclosed(CallContext&, const Arguments& a) { return number_of(number_as<Interval>(need_number(a, 0, "number"))); }

/// f on whatever surface or curve the shape holds.
template <class F>
Value look(const Arguments& a, const char* who, F f) {
  const Value& x = a.positional[0];
  if (const auto* mesh = x.as<MeshValue>()) return std::visit([&](const auto& s) { return Value{f(s)}; }, mesh->shape);
  if (const auto* curve = x.as<CurveValue>()) return std::visit([&](const auto& s) { return Value{f(s)}; }, curve->shape);
  throw wrong_type(std::string("what ") + who + " looks at", "a curve or a mesh", x);
}

template <class S>
ListValue row_of(const Points<S>& points, Eigen::Index i) {
  ListValue row;
  for (Eigen::Index c = 0; c < points.cols(); ++c) row.items.push_back(number_of(points(i, c)));
  return row;
}

Value list_points(CallContext&, const Arguments& a) {
  return look(a, "points", [](const auto& shape) {
    ListValue rows;
    for (Eigen::Index i = 0; i < shape.points.rows(); ++i) rows.items.push_back(Value{row_of(shape.points, i)});
    return rows;
  });
}

Value find_bounds(CallContext&, const Arguments& a) {
  return look(a, "bounds", [](const auto& shape) {
    auto least = shape.points, most = shape.points;
    least.conservativeResize(1, Eigen::NoChange);
    most.conservativeResize(1, Eigen::NoChange);
    for (Eigen::Index i = 0; i < shape.points.rows(); ++i) {
      for (Eigen::Index c = 0; c < shape.points.cols(); ++c) {
        if (shape.points(i, c) < least(0, c)) least(0, c) = shape.points(i, c);
        if (shape.points(i, c) > most(0, c)) most(0, c) = shape.points(i, c);
      }
    }
    return ListValue{{Value{row_of(least, 0)}, Value{row_of(most, 0)}}};
  });
}

const Mesh& mesh_of(const Arguments& a) {
  return std::visit([](const auto& s) -> const Mesh& { return *s.mesh; }, need_mesh(a, 0).shape);
}

Value count_vertices(CallContext&, const Arguments& a) { return whole_value(mesh_of(a).vertices()); }
Value count_edges(CallContext&, const Arguments& a) { return whole_value(mesh_of(a).edges()); }
Value count_faces(CallContext&, const Arguments& a) { return whole_value(mesh_of(a).faces()); }

Value list_faces(CallContext&, const Arguments& a) {
  const Mesh& mesh = mesh_of(a);
  ListValue faces;
  for (int f = 0; f < mesh.faces(); ++f) {
    ListValue face;
    for (const int v : mesh.corners(f)) face.items.push_back(whole_value(v));
    faces.items.push_back(Value{std::move(face)});
  }
  return Value{std::move(faces)};
}

Value list_valences(CallContext&, const Arguments& a) {
  const Mesh& mesh = mesh_of(a);
  ListValue list;
  for (int v = 0; v < mesh.vertices(); ++v) list.items.push_back(whole_value(mesh.valence(v)));
  return Value{std::move(list)};
}

/// [a, b, "lat"] with a < b for every tagged edge, in edge order.
Value list_tags(CallContext&, const Arguments& a) {
  const Mesh& mesh = mesh_of(a);
  const Tags& tags = std::visit([](const auto& s) -> const Tags& { return s.tags; }, need_mesh(a, 0).shape);
  ListValue list;
  for (int e = 0; e < mesh.edges(); ++e) {
    const EdgeTag tag = tags.of_edge(e);
    if (tag == EdgeTag::none) continue;
    const int h = mesh.edge_half[Mesh::i(e)];
    const auto [low, high] = std::minmax({mesh.vertex[Mesh::i(h)], mesh.tip(h)});
    list.items.push_back(
        Value{ListValue{{whole_value(low), whole_value(high), Value{TextValue{tag == EdgeTag::latitude ? "lat" : "lon"}}}}});
  }
  return Value{std::move(list)};
}

Value list_corners(CallContext&, const Arguments& a) {
  ListValue list;
  const Value& x = a.positional[0];
  const auto add_if = [&](bool is_corner, int i) {
    if (is_corner) list.items.push_back(whole_value(i));
  };
  if (const auto* curve = x.as<CurveValue>()) {
    std::visit(
        [&](const auto& c) {
          for (int i = 0; i < c.size(); ++i) add_if(c.is_corner(i), i);
        },
        curve->shape);
  } else {
    std::visit(
        [&](const auto& s) {
          for (int v = 0; v < s.mesh->vertices(); ++v) add_if(s.tags.is_corner(v), v);
        },
        need_mesh(a, 0).shape);
  }
  return Value{std::move(list)};
}

}  // namespace

std::vector<Builtin> builtins_math() {
  return {
      {"type", "type(x)", "What kind of value x is, as a text.", 1, 1, {}, type_of},
      {"length",
       "length(list)",
       "The number of items of a list, a report or a text, or of points of a curve.",
       1,
       1,
       {},
       length_of},
      {"sum", "sum(list)", "The sum of numbers.", 1, 1, {}, sum_of},
      {"approx", "approx(a, b, tolerance)", "Whether all numbers in a and b agree within the tolerance.", 3, 3, {}, are_close},
      {"approximate", "approximate(x)", "Numbers, lists, matrices and shapes in double.", 1, 1, {}, in_double},
      {"enclosure", "enclosure(number)", "The number as an interval of the precision in force.", 1, 1, {}, enclosed},
      {"points", "points(shape)", "The points as a list of lists.", 1, 1, {}, list_points},
      {"bounds", "bounds(shape)", "The least and the greatest coordinates.", 1, 1, {}, find_bounds},
      {"vertices", "vertices(mesh)", "The number of vertices.", 1, 1, {}, count_vertices},
      {"edges", "edges(mesh)", "The number of edges.", 1, 1, {}, count_edges},
      {"faces", "faces(mesh)", "The number of faces.", 1, 1, {}, count_faces},
      {"face_list", "face_list(mesh)", "The faces as lists of vertices.", 1, 1, {}, list_faces},
      {"valences", "valences(mesh)", "The valence of every vertex.", 1, 1, {}, list_valences},
      {"tags", "tags(mesh)", "The tagged edges as [a, b, tag].", 1, 1, {}, list_tags},
      {"corners", "corners(shape)", "The points marked as corners.", 1, 1, {}, list_corners},
  };
}

}  // namespace udcp
