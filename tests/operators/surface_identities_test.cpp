// Words on meshes against formulas: averaging Doo-Sabin, Zorin-Schroeder, the regular part of U C^k P, and what commutes with
// words.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/polynomial.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

using Row = Eigen::Matrix<Rational, 1, Eigen::Dynamic>;

Row mean(const Points<Rational>& points, std::span<const int> which) {
  Row sum = Row::Zero(points.cols());
  for (const int v : which) sum += points.row(v);
  return sum / Rational(static_cast<int>(which.size()));
}

// A torus of n by n quads: vertex (i, j) is j n + i. Where the points of its U lie, on a torus of 2n by 2n places.
constexpr int side = 6;
const Mesh& regular_mesh() {
  static const Mesh mesh = *torus<double>(side, side, 2, 1).mesh;
  return mesh;
}

std::vector<std::pair<int, int>> places() {
  const Mesh& mesh = regular_mesh();
  const auto old_points = static_cast<std::size_t>(mesh.vertices()), edges = static_cast<std::size_t>(mesh.edges());
  std::vector<std::pair<int, int>> result(old_points + edges + static_cast<std::size_t>(mesh.faces()));
  const auto wrap = [](int x, int y) { return std::pair{x % (2 * side), y % (2 * side)}; };
  for (int f = 0; f < mesh.faces(); ++f) {
    const int i = mesh.corners(f)[0] % side, j = mesh.corners(f)[0] / side;
    const int h = mesh.face_begin[Mesh::i(f)];
    result[Mesh::i(mesh.corners(f)[0])] = {2 * i, 2 * j};
    const int dx[] = {1, 2, 1, 0}, dy[] = {0, 1, 2, 1};
    for (int k = 0; k < 4; ++k) result[old_points + Mesh::i(mesh.edge[Mesh::i(h + k)])] = wrap(2 * i + dx[k], 2 * j + dy[k]);
    result[old_points + edges + Mesh::i(f)] = wrap(2 * i + 1, 2 * j + 1);
  }
  return result;
}

// Every coefficient of the symbol where the points of one round on a unit vector are, and nothing elsewhere.
void compare_with_symbol(const Word& word, const Laurent<Rational>& symbol) {
  Surface<Rational> surface{std::make_shared<const Mesh>(regular_mesh()), Points<Rational>::Zero(side * side, 1), {}, {}};
  surface.points(0, 0) = Rational(1);
  const Points<Rational> fine = run(word, surface, 1).points;
  const auto where = places();
  std::map<std::pair<int, int>, Rational> expected;
  const auto wrap = [](int x) { return (x % (2 * side) + 2 * side) % (2 * side); };
  for (const auto& [p, s] : symbol) expected[{wrap(p.first), wrap(p.second)}] += s;
  int different = 0;
  for (std::size_t k = 0; k < where.size(); ++k) different += fine(static_cast<Eigen::Index>(k), 0) != expected[where[k]];
  CHECK(different == 0);
}

Laurent<Rational> line(std::initializer_list<std::pair<int, Rational>> terms, int variable) {
  Laurent<Rational> result;
  for (const auto& [exponent, s] : terms) result[variable == 0 ? std::pair{exponent, 0} : std::pair{0, exponent}] = s;
  return result;
}

// The even part of a mask, kept at even exponents: v(z^2).
Laurent<Rational> even_part(const Laurent<Rational>& symbol) {
  Laurent<Rational> result;
  for (const auto& [p, s] : symbol)
    if (p.first % 2 == 0 && p.second % 2 == 0) result[p] = s;
  return result;
}

const Laurent<Rational> one{{{0, 0}, Rational(1)}};

// Faces as cycles of points in words, from the smallest corner on: equal for meshes that differ in numbering only.
std::set<std::vector<std::string>> canonical(const Surface<Rational>& surface) {
  std::vector<std::string> name;
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    name.emplace_back();
    for (Eigen::Index c = 0; c < surface.points.cols(); ++c) name.back() += surface.points(v, c).to_string() + " ";
  }
  std::set<std::vector<std::string>> faces;
  for (int f = 0; f < surface.mesh->faces(); ++f) {
    std::vector<std::string> cycle;
    for (const int v : surface.mesh->corners(f)) cycle.push_back(name[Mesh::i(v)]);
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    faces.insert(cycle);
  }
  return faces;
}

Surface<Rational> renumbered(Dice& dice, const Surface<Rational>& surface) {
  const int n = surface.mesh->vertices();
  std::vector<int> to(Mesh::i(n));
  for (int v = 0; v < n; ++v) to[Mesh::i(v)] = v;
  for (int v = n - 1; v > 0; --v) std::swap(to[Mesh::i(v)], to[Mesh::i(dice.below(v + 1))]);
  Faces faces = faces_of(*surface.mesh);
  for (std::size_t k = faces.size() - 1; k > 0; --k)
    std::swap(faces[k], faces[static_cast<std::size_t>(dice.below(static_cast<int>(k) + 1))]);
  for (auto& face : faces) {
    for (int& v : face) v = to[Mesh::i(v)];
    std::rotate(face.begin(), face.begin() + dice.below(static_cast<int>(face.size())), face.end());
  }
  Surface<Rational> result{std::make_shared<const Mesh>(make_mesh(n, faces)), surface.points, {}, {}};
  for (int v = 0; v < n; ++v) result.points.row(to[Mesh::i(v)]) = surface.points.row(v);
  return result;
}

std::vector<NamedMesh> all_meshes() {
  auto meshes = quad_meshes();
  for (auto& m : polygon_meshes()) meshes.push_back(std::move(m));
  return meshes;
}

// "U3" where every face is a quad only.
std::vector<std::string> words_for(const Mesh& mesh) {
  std::vector<std::string> words{"UCP", "UCCP", "UDD", "UD"};
  if (mesh.all_faces_have(4)) words.emplace_back("U3CP");
  return words;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("UD is the averaging Doo-Sabin scheme") {
    for (const NamedMesh& named : all_meshes()) {
      CAPTURE(named.name);
      const Mesh& mesh = named.mesh;
      const Surface<Rational> surface{std::make_shared<const Mesh>(mesh), Points<Rational>::Zero(mesh.vertices(), 1), {}, {}};
      const Points<Rational> matrix = subdivision_matrix<Rational>(operation("UD"), surface);
      for (int h = 0; h < mesh.half_edges(); ++h) {
        const int n = mesh.size(mesh.face[Mesh::i(h)]);
        Points<Rational> expected = Points<Rational>::Zero(1, mesh.vertices());
        for (const int v : mesh.corners(mesh.face[Mesh::i(h)])) expected(0, v) = ratio(1, 4 * n);
        expected(0, mesh.vertex[Mesh::i(h)]) += ratio(1, 2);
        expected(0, mesh.tip(h)) += ratio(1, 8);
        expected(0, mesh.vertex[Mesh::i(mesh.prev(h))]) += ratio(1, 8);
        CHECK(matrix.row(h) == expected.row(0));
        if (n == 4) CHECK(matrix(h, mesh.vertex[Mesh::i(h)]) == ratio(9, 16));
      }
    }
  }

  TEST_CASE("UDD is the primal scheme of degree 3 by Zorin and Schroeder") {
    Dice dice(31);
    for (const NamedMesh& named : all_meshes()) {
      CAPTURE(named.name);
      const auto surface = random_surface<Rational>(dice, named.mesh);
      const auto fine = run(scheme("UDD"), surface, 1);
      for (int v = 0; v < named.mesh.vertices(); ++v) {
        if (named.mesh.on_boundary(v)) continue;
        std::vector<int> neighbours;
        Row faces = Row::Zero(3);
        for (int h = 0; h < named.mesh.half_edges(); ++h) {
          if (named.mesh.vertex[Mesh::i(h)] != v) continue;
          neighbours.push_back(named.mesh.tip(h));
          faces += mean(surface.points, named.mesh.corners(named.mesh.face[Mesh::i(h)])) / Rational(named.mesh.valence(v));
        }
        const Row expected =
            surface.points.row(v) / Rational(2) + mean(surface.points, neighbours) / Rational(4) + faces / Rational(4);
        CHECK(fine.points.row(v) == expected);
      }
    }
  }

  TEST_CASE("the regular part of U C^k P has the symbol c c + delta g g (1 - v v)") {
    Dice dice(32);
    for (int k = 1; k <= 3; ++k) {
      for (int trial = 0; trial < 4; ++trial) {
        const Rational f = dice.positive(), omega = dice.fraction(), delta = dice.fraction();
        CAPTURE(k);
        CAPTURE(f.to_string());
        CAPTURE(omega.to_string());
        CAPTURE(delta.to_string());
        const std::string convolved = "U" + std::string(static_cast<std::size_t>(k), 'C');
        const Mask<Rational> c = mask<Rational>(scheme(convolved, constant(f)));
        const auto cu = symbol(c, 0), cv = symbol(c, 1);
        const Rational half = omega / Rational(2);
        const auto gu = line({{-1, half}, {0, Rational(1)}, {1, half}}, 0),
                   gv = line({{-1, half}, {0, Rational(1)}, {1, half}}, 1);
        const auto kept = one + Rational(-1) * (even_part(cu) * even_part(cv));
        compare_with_symbol(scheme(convolved + "P", constant(f), constant(omega), constant(delta)),
                            cu * cv + delta * (gu * gv * kept));
      }
    }
  }

  TEST_CASE("UCP with all ones has the edge and face formula and is no tensor product") {
    const auto second = [](int variable) { return line({{-2, Rational(1)}, {0, Rational(-2)}, {2, Rational(1)}}, variable); };
    const auto halves = [](int variable) { return line({{-1, ratio(1, 2)}, {1, ratio(1, 2)}}, variable); };
    const auto su = second(0), sv = second(1);
    const auto cross = ratio(-1, 64) * (su * sv);
    const auto edge_u = halves(0) * (one + ratio(-1, 8) * su + cross), edge_v = halves(1) * (one + ratio(-1, 8) * sv + cross);
    const auto face = halves(0) * halves(1) * (one + ratio(-1, 8) * (su + sv) + cross);
    compare_with_symbol(scheme("UCP"), one + edge_u + edge_v + face);
    const Mask<Rational> curve = mask<Rational>(scheme("UCP"));
    const auto tensor = symbol(curve, 0) * symbol(curve, 1);
    const auto mesh = one + edge_u + edge_v + face;
    CHECK(tensor.at({3, 3}) == ratio(1, 256));
    CHECK(mesh.at({3, 3}) == ratio(-1, 256));
  }

  TEST_CASE("with delta 0 the regular part is the tensor product") {
    const Mask<Rational> curve = mask<Rational>(scheme("UCCP", value(3, 5), value(7, 3), value(0)));
    compare_with_symbol(scheme("UCCP", value(3, 5), value(7, 3), value(0)), symbol(curve, 0) * symbol(curve, 1));
  }

  TEST_CASE("words commute with affine maps and keep lines on lines") {
    Dice dice(33);
    for (const NamedMesh& named : all_meshes()) {
      for (const std::string& atoms : words_for(named.mesh)) {
        CAPTURE(named.name);
        CAPTURE(atoms);
        const Word word = scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
        Surface<Rational> surface = random_surface<Rational>(dice, named.mesh);
        const Points<Rational> map = random_points<Rational>(dice, 3, 3), shift = random_points<Rational>(dice, 1, 3);
        const auto moved = [&](const Points<Rational>& points) {
          Points<Rational> result = points * map;
          for (Eigen::Index v = 0; v < result.rows(); ++v) result.row(v) += shift.row(0);
          return result;
        };
        const Points<Rational> fine = run(word, surface, 1).points;
        surface.points = moved(surface.points);
        CHECK(run(word, surface, 1).points == moved(fine));
        for (Eigen::Index v = 0; v < surface.points.rows(); ++v)
          surface.points.row(v) = shift.row(0) + dice.fraction() * map.row(0);
        const Points<Rational> straight = run(word, surface, 1).points;
        for (Eigen::Index v = 0; v < straight.rows(); ++v) {
          const Points<Rational> from = straight.row(v) - shift.row(0);
          CHECK(from(0, 0) * map(0, 1) == from(0, 1) * map(0, 0));
          CHECK(from(0, 1) * map(0, 2) == from(0, 2) * map(0, 1));
        }
      }
    }
  }

  TEST_CASE("words do not look at the numbering of vertices and faces") {
    Dice dice(34);
    for (const NamedMesh& named : all_meshes()) {
      for (const std::string& atoms : words_for(named.mesh)) {
        CAPTURE(named.name);
        CAPTURE(atoms);
        const Word word = scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
        const Surface<Rational> surface = random_surface<Rational>(dice, named.mesh), other = renumbered(dice, surface);
        CHECK(canonical(run(word, surface, 1)) == canonical(run(word, other, 1)));
      }
    }
  }

  TEST_CASE("triangle words do not look at the numbering either") {
    Dice dice(35);
    for (const NamedMesh& named : triangle_meshes()) {
      for (const char* atoms : {"UCP", "UCCP", "U3CP"}) {
        CAPTURE(named.name);
        CAPTURE(atoms);
        const Word word =
            on_triangles(scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction())));
        const Surface<Rational> surface = random_surface<Rational>(dice, named.mesh), other = renumbered(dice, surface);
        CHECK(canonical(run(word, surface, 1)) == canonical(run(word, other, 1)));
      }
    }
  }
}
