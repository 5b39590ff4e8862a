// Every scheme of the prelude against a definition that does not come from the atoms: masks in closed form, textbook schemes,
// circles.
#include <doctest/doctest.h>

#include <fstream>

#include "interpreter/session.h"
#include "operators/matrix.h"
#include "operators/run.h"
#include "tests/oracle/catmull_clark.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/loop.h"

namespace {

using namespace udcp;

Session& session() {
  static Session loaded = [] {
    Session s;
    s.load_prelude();
    return s;
  }();
  return loaded;
}

Word word(const std::string& text) { return session().run(text).as<WordValue>()->word; }

Algebraic fraction(int p, int q) { return Algebraic(Rational(p) / Rational(q)); }

std::vector<Algebraic> mask_of(const std::string& text, int round = 0) { return mask<Algebraic>(word(text), round).coefficients; }

/// Differences are shown, not whole matrices.
void check_same(const Points<Algebraic>& a, const Points<Algebraic>& b) {
  REQUIRE(a.rows() == b.rows());
  REQUIRE(a.cols() == b.cols());
  int different = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) different += a.data()[i] == b.data()[i] ? 0 : 1;
  CHECK(different == 0);
}

std::vector<Algebraic> times(const std::vector<Algebraic>& a, const std::vector<Algebraic>& b) {
  std::vector<Algebraic> product(a.size() + b.size() - 1, Algebraic(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
  return product;
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("bspline and its relatives have binomial masks") {
    std::vector<Algebraic> binomial = {Algebraic(1), Algebraic(1)};
    for (int m = 0; m <= 6; ++m) {
      binomial = times(binomial, {Algebraic(1), Algebraic(1)});  // (1 + z)^(m+2)
      std::vector<Algebraic> expected = binomial;
      for (Algebraic& c : expected) c /= Algebraic(1 << (m + 1));
      CAPTURE(m);
      CHECK(mask_of("bspline(" + std::to_string(m) + ")") == expected);
      if (m == 1) CHECK(mask_of("chaikin") == expected);
      if (m == 2) CHECK(mask_of("cubic") == expected);
      if (m == 4) CHECK(mask_of("quintic") == expected);
    }
  }

  TEST_CASE("cbspline has the symbol of exponential splines") {
    // (1 + z)^m (1 + 2 f z + z^2)/(2^m (1 + f)), f = cos(alpha/2); with k = 6, f = cos(pi/6) in round 0 and cos(pi/12) in
    // round 1.
    for (int round = 0; round < 2; ++round) {
      const Algebraic f = Algebraic::cosine(Rational(1) / Rational(round == 0 ? 6 : 12));
      std::vector<Algebraic> expected = {Algebraic(1), Algebraic(2) * f, Algebraic(1)};
      for (int i = 0; i < 3; ++i) expected = times(expected, {fraction(1, 2), fraction(1, 2)});
      for (Algebraic& c : expected) c /= Algebraic(1) + f;
      CHECK(mask_of("cbspline(3, 6)", round) == expected);
    }
  }

  TEST_CASE("four_point has its mask") {
    const Algebraic w = fraction(1, 20), zero(0), half = fraction(1, 2);
    CHECK(mask_of("four_point(1/20)") == std::vector<Algebraic>{-w, zero, half + w, Algebraic(1), half + w, zero, -w});
  }

  TEST_CASE("circle and circle_through have the mask of the paper") {
    // [-b, a, 1/2 + b, 1 - 2a, 1/2 + b, a, -b], a = (1 - delta)/(4(1 + f)), b = omega delta/(8(1 + f)), omega = 1/f.
    const Algebraic f = Algebraic::cosine(Rational(1) / Rational(5)), one(1), half = fraction(1, 2);
    const auto expected = [&](const Algebraic& delta) {
      const Algebraic a = (one - delta) / (Algebraic(4) * (one + f)), b = delta / (Algebraic(8) * f * (one + f));
      return std::vector<Algebraic>{-b, a, half + b, one - Algebraic(2) * a, half + b, a, -b};
    };
    CHECK(mask_of("circle(5)") == expected(fraction(4, 5)));
    CHECK(mask_of("circle_through(5)") == expected(one));
  }

  TEST_CASE("catmull_clark is the textbook scheme on all polygon meshes") {
    oracle::Dice dice(1);
    const Word scheme = word("catmull_clark");
    std::vector<oracle::NamedMesh> meshes = oracle::quad_meshes();
    for (oracle::NamedMesh& m : oracle::polygon_meshes()) meshes.push_back(std::move(m));
    for (const oracle::NamedMesh& named : meshes) {
      const Mesh& mesh = named.mesh;
      CAPTURE(named.name);
      const Surface<Algebraic> start = oracle::random_surface<Algebraic>(dice, mesh);
      const auto expected = oracle::catmull_clark_step(oracle::faces_of(mesh), start.points);
      const Surface<Algebraic> found = run(scheme, start, 1);
      CHECK(oracle::faces_of(*found.mesh) == expected.faces);
      check_same(found.points, expected.points);
    }
  }

  TEST_CASE("loop is the textbook scheme on all triangle meshes") {
    oracle::Dice dice(2);
    const Word scheme = word("loop");
    for (const oracle::NamedMesh& named : oracle::triangle_meshes()) {
      const Mesh& mesh = named.mesh;
      CAPTURE(named.name);
      const Surface<Algebraic> start = oracle::random_surface<Algebraic>(dice, mesh);
      const auto expected = oracle::loop_step(oracle::faces_of(mesh), start.points);
      check_same(run(scheme, start, 1).points, expected.points);
    }
  }

  TEST_CASE("doo_sabin_averaging takes the mean of vertex and edge midpoints and face mean") {
    oracle::Dice dice(3);
    for (const Mesh& mesh : {oracle::dodecahedron(), oracle::prism(5)}) {
      const Surface<Algebraic> start = oracle::random_surface<Algebraic>(dice, mesh);
      Points<Algebraic> expected(mesh.half_edges(), 3);
      for (int h = 0; h < mesh.half_edges(); ++h) {
        const int f = mesh.face[Mesh::i(h)], v = mesh.vertex[Mesh::i(h)];
        Points<Algebraic> mean = Points<Algebraic>::Zero(1, 3);
        for (const int u : mesh.corners(f)) mean += start.points.row(u) / Algebraic(mesh.size(f));
        const int before = mesh.vertex[Mesh::i(mesh.prev(h))], after = mesh.tip(h);
        // (V + (V + A)/2 + (V + B)/2 + F)/4
        expected.row(h) = start.points.row(v) / Algebraic(2) +
                          (start.points.row(before) + start.points.row(after)) / Algebraic(8) + mean / Algebraic(4);
      }
      check_same(run(word("doo_sabin_averaging"), start, 1).points, expected);
    }
  }

  TEST_CASE("zorin_schroeder moves a vertex to V/2 + mean of neighbours/4 + mean of faces/4") {
    oracle::Dice dice(4);
    const Mesh mesh = oracle::prism(5);
    const Surface<Algebraic> start = oracle::random_surface<Algebraic>(dice, mesh);
    const Surface<Algebraic> found = run(word("zorin_schroeder"), start, 1);
    Points<Algebraic> expected = Points<Algebraic>::Zero(mesh.vertices(), 3);
    for (int v = 0; v < mesh.vertices(); ++v) expected.row(v) = start.points.row(v) / Algebraic(2);
    for (int h = 0; h < mesh.half_edges(); ++h) {
      const int v = mesh.vertex[Mesh::i(h)], f = mesh.face[Mesh::i(h)];
      expected.row(v) += start.points.row(mesh.tip(h)) / Algebraic(4 * mesh.valence(v));
      for (const int u : mesh.corners(f)) expected.row(v) += start.points.row(u) / Algebraic(4 * mesh.valence(v) * mesh.size(f));
    }
    check_same(found.points.topRows(mesh.vertices()), expected);
  }

  TEST_CASE("interpolating_quads has the symbols of the regular mesh") {
    // edge = (1,1)/2 (1 - s_u/8 - s_u s_v/64) with s = [1, -2, 1]: the edge point between (0,0) and (1,0) of a regular mesh.
    const Mesh mesh = *grid<Rational>(7, 6).mesh;  // vertex (x, y) is x + 8 y
    oracle::Dice dice(5);
    const Surface<Algebraic> start = oracle::random_surface<Algebraic>(dice, mesh, 1);
    const Surface<Algebraic> found = run(word("interpolating_quads"), start, 1);
    check_same(found.points.topRows(mesh.vertices()), start.points);
    const auto p = [&](int x, int y) { return start.points(3 + x + 8 * (3 + y), 0); };
    const auto s_u = [&](int x, int y) { return p(x - 1, y) - Algebraic(2) * p(x, y) + p(x + 1, y); };
    const auto corrected = [&](int x) {
      return p(x, 0) - s_u(x, 0) / Algebraic(8) - (s_u(x, -1) - Algebraic(2) * s_u(x, 0) + s_u(x, 1)) / Algebraic(64);
    };
    int edge = -1;
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[Mesh::i(e)];
      if (std::minmax(mesh.vertex[Mesh::i(h)], mesh.tip(h)) == std::minmax(27, 28)) edge = e;
    }
    REQUIRE(edge >= 0);
    CHECK(found.points(mesh.vertices() + edge, 0) == (corrected(0) + corrected(1)) / Algebraic(2));
  }

  TEST_CASE("butterfly_like interpolates with the ten-point stencil") {
    // 17/32 at the ends, 1/16 at the two opposite points, -1/32 at the six further ones. The edge 0-1 of a regular star of three
    // rings.
    const Mesh mesh = *ring_mesh(6, 3, true).mesh;
    Surface<Algebraic> start{
        std::make_shared<const Mesh>(mesh), Points<Algebraic>::Zero(mesh.vertices(), mesh.vertices()), {}, {}};
    for (int v = 0; v < mesh.vertices(); ++v) start.points(v, v) = Algebraic(1);
    const Surface<Algebraic> found = run(word("butterfly_like"), start, 1);
    check_same(found.points.topRows(mesh.vertices()), start.points);
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[Mesh::i(e)];
      if (std::minmax(mesh.vertex[Mesh::i(h)], mesh.tip(h)) != std::minmax(0, 1)) continue;
      std::map<std::string, int> weights;
      for (int v = 0; v < mesh.vertices(); ++v) ++weights[found.points(mesh.vertices() + e, v).to_string()];
      CHECK(weights["17/32"] == 2);
      CHECK(weights["1/16"] == 2);
      CHECK(weights["-1/32"] == 6);
      CHECK(weights["0"] == mesh.vertices() - 10);
      CHECK(found.points(mesh.vertices() + e, 0) == fraction(17, 32));
    }
  }

  TEST_CASE("pipe keeps cylinders round and revolve keeps every ring round") {
    const auto check_rings = [](const Surface<Algebraic>& s) {
      for (int e = 0; e < s.mesh->edges(); ++e) {
        if (s.tags.of_edge(e) != EdgeTag::latitude) continue;
        const int h = s.mesh->edge_half[Mesh::i(e)], a = s.mesh->vertex[Mesh::i(h)], b = s.mesh->tip(h);
        const auto square = [&](int v) { return s.points(v, 0) * s.points(v, 0) + s.points(v, 1) * s.points(v, 1); };
        CHECK(square(a) == square(b));
        CHECK(s.points(a, 2) == s.points(b, 2));
      }
    };
    Points<Algebraic> straight(3, 2), curved(3, 2);
    straight << Algebraic(1), Algebraic(0), Algebraic(1), Algebraic(1), Algebraic(1), Algebraic(2);
    curved << Algebraic(1), Algebraic(0), Algebraic(2), Algebraic(1), fraction(1, 2), Algebraic(3);
    check_rings(run(word("pipe(5)"), tube<Algebraic>(5, straight), 2));
    check_rings(run(word("revolve(5)"), tube<Algebraic>(5, curved), 2));
  }

  TEST_CASE("the rows of Table 1 have the values of the reference data") {
    std::ifstream in(std::string(UDCP_TEST_DATA) + "/operators.json");
    REQUIRE(in);
    const Json data = Json::parse(in);
    int found = 0;
    for (const Json& test : data["cases"]) {
      const std::string id = test["id"];
      if (!id.starts_with("table 1 row ")) continue;
      ++found;
      CAPTURE(id);
      Surface<double> start;
      std::vector<std::vector<int>> faces = test["faces"];
      start.mesh = std::make_shared<const Mesh>(make_mesh(static_cast<int>(test["points"].size()), faces));
      start.points.resize(start.mesh->vertices(), 3);
      for (int v = 0; v < start.mesh->vertices(); ++v)
        for (int c = 0; c < 3; ++c)
          start.points(v, c) =
              std::stod(test["points"][static_cast<std::size_t>(v)][static_cast<std::size_t>(c)].get<std::string>());
      const Points<double> points = run(word("table1_" + id.substr(12)), start, test["rounds"]).points;
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (Eigen::Index i = 0; i < points.rows(); ++i) sum += static_cast<double>(i + 1) * points(i, c);
        // 98 terms of size up to 200: rounding stays far below 1e-9.
        CHECK(std::abs(sum - test["expect"]["weighted_sum"][static_cast<std::size_t>(c)].get<double>()) < 1e-9);
      }
    }
    CHECK(found == 4);
  }

  TEST_CASE("the prelude has no warnings and every name in it is a word or makes one") {
    int words = 0;
    for (const std::string& name : session().names()) {
      const Value* value = session().find(name);
      REQUIRE(value);
      CHECK((value->as<WordValue>() || value->as<FunctionValue>()));
      ++words;
    }
    CHECK(words == 21);
  }
}
