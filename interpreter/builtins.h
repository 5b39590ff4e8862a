// The table of functions of the language, one row each; the definitions stand in builtins_*.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/value.h"

namespace udcp {

/// What a builtin sees of the running session.
struct CallContext;

/// Arguments of a call, evaluated: positional ones, then named ones.
struct Arguments {
  std::vector<Value> positional;
  std::vector<std::pair<std::string, Value>> named;
  [[nodiscard]] const Value* find(std::string_view name) const;
  /// The argument at a position, or the one with this name; null if it was left away.
  [[nodiscard]] const Value* get(std::size_t position, std::string_view name) const;
};

struct Builtin {
  std::string_view name;
  std::string_view signature;  // "cube()", "polygon(corners, radius = 1)"
  std::string_view help;       // one sentence
  int least = 0, most = 0;     // positional arguments
  std::vector<std::string_view> named;
  Value (*call)(CallContext&, const Arguments&);
  /// Where set, a call gets its arguments unevaluated: counts, which must not refine.
  Value (*special)(CallContext&, const grammar::Call&) = nullptr;
};

/// All of them, sorted by name.
std::span<const Builtin> builtins();
const Builtin* find_builtin(std::string_view name);

std::vector<Builtin> builtins_geometry();       // cube, polygon, curve, mesh, grid, tube, torus
std::vector<Builtin> builtins_shapes();         // tag, attribute, triangulate, scale, points, faces, …
std::vector<Builtin> builtins_words();          // mask, stencils, matrix, support, limit, counts, …
std::vector<Builtin> builtins_files();          // load, load_curve, save, plot
std::vector<Builtin> builtins_math();           // type, length, sum, approx, approximate, …
std::vector<Builtin> builtins_symbols();        // sum_rules, reproduction, limit_stencil, asymptotic, …
std::vector<Builtin> builtins_regularity();     // differences, cones, jacobian
std::vector<Builtin> builtins_interpolation();  // interpolate, interpolation_report, interpolation_figure, its claims
std::vector<Builtin> builtins_filling();        // fill_g2, tessellate, joins, curvature, compare_fill, hybrid, g2
std::vector<Builtin> builtins_offset();         // offset, offset_report, offset_error, self_intersections, its claims
std::vector<Builtin> builtins_proofs();         // claims, eigenvalues, regions

}  // namespace udcp
