// Checks of curves and surfaces, and their way from one number type to another. Knows no rule of subdivision.
#include "operators/surface.h"

#include "operators/polyline.h"

namespace udcp {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", std::string(what) + " has no exact value here", "start from exact numbers");
}

/// One value in the number type T. The overloads are the whole story: exact values go everywhere, doubles and enclosures never
/// become exact.
template <class T>
struct To {
  static T from(const Rational& value) { return number<T>(value); }
  static T from(const Algebraic& value) { return number<T>(value); }
  static T from(double) { refuse("a floating-point number"); }
  static T from(const Interval&) { refuse("an enclosure"); }
};
template <>
struct To<double> {
  static double from(const Rational& value) { return value.to_double(); }
  static double from(const Algebraic& value) { return value.to_double(); }
  static double from(double value) { return value; }
  static double from(const Interval& value) { return value.midpoint(); }
};
template <class T>
struct ToEnclosure {
  static T from(const Rational& value) { return number<T>(value); }
  static T from(const Algebraic& value) { return number<T>(value); }
  static T from(double value) { return number_from_double<T>(value); }
  static T from(const Interval& value) { return T(value); }
};
template <>
struct To<Interval> : ToEnclosure<Interval> {};
template <>
struct To<Jet> : ToEnclosure<Jet> {};

template <class T, class S>
Points<T> convert_points(const Points<S>& points) {
  Points<T> result(points.rows(), points.cols());
  for (Eigen::Index k = 0; k < points.size(); ++k) result.data()[k] = To<T>::from(points.data()[k]);
  return result;
}

template <class T, class S>
std::map<std::string, std::vector<T>> convert_attributes(const std::map<std::string, std::vector<S>>& attributes) {
  std::map<std::string, std::vector<T>> result;
  for (const auto& [name, values] : attributes) {
    auto& column = result[name];
    column.reserve(values.size());
    for (const S& value : values) column.push_back(To<T>::from(value));
  }
  return result;
}

void expect_size(std::size_t found, int expected, const char* code, const std::string& what) {
  if (found == static_cast<std::size_t>(expected)) return;
  throw Error(ErrorKind::input, code,
              what + ": " + std::to_string(found) + " values given, " + std::to_string(expected) + " needed");
}

template <class S>
void expect_attributes(const std::map<std::string, std::vector<S>>& attributes, int expected) {
  for (const auto& [name, values] : attributes) {
    expect_size(values.size(), expected, "E_ATTRIBUTE_SIZE", "attribute '" + name + "' needs one value per vertex");
  }
}

}  // namespace

template <class S>
void validate(const Polyline<S>& curve) {
  if (curve.points.cols() < 1 || curve.points.cols() > 3) {
    throw Error(ErrorKind::input, "E_DIMENSION",
                "the points of a curve have one to three coordinates, not " + std::to_string(curve.points.cols()));
  }
  validate_columns(curve);
}

template <class S>
void validate_columns(const Polyline<S>& curve) {
  if (curve.points.cols() < 1) throw Error(ErrorKind::input, "E_DIMENSION", "the points of a curve need at least one coordinate");
  const int least = curve.closed ? 3 : 2;
  if (curve.size() < least) {
    throw Error(ErrorKind::input, "E_POINTS",
                std::string(curve.closed ? "a closed" : "an open") + " curve needs at least " + std::to_string(least) +
                    " points, not " + std::to_string(curve.size()));
  }
  if (!curve.corner.empty()) expect_size(curve.corner.size(), curve.size(), "E_TAGS", "corner tags need one value per point");
  expect_attributes(curve.attributes, curve.size());
}

template <class S>
void validate(const Surface<S>& surface) {
  if (!surface.mesh || surface.mesh->faces() == 0) throw Error(ErrorKind::input, "E_NO_FACES", "the surface has no face");
  const Mesh& mesh = *surface.mesh;
  if (surface.points.cols() < 1)
    throw Error(ErrorKind::input, "E_DIMENSION", "the points of a surface need at least one coordinate");
  expect_size(static_cast<std::size_t>(surface.points.rows()), mesh.vertices(), "E_POINTS",
              "a surface needs one point per vertex");
  if (!surface.tags.edge.empty())
    expect_size(surface.tags.edge.size(), mesh.edges(), "E_TAGS", "edge tags need one value per edge");
  if (!surface.tags.corner.empty()) {
    expect_size(surface.tags.corner.size(), mesh.vertices(), "E_TAGS", "corner tags need one value per vertex");
  }
  expect_attributes(surface.attributes, mesh.vertices());
}

template <class T, class S>
Polyline<T> convert(const Polyline<S>& curve) {
  return {convert_points<T>(curve.points), curve.closed, curve.corner, convert_attributes<T>(curve.attributes)};
}

template <class T, class S>
Surface<T> convert(const Surface<S>& surface) {
  return {surface.mesh, convert_points<T>(surface.points), surface.tags, convert_attributes<T>(surface.attributes)};
}

#define UDCP_CONVERT(T, S)                                \
  template Polyline<T> convert<T, S>(const Polyline<S>&); \
  template Surface<T> convert<T, S>(const Surface<S>&);
#define UDCP_FROM_DOUBLE(T) UDCP_CONVERT(T, double)
#define UDCP_FROM_RATIONAL(T) UDCP_CONVERT(T, udcp::Rational)
#define UDCP_FROM_ALGEBRAIC(T) UDCP_CONVERT(T, udcp::Algebraic)
#define UDCP_FROM_INTERVAL(T) UDCP_CONVERT(T, udcp::Interval)
#define UDCP_VALIDATE(S)                              \
  template void validate(const Polyline<S>&);         \
  template void validate_columns(const Polyline<S>&); \
  template void validate(const Surface<S>&);
UDCP_FOR_EACH_NUMBER(UDCP_FROM_DOUBLE)
UDCP_FOR_EACH_NUMBER(UDCP_FROM_RATIONAL)
UDCP_FOR_EACH_NUMBER(UDCP_FROM_ALGEBRAIC)
UDCP_FOR_EACH_NUMBER(UDCP_FROM_INTERVAL)
UDCP_FOR_EACH_NUMBER(UDCP_VALIDATE)
#undef UDCP_VALIDATE
#undef UDCP_FROM_INTERVAL
#undef UDCP_FROM_ALGEBRAIC
#undef UDCP_FROM_RATIONAL
#undef UDCP_FROM_DOUBLE
#undef UDCP_CONVERT

}  // namespace udcp
