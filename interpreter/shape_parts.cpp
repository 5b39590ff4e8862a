// Reversal, attribute columns and the search for an edge by its ends.
#include "interpreter/shape_parts.h"

#include <algorithm>
#include <map>

#include "interpreter/arguments.h"
#include "interpreter/formula.h"
#include "operators/topology.h"

namespace udcp {

int find_edge(const Mesh& mesh, int a, int b) {
  for (const int v : {a, b}) {
    const int other = v == a ? b : a;
    const int start = mesh.outgoing[Mesh::i(v)];
    int h = start;
    do {
      if (mesh.tip(h) == other) return mesh.edge[Mesh::i(h)];
      h = mesh.around(h);
    } while (h >= 0 && h != start);
  }
  throw Error(ErrorKind::input, "E_TAGS",
              "the mesh has no edge between vertex " + std::to_string(a) + " and vertex " + std::to_string(b));
}

void tag_crossing_edges(MeshValue& value, EdgeTag tag) {
  std::visit(
      [&](auto& surface) {
        const Mesh& mesh = *surface.mesh;
        std::vector<int> crossing;
        for (int f = 0; f < mesh.faces(); ++f) {
          if (mesh.size(f) != 4) continue;
          const int h = mesh.face_begin[Mesh::i(f)];
          const auto edge = [&](int side) { return mesh.edge[Mesh::i(h + side % 4)]; };
          for (int side = 0; side < 2; ++side) {
            const auto is = [&](int k, EdgeTag t) { return surface.tags.of_edge(edge(side + k)) == t; };
            if (is(0, tag) && is(2, tag) && is(1, EdgeTag::none) && is(3, EdgeTag::none))
              crossing.insert(crossing.end(), {edge(side + 1), edge(side + 3)});
          }
        }
        for (const int e : crossing) surface.tags.edge[Mesh::i(e)] = opposite(tag);
      },
      value.shape);
}

template <class S>
Surface<S> reversed(const Surface<S>& surface) {
  const Mesh& mesh = *surface.mesh;
  std::vector<int> corners;
  for (int f = 0; f < mesh.faces(); ++f) {
    const std::span<const int> old = mesh.corners(f);
    corners.push_back(old[0]);
    corners.insert(corners.end(), old.rbegin(), old.rend() - 1);
  }
  Surface<S> result = surface;
  result.mesh = std::make_shared<const Mesh>(make_mesh(mesh.vertices(), mesh.face_begin, corners));
  if (surface.tags.edge.empty()) return result;
  std::map<std::pair<int, int>, EdgeTag> tags;
  const auto ends = [](const Mesh& m, int e) {
    const int h = m.edge_half[Mesh::i(e)];
    return std::pair<int, int>(std::minmax({m.vertex[Mesh::i(h)], m.tip(h)}));
  };
  for (int e = 0; e < mesh.edges(); ++e) tags[ends(mesh, e)] = surface.tags.edge[Mesh::i(e)];
  for (int e = 0; e < mesh.edges(); ++e) result.tags.edge[Mesh::i(e)] = tags.at(ends(*result.mesh, e));
  return result;
}

template <class S>
Polyline<S> reversed(const Polyline<S>& curve) {
  Polyline<S> result = curve;
  result.points = curve.points.colwise().reverse();
  std::reverse(result.corner.begin(), result.corner.end());
  for (auto& [name, column] : result.attributes) std::reverse(column.begin(), column.end());
  return result;
}

template <class S>
std::vector<S> attribute_column(const Points<S>& points, const Value& values, CallContext& context) {
  const auto size = static_cast<std::size_t>(points.rows());
  const auto as_number = [](const Value& value, std::size_t i) {
    if (const auto* number = value.as<NumberValue>()) return number_as<S>(*number);
    throw wrong_type("the value of the attribute at vertex " + std::to_string(i), "a number", value);
  };
  if (values.as<NumberValue>()) return std::vector<S>(size, as_number(values, 0));
  std::vector<S> column;
  if (const auto* function = values.as<FunctionValue>()) {
    const std::size_t count = function->parameters.size();
    if (count > static_cast<std::size_t>(points.cols())) throw wrong_count(*function, static_cast<std::size_t>(points.cols()));
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      auto frame = std::make_shared<Environment>();
      frame->frame = true;
      frame->outer = function->scope;
      for (std::size_t p = 0; p < count; ++p)
        frame->names.emplace(function->parameters[p], number_of(points(i, static_cast<Eigen::Index>(p))));
      column.push_back(evaluate<S>(*function->body, Context<S>{}, *frame, context.bounds()).value());
    }
    return column;
  }
  const std::vector<Value> items = list_items(values, "values");
  if (items.size() != size)
    throw Error(
        ErrorKind::input, "E_ATTRIBUTE_SIZE",
        "the list has " + std::to_string(items.size()) + " values, but the shape has " + std::to_string(size) + " points");
  for (std::size_t i = 0; i < size; ++i) column.push_back(as_number(items[i], i));
  return column;
}

#define X(S)                                         \
  template Surface<S> reversed(const Surface<S>&);   \
  template Polyline<S> reversed(const Polyline<S>&); \
  template std::vector<S> attribute_column(const Points<S>&, const Value&, CallContext&);
X(double)
X(Algebraic)
#undef X

}  // namespace udcp
