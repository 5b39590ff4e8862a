// The parts of report: numbers, matrices and shapes as text and JSON. Only report*.cpp and the tests of report see them.
#pragma once

#include <string>

#include "interpreter/value.h"

namespace udcp {

/// Exact text of a number, without its decimals: "p/q", "2*pi/5", "1/4 + sqrt(5)/4".
std::string exact_text(const Quantity<Algebraic>& number);
/// The decimal expansion cut off after `digits` significant digits, every one of them correct, and an ellipsis: "-0.121243…".
/// Without an ellipsis where the expansion ends by itself.
std::string decimals(const Quantity<Algebraic>& number, int digits);
/// Exact text, followed by "  (= -0.121243…)" where the exact text alone says little about the size.
std::string number_text(const NumberValue& number);
/// At most so many significant digits, no locale: "0.1", "1e-20".
std::string double_text(double value, int digits = 12);

Json number_json(const Quantity<Algebraic>& number);
Json number_json(const Algebraic& number);
Json number_json(const Interval& number);
Json number_json(const Parametric& number);
Json number_json(double number);

std::string matrix_text(const MatrixValue& matrix);
Json matrix_json(const MatrixValue& matrix);

/// One line: counts, dimension, exact or double, bounding box.
std::string curve_text(const CurveValue& curve);
std::string mesh_text(const MeshValue& mesh);
/// With all points; of a mesh only below `most_vertices`, else the summary.
Json curve_json(const CurveValue& curve);
Json mesh_json(const MeshValue& mesh, int most_vertices = 10'000);

}  // namespace udcp
