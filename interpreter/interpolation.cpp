// Arguments of interpolation, and its table.
#include "interpreter/interpolation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "interpreter/formula.h"

namespace udcp {
namespace {

std::size_t by_name(const Arguments& a) { return a.positional.size(); }

/// One of some names as the enumerator in the same place.
template <class E>
E choice(const Arguments& a, std::string_view name, std::initializer_list<std::string_view> names) {
  return static_cast<E>(std::find(names.begin(), names.end(), choice_or(a, name, names)) - names.begin());
}

std::vector<char> flags(const Arguments& a, std::string_view name, int vertices) {
  std::vector<char> result;
  if (!a.find(name)) return result;
  result.assign(Mesh::i(vertices), 0);
  for (const int v : indices_from(*a.find(name), name, vertices)) result[Mesh::i(v)] = 1;
  return result;
}

/// At most so many significant digits, no locale.
std::string digits(double value, int count = 6) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, count);
  return {text.data(), end.ptr};
}

/// Angles of rounding errors are none.
std::string degrees(double radians) { return std::abs(radians) < 1e-12 ? "0" : digits(radians * 180 / std::numbers::pi); }

/// Points in a number type from points in another one that a shape may have.
template <class S, class From>
S number_from(const From& value) {
  if constexpr (std::is_same_v<From, double> && std::is_same_v<S, Rational>)
    return Rational::from_double(value);
  else if constexpr (std::is_same_v<From, Algebraic>)
    return number<S>(value);
  else
    return value;
}

template <class S>
Points<S> attribute_normals(const MeshValue& mesh, const std::string& prefix) {
  return std::visit(
      [&](const auto& surface) {
        Points<S> rows(surface.mesh->vertices(), 3);
        for (Eigen::Index c = 0; c < 3; ++c) {
          const std::string name = prefix + "xyz"[c];
          const auto column = surface.attributes.find(name);
          if (column == surface.attributes.end())
            throw Error(
                ErrorKind::input, "E_ATTRIBUTE", "the mesh has no attribute '" + name + "'",
                "normals from(\"" + prefix + "\") are in the attributes " + prefix + "x, " + prefix + "y and " + prefix + "z");
          for (Eigen::Index v = 0; v < rows.rows(); ++v) rows(v, c) = number_from<S>(column->second[static_cast<std::size_t>(v)]);
        }
        return rows;
      },
      mesh.shape);
}

bool has_normals(const MeshValue& mesh) {
  return std::visit(
      [](const auto& surface) {
        return surface.attributes.contains("nx") && surface.attributes.contains("ny") && surface.attributes.contains("nz");
      },
      mesh.shape);
}

template <class S>
S exact_or_double(const NumberValue& value) {
  if constexpr (std::is_same_v<S, Rational>)
    return number<Rational>(number_as<Algebraic>(value));
  else
    return number_as<S>(value);
}

template <class S>
void put_row(Points<S>& rows, Eigen::Index v, const Value& value) {
  const std::string name = "the normal of vertex " + std::to_string(v);
  const std::vector<Value> row = list_items(value, name);
  if (row.size() != 3)
    throw Error(ErrorKind::input, "E_DIMENSION", name + " has " + std::to_string(row.size()) + " coordinates; it must have 3");
  for (std::size_t c = 0; c < 3; ++c) {
    const auto* number = row[c].as<NumberValue>();
    if (!number) throw wrong_type("a coordinate of " + name, "a number", row[c]);
    rows(v, static_cast<Eigen::Index>(c)) = exact_or_double<S>(*number);
  }
}

/// A value of the language from a coordinate.
Value coordinate(double x) { return number_of(x); }
Value coordinate(const Rational& x) { return number_of(Algebraic(x)); }

template <class S>
Points<S> function_normals(const FunctionValue& function, const Surface<S>& surface, CallContext& context) {
  if (surface.points.cols() != 3) throw Error(ErrorKind::input, "E_DIMENSION", "normals need points of three coordinates");
  Points<S> rows(surface.points.rows(), 3);
  for (Eigen::Index v = 0; v < rows.rows(); ++v) {
    std::vector<Value> point;
    for (Eigen::Index c = 0; c < 3; ++c) point.push_back(coordinate(surface.points(v, c)));
    put_row(rows, v, call(function.name, std::move(point), {}, context));
  }
  return rows;
}

}  // namespace

InterpolateOptions interpolation_options(const Arguments& a, int vertices, CallContext& context) {
  InterpolateOptions options;
  if (a.find("lambda")) {
    const NumberValue lambda = need_number(a, by_name(a), "lambda");
    const auto* measured = std::get_if<double>(&lambda.value);
    options.lambda = measured ? Rational::from_double(*measured) : number<Rational>(number_as<Algebraic>(lambda));
  }
  options.step1 = choice<PointStep>(a, "step1", {"global", "local", "plain"});
  options.step2 = choice<NormalStep>(a, "step2", {"auto", "free", "tied", "rotate"});
  options.method = choice<InterpolationMethod>(a, "method", {"two_level", "literal", "kkt"});
  options.order = choice<SweepOrder>(a, "order", {"jacobi", "gauss", "average"});
  options.sweeps = whole_or(a, by_name(a), "sweeps", options.sweeps, 0, 100'000);
  options.flip = flag_or(a, by_name(a), "flip", false);
  options.skipped_points = flags(a, "free_points", vertices);
  options.skipped_normals = flags(a, "free_normals", vertices);
  options.control = run_control(context, "interpolate");
  return options;
}

template <class S>
Points<S> normals_argument(const Arguments& a, const Surface<S>& surface, const MeshValue& mesh, CallContext& context) {
  const Value* value = a.get(1, "normals");
  const auto* flag = value ? value->as<Boolean>() : nullptr;
  if (flag && !flag->value) return Points<S>(0, 3);
  if (!value || flag) return has_normals(mesh) ? attribute_normals<S>(mesh, "n") : area_normals(surface);
  if (const auto* text = value->as<TextValue>()) return attribute_normals<S>(mesh, text->value);
  if (const auto* function = value->as<FunctionValue>()) return function_normals(*function, surface, context);
  const std::vector<Value> items = list_items(*value, "normals");
  Points<S> rows(static_cast<Eigen::Index>(items.size()), 3);
  for (std::size_t v = 0; v < items.size(); ++v) put_row(rows, static_cast<Eigen::Index>(v), items[v]);
  return rows;
}
template Points<double> normals_argument(const Arguments&, const Surface<double>&, const MeshValue&, CallContext&);
template Points<Rational> normals_argument(const Arguments&, const Surface<Rational>&, const MeshValue&, CallContext&);

InterpolationRun run_interpolation(const Arguments& a, CallContext& context) {
  const MeshValue& mesh = need_mesh(a, 0);
  InterpolationRun run;
  run.cage = as_double(mesh);
  run.normals = normals_argument<double>(a, run.cage, mesh, context);
  run.options = interpolation_options(a, run.cage.mesh->vertices(), context);
  if (run.normals.rows() == 0 && a.get(1, "normals") && a.get(1, "normals")->as<ListValue>())
    check_normals(run.normals, run.cage.mesh->vertices(), run.options.skipped_normals);
  run.result = interpolate(run.cage, run.normals, run.options);
  if (context.output.warning)
    for (const std::string& note : run.result.notes) context.output.warning("interpolate: " + note);
  return run;
}

namespace {

constexpr std::size_t most_lines = 40;

std::string method_text(const InterpolateOptions& options) {
  static constexpr std::array steps1 = {"global", "local", "plain"};
  static constexpr std::array steps2 = {"auto", "free", "tied", "rotate"};
  static constexpr std::array methods = {"two_level", "literal", "kkt"};
  std::string text = std::string("method = ") + methods[static_cast<std::size_t>(options.method)] +
                     ", step1 = " + steps1[static_cast<std::size_t>(options.step1)];
  if (options.step1 == PointStep::global) text += ", lambda = " + options.lambda.to_string();
  return text + ", step2 = " + steps2[static_cast<std::size_t>(options.step2)];
}

Json vertex_json(const VertexReport& vertex, std::size_t v) {
  const auto or_null = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  return {{"vertex", v},
          {"angle_before", or_null(vertex.angle_before)},
          {"correction", to_string(vertex.correction)},
          {"displacement", or_null(vertex.displacement)},
          {"squared_displacement", or_null(vertex.squared_displacement)},
          {"length_ratio", or_null(vertex.length_ratio)},
          {"off_boundary", or_null(vertex.off_boundary)}};
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text + "  ";
}

/// All vertices in order, or those with the largest angles where they are many.
std::vector<std::size_t> shown(const std::vector<VertexReport>& vertices) {
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t v = 0; v < order.size(); ++v) order[v] = v;
  if (order.size() <= most_lines) return order;
  // by billionths of a radian, so that rounding does not choose among equal ones
  const auto key = [&](std::size_t v) {
    return std::isnan(vertices[v].angle_before) ? 4'000'000'000 : std::llround(vertices[v].angle_before * 1e9);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return key(x) > key(y); });
  order.resize(most_lines);
  return order;
}

void add_lines(const std::vector<VertexReport>& vertices, std::string& text) {
  if (vertices.empty()) return;
  text += "\nvertex  angle before  correction  displacement";
  for (const std::size_t v : shown(vertices)) {
    const VertexReport& vertex = vertices[v];
    const bool none = vertex.correction == Correction::none || vertex.correction == Correction::fixed ||
                      vertex.correction == Correction::no_plane;
    text += "\n" + padded(std::to_string(v), 6) + padded(none ? "-" : degrees(vertex.angle_before) + "\u00b0", none ? 12 : 13) +
            padded(to_string(vertex.correction), 10) +
            (none                          ? "-"
             : vertex.displacement < 1e-13 ? "0"
                                           : digits(vertex.displacement));
  }
  if (vertices.size() > most_lines)
    text += "\n(the " + std::to_string(most_lines) + " largest angles of " + std::to_string(vertices.size()) +
            "; save \"report.json\" has all)";
}

void add_method(const Interpolation& result, ReportValue& report) {
  for (const InterpolationErrors& errors : result.sweeps)
    report.json["sweeps"].push_back({{"position", errors.position}, {"normal", errors.normal}});
  if (!result.sweeps.empty()) {
    report.json["growth"] = result.growth;
    report.text += "\nsweeps: position error " + digits(result.sweeps.front().position) + " after the first, " +
                   digits(result.sweeps.back().position) + " after " + std::to_string(result.sweeps.size()) +
                   "; the last change was " + digits(result.growth) + " times the one before";
  }
  if (result.rows == 0) return;
  report.json["rank"] = result.rank;
  report.json["rows"] = result.rows;
  report.text += "\n" + std::to_string(result.rows) + " conditions of rank " + std::to_string(result.rank);
}

}  // namespace

ReportValue interpolation_table(const InterpolationRun& run) {
  const Interpolation& result = run.result;
  ReportValue report;
  report.text = "interpolation of " + std::to_string(run.cage.mesh->vertices()) + " vertices, " + method_text(run.options) +
                "\nlargest distance of a limit point from its vertex " + digits(result.errors.position, 3);
  if (run.normals.rows() > 0)
    report.text += ", largest angle of a limit normal with its normal " + digits(result.errors.normal, 3) + " (radians)";
  report.json = Json{{"kind", "interpolation"},
                     {"method", method_text(run.options)},
                     {"rounds", result.rounds},
                     {"position_error", result.errors.position},
                     {"normal_error", result.errors.normal},
                     {"reversed", result.errors.reversed},
                     {"notes", result.notes},
                     {"vertices", Json::array()}};
  if (result.is_closed) report.json["signed_volume"] = result.signed_volume;
  for (std::size_t v = 0; v < result.vertices.size(); ++v) report.json["vertices"].push_back(vertex_json(result.vertices[v], v));
  add_method(result, report);
  for (const std::string& note : result.notes) report.text += "\n" + note;
  add_lines(result.vertices, report.text);
  report.parts = {number_of(result.errors.position), number_of(result.errors.normal)};
  ListValue angles, displacements;
  for (const VertexReport& vertex : result.vertices) {
    angles.items.push_back(number_of(vertex.angle_before));
    displacements.items.push_back(number_of(vertex.displacement));
  }
  report.parts.push_back(Value{std::move(angles)});
  report.parts.push_back(Value{std::move(displacements)});
  return report;
}

}  // namespace udcp
