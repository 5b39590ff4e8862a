// Checkers of certificates about offsets of Loop surfaces. They derive weights, patches and enclosures from the word again and
// follow the lists of cells, axes and planes; they search for nothing.
#include "operators/interrupt.h"
#include "proofs/checkers.h"
#include "proofs/embedding_facts.h"
#include "proofs/offset_statements.h"

namespace udcp {
namespace {

LocalSet set_from(const Json& value) {
  require(value == "pair" || value == "star", "set must be \"pair\" or \"star\"");
  return value == "pair" ? LocalSet::pair : LocalSet::star;
}

void follow_cells(const OffsetErrorTest& test, const Points<Interval>& net, int depth, const std::string& code,
                  std::size_t& next) {
  require(next < code.size() && depth <= deepest_patch, "a text of cells ends early or goes too deep");
  const char symbol = code[next++];
  require(symbol == '0' || symbol == '1', "cells must consist of 0 and 1");
  if (symbol == '0') return require(test.accepts(net), "the bound does not hold on a cell");
  for (const Points<Interval>& child : test.children(net)) follow_cells(test, child, depth + 1, code, next);
}

/// Splits that a certificate may ask for, each of which keeps four pieces in memory.
constexpr int most_splits = 200'000;

void follow_planes(const EmbeddingFacts& facts, PatchPiece& a, PatchPiece& b, int depth, const std::string& code,
                   std::size_t& next, int& splits) {
  require(next < code.size() && depth <= deepest_patch, "a text of planes ends early or goes too deep");
  const char symbol = code[next++];
  if (symbol != '/') {
    require(symbol >= 'a' && symbol < 'a' + plane_directions, "planes must be letters a to m or /");
    return require(EmbeddingFacts::are_separated(a, b, symbol - 'a'), "a plane does not separate two patches");
  }
  require(++splits <= most_splits, "the planes ask for more than " + std::to_string(most_splits) + " splits");
  const bool first = depth % 2 == 0;
  for (PatchPiece& part : facts.parts(first ? a : b))
    follow_planes(facts, first ? part : a, first ? b : part, depth + 1, code, next, splits);
}

LoopMesh mesh_of(const Json& data, const std::string& rows) {
  Points<Rational> points = exact_rows_from(data[rows], 3, rows);
  const int vertices = static_cast<int>(points.rows());
  LoopMesh mesh = checked_loop_mesh(triangles_from(data["faces"], vertices), std::move(points));
  require_loop_word(data["word"], valences_of(*mesh.mesh));
  return mesh;
}

}  // namespace

std::string check_offset_contraction(const Json& data, StopFlag) {
  require_entries(data, {"word", "valence", "set", "bound"}, "data");
  const LocalSet set = set_from(data["set"]);
  const int valence = integer_from(data["valence"], 3, largest_contraction_valence(set), "valence");
  require_loop_word(data["word"], {valence});
  const Algebraic bound = contraction_bound(valence, set);
  require(to_json(bound) == data["bound"], "bound is not the sum of the moduli");
  require(bound < Algebraic(1), "bound is not below 1");
  return contraction_statement(valence, set, bound);
}

std::string check_offset_definite(const Json& data, StopFlag) {
  require_entries(data, {"word", "valence", "bound"}, "data");
  const int valence = integer_from(data["valence"], 3, 200, "valence");
  require_loop_word(data["word"], {valence});
  const Algebraic w = limit_weight(valence), half = Algebraic(valence) / Algebraic(2);
  require(w > half, "w is not above N/2");
  const Algebraic bound = (w - half) / (w + Algebraic(valence));
  require(to_json(bound) == data["bound"], "bound is not (w - N/2)/(w + N)");
  return definite_statement(valence, bound);
}

std::string check_offset_error(const Json& data, StopFlag stop) {
  const bool full = entry(data, "measure") == "full";
  if (full)
    require_entries(data, {"word", "faces", "vectors", "distance", "measure", "bound", "rounds", "cells", "points"}, "data");
  else
    require_entries(data, {"word", "faces", "vectors", "distance", "measure", "bound", "rounds", "cells"}, "data");
  require(full || data["measure"] == "eps", "measure must be \"full\" or \"eps\"");
  const Interval::Precision precision(offset_precision);
  LoopMesh surface = mesh_of(data, "vectors");
  const Points<Rational> vectors = surface.points;
  Points<Rational> points = Points<Rational>::Zero(vectors.rows(), 3);
  if (full) points = exact_rows_from(data["points"], 3, "points");
  require(vectors.rows() == points.rows(), "there must be one vector per vertex");
  surface.points.resize(points.rows(), 6);
  surface.points << points, vectors;
  const Rational distance = rational_from(data["distance"], "distance"), bound = rational_from(data["bound"], "bound");
  require(full || distance.sign() >= 0, "distance must not be negative where only lengths count");
  const EnclosedPatches patches = enclosed_patches(surface, integer_from(data["rounds"], 0, 1, "rounds"), stop);
  const OffsetErrorTest test(*surface.mesh, distance, full, bound);
  const Json& cells = data["cells"];
  require(cells.is_array() && cells.size() == patches.net.size(), "cells must have one text per face");
  for (std::size_t f = 0; f < cells.size(); ++f) {
    throw_if_stopped(stop);
    require(cells[f].is_string(), "cells must be texts");
    const auto code = cells[f].get<std::string>();
    std::size_t next = 0;
    follow_cells(test, patches.net[f], 0, code, next);
    require(next == code.size(), "a text of cells has something left over");
  }
  return error_statement(data, distance, full, bound);
}

std::string check_embedded_surface(const Json& data, StopFlag stop) {
  require_entries(data, {"word", "faces", "points", "rounds", "axes", "pairs"}, "data");
  const Interval::Precision precision(offset_precision);
  const LoopMesh surface = mesh_of(data, "points");
  const int rounds = integer_from(data["rounds"], 0, 4, "rounds");
  require(static_cast<long>(surface.mesh->faces()) << (2 * rounds) <= 4L * most_faces, "too many faces");
  EmbeddingFacts facts(surface, rounds, stop);
  const Json &axes = data["axes"], &pairs = data["pairs"];
  require(axes.is_array() && static_cast<int>(axes.size()) == facts.mesh().vertices(), "axes must have one entry per vertex");
  for (int v = 0; v < facts.mesh().vertices(); ++v) {
    throw_if_stopped(stop);
    const Json& axis = axes[static_cast<std::size_t>(v)];
    require(axis.is_array() && axis.size() == 3, "an axis must have three entries");
    const std::array<int, 3> direction{integer_from(axis[0], -100, 100, "an axis"), integer_from(axis[1], -100, 100, "an axis"),
                                       integer_from(axis[2], -100, 100, "an axis")};
    require(facts.is_graph(v, direction), "the surface around vertex " + std::to_string(v) + " is not seen to be a graph");
  }
  const std::vector<std::pair<int, int>> close = facts.close_pairs();
  require(pairs.is_array() && pairs.size() == close.size(), "pairs must list the pairs of faces whose boxes overlap");
  int splits = 0;
  for (std::size_t k = 0; k < close.size(); ++k) {
    throw_if_stopped(stop);
    const auto [f, g] = close[k];
    require(pairs[k].is_array() && pairs[k].size() == 3 && pairs[k][0] == f && pairs[k][1] == g && pairs[k][2].is_string(),
            "pairs must list the pairs of faces whose boxes overlap");
    const auto code = pairs[k][2].get<std::string>();
    std::size_t next = 0;
    follow_planes(facts, facts.piece(f), facts.piece(g), 0, code, next, splits);
    require(next == code.size(), "a text of planes has something left over");
  }
  return embedded_statement(data);
}

}  // namespace udcp
