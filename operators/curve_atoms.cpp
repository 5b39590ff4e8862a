// U, D and P on open and closed curves. push-back, eqs. (1) to (3); the dual of an open curve keeps its ends.
#include <string>

#include "operators/atoms.h"
#include "operators/columns.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// Rows of the dual along the curve: corner i if point i is one, then edge i if there is one.
template <class S, class Corner, class Edge>
void walk_dual(const Polyline<S>& shape, Corner corner, Edge edge) {
  int row = 0;
  for (int i = 0; i < shape.size(); ++i) {
    if (shape.is_corner(i)) corner(i, row++);
    if (i < shape.edges()) edge(i, i + 1 == shape.size() ? 0 : i + 1, row++);
  }
}

template <class S>
int dual_rows(const Polyline<S>& shape) {
  int corners = 0;
  for (int i = 0; i < shape.size(); ++i) corners += shape.is_corner(i);
  return shape.edges() + corners;
}

}  // namespace

template <class S>
Points<S> split_points(const Polyline<S>& shape, const Points<S>& rows, int sections) {
  const int d = sections, edges = shape.edges();
  Points<S> fine = Points<S>::Zero(shape.size() + (d - 1) * edges, rows.cols());
  for (int i = 0; i < shape.size(); ++i) {
    add(fine, d * i, S(1), rows, i);
    if (i >= edges) break;
    const int j = i + 1 == shape.size() ? 0 : i + 1;
    for (int s = 1; s < d; ++s) {
      add(fine, d * i + s, S(S(d - s) / S(d)), rows, i);
      add(fine, d * i + s, S(S(s) / S(d)), rows, j);
    }
  }
  return fine;
}

template <class S>
Polyline<S> up(const Polyline<S>& shape, int sections) {
  Polyline<S> fine;
  fine.closed = shape.closed;
  fine.points = split_points(shape, shape.points, sections);
  if (!shape.corner.empty()) {
    fine.corner.assign(at(fine.size()), 0);
    for (int i = 0; i < shape.size(); ++i) fine.corner[at(sections * i)] = shape.corner[at(i)];
  }
  for (const auto& [name, column] : shape.attributes)
    fine.attributes[name] = as_column(split_points(shape, as_rows(column), sections));
  return fine;
}

template <class S>
Points<S> to_dual(const Polyline<S>& shape, const KernelWeights<S>* weights) {
  Points<S> dual = Points<S>::Zero(dual_rows(shape), shape.points.cols());
  const S one(1);
  const auto weight = [&](int i) -> const S& {
    return weights != nullptr && i % weights->sections == 0 ? weights->f.plain[i] : one;
  };
  walk_dual(
      shape, [&](int i, int row) { add(dual, row, one, shape.points, i); },
      [&](int i, int j, int row) {
        const S sum = weight(i) + weight(j);
        if (!is_nonzero(sum))
          throw Error(ErrorKind::input, "E_WEIGHT",
                      "the weights of D at the ends of edge " + std::to_string(i) + " sum to " + to_text(sum) +
                          ", so they have no average",
                      "choose a kernel f with 1 + f nonzero");
        add(dual, row, S(weight(i) / sum), shape.points, i);
        add(dual, row, S(weight(j) / sum), shape.points, j);
      });
  return dual;
}

template <class S>
Points<S> to_primal(const Polyline<S>& shape, const Points<S>& dual) {
  Points<S> points = Points<S>::Zero(shape.size(), dual.cols());
  const S one(1), half = S(1) / S(2);
  walk_dual(
      shape, [&](int i, int row) { add(points, i, one, dual, row); },
      [&](int i, int j, int row) {
        for (const int end : {i, j})
          if (!shape.is_corner(end)) add(points, end, half, dual, row);
      });
  return points;
}

template <class S>
Polyline<S> realise_dual(const Polyline<S>& shape, const Points<S>& dual) {
  Polyline<S> result;
  result.closed = shape.closed;
  result.points = dual;
  if (!shape.corner.empty()) {
    result.corner.assign(at(dual_rows(shape)), 0);
    walk_dual(
        shape, [&](int i, int row) { result.corner[at(row)] = shape.corner[at(i)]; }, [](int, int, int) {});
  }
  for (const auto& [name, column] : shape.attributes) {
    Polyline<S> carrier{as_rows(column), shape.closed, shape.corner, {}};
    result.attributes[name] = as_column(to_dual<S>(carrier, nullptr));
  }
  return result;
}

template <class S>
Points<S> push_back(Points<S> current, const Polyline<S>& before, int sections, const PushBack<S>& parameters) {
  Points<S> delta = Points<S>::Zero(before.size(), current.cols());
  for (int i = 0; i < before.size(); ++i) {
    if (before.is_corner(i)) continue;
    const S& d = parameters.delta[sections * i];
    add(delta, i, d, before.points, i);
    add(delta, i, S(-d), current, sections * i);
  }
  const Points<S> spread = split_points(before, delta, sections);
  for (int i = 0; i < static_cast<int>(current.rows()); ++i)
    add(current, i, i % sections == 0 ? S(1) : parameters.omega.plain[i], spread, i);
  return current;
}

#define UDCP_INSTANTIATE(S)                                                   \
  template Points<S> split_points(const Polyline<S>&, const Points<S>&, int); \
  template Polyline<S> up(const Polyline<S>&, int);                           \
  template Points<S> to_dual(const Polyline<S>&, const KernelWeights<S>*);    \
  template Points<S> to_primal(const Polyline<S>&, const Points<S>&);         \
  template Polyline<S> realise_dual(const Polyline<S>&, const Points<S>&);    \
  template Points<S> push_back(Points<S>, const Polyline<S>&, int, const PushBack<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
