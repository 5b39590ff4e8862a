// A polygon mesh with points, tags and per-vertex attributes. The connectivity is shared: C and P copy none of it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "operators/mesh.h"
#include "operators/number.h"
#include "operators/tags.h"

namespace udcp {

template <class S>
struct Surface {
  std::shared_ptr<const Mesh> mesh;
  Points<S> points;  // a row per vertex, one to three columns (any number in matrix.h)
  Tags tags;
  std::map<std::string, std::vector<S>> attributes;  // v.name, a column per name, a value per vertex
};

/// Throws Error{input}: no mesh (E_NO_FACES), no column (E_DIMENSION), not a row per vertex (E_POINTS), tags (E_TAGS) or
/// attributes (E_ATTRIBUTE_SIZE) that do not fit the mesh. A corner inside is left to the dual (E_CORNER).
template <class S>
void validate(const Surface<S>& surface);

/// The same shape in another number type: rounded to nearest (double), exact or enclosed. What has no exact value throws
/// Error{not_exact, "E_NOT_EXACT"}: anything from double or Interval to an exact type, irrational numbers to Rational or
/// Parametric. From the types that coordinates have to every type.
template <class T, class S>
Surface<T> convert(const Surface<S>& surface);

}  // namespace udcp
