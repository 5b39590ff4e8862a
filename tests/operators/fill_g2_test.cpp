// The G2 fill: its mask against reference values, the conditions of the joins from the patches' own derivatives, shapes against
// plain Catmull-Clark, and meshes.
#include "operators/methods/filling/fill_g2.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "operators/matrix.h"
#include "operators/schemes.h"
#include "operators/shapes.h"
#include "tests/operators/fill_golden.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/nets.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

using Vector = Eigen::Vector3d;

std::size_t at(int k) { return Mesh::i(k); }

/// Patch i of the fill of a net of at least two rings.
std::vector<BezierPatch> fill_of(const Points<double>& net, int n) {
  FillMasks masks;
  const Points<double> all = apply(masks.of(n), net.topRows(ring_size(n, 2)));
  std::vector<BezierPatch> patches;
  for (int i = 0; i < n; ++i) patches.push_back({7, 7, all.middleRows(64 * i, 64)});
  return patches;
}

/// The bicubic patch of the face with corner (j,k) of sector i; entry (-1,-1) of the hole face itself is (1,1) of sector i + 2.
BezierPatch bicubic(const Points<double>& net, int n, int i, int j, int k) {
  Points<double> grid(16, 3);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      const bool corner = j + a == 0 && k + b == 0;
      grid.row(4 * a + b) = net.row(corner ? ring_number(n, i + 2, 1, 1) : ring_number(n, i, j + a - 1, k + b - 1));
    }
  return {3, 3, hybrid_patch<double>(grid, {0.5, 0.5, 0.5, 0.5})};
}

struct Difference {
  double point = 0, normal = 0, tensor = 0;
  void compare(const PatchJet& p, const PatchJet& q) {
    const SurfaceCurvature a = curvature(p), b = curvature(q);
    REQUIRE(a.is_regular);
    REQUIRE(b.is_regular);
    point = std::max(point, (p.point - q.point).norm());
    normal = std::max(normal, (a.normal - b.normal).norm());
    tensor = std::max(tensor, (a.tensor - b.tensor).norm() / a.tensor.norm());
  }
  void check() const {
    CHECK(point <= 1e-13);
    CHECK(normal <= 1e-11);
    CHECK(tensor <= 1e-9);
  }
};

/// psi as polynomials from the matrix of y, with derivatives by u up to order 2, by differences of Bernstein coefficients.
std::array<Vector, 3> psi(const Points<double>& map, double u, double v) {
  // y as a patch of degrees 3 in u and 4 in v; x(u,v) = y(v,u)
  BezierPatch y{3, 4, Points<double>::Zero(20, 3)}, x{4, 3, Points<double>::Zero(20, 3)};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j) {
      y.points(5 * j + i, 1) = map(i, j);
      x.points(4 * i + j, 0) = map(i, j);
    }
  const PatchJet a = x.at(u, v), b = y.at(u, v);
  return {Vector(a.point + b.point), Vector(a.u + b.u), Vector(a.uu + b.uu)};
}

/// B(psi(u, v)) with its derivatives by u, by the chain rule.
std::array<Vector, 3> composed(const BezierPatch& b, const std::array<Vector, 3>& map) {
  const PatchJet jet = b.at(map[0][0], map[0][1]);
  const auto &d = map[1], &e = map[2];
  return {jet.point, jet.u * d[0] + jet.v * d[1],
          jet.uu * (d[0] * d[0]) + 2 * jet.uv * (d[0] * d[1]) + jet.vv * (d[1] * d[1]) + jet.u * e[0] + jet.v * e[1]};
}

/// The nets of one valence that properties are tested on: scaled to coordinates of at most 1, three rings.
std::vector<Points<double>> nets(int n) {
  std::vector<Points<double>> result{apex_net(n), saddle_net(n), bumpy_net(n)};
  for (Points<double>& net : result) net /= net.cwiseAbs().maxCoeff();
  return result;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("masks of the fill and their Bezier points have the reference values") {
    for (const Json& set : golden()["g2"]) {
      const int n = set["n"];
      CAPTURE(n);
      const FillMask mask = make_fill_mask(n);
      CHECK(mask.ranks == set["ranks"].get<std::vector<int>>());
      CHECK(mask.freedom == set["dof"].get<int>());
      double worst = 0;
      for (int i = 0; i < 64; ++i)
        for (int k = 0; k < 6 * n + 1; ++k)
          worst = std::max(worst, std::abs(mask.weights(i, k) - set["mask_patch0"][at(i)][at(k)].get<double>()));
      CHECK(worst <= 1e-11);
      CHECK(mask.weights.cwiseAbs().rowwise().sum().maxCoeff() ==
            doctest::Approx(set["max_abs_row_sum"].get<double>()).epsilon(1e-11));
      for (const Json& net : set["nets"]) {
        const Points<double> points = points_of(net["points"]);
        const std::vector<BezierPatch> patches = fill_of(points, n);
        double off = 0;
        for (int i = 0; i < n; ++i)
          off = std::max(off, (patches[at(i)].points - points_of(net["bezier"][at(i)])).cwiseAbs().maxCoeff());
        CHECK(off <= 1e-11 * std::max(1.0, points.cwiseAbs().maxCoeff()));
      }
    }
    const Json& exact = golden()["g2"][0]["mask_patch0_exact"];
    const FillMask mask = make_fill_mask(3);
    for (const auto& [row, weights] : exact.items())
      for (std::size_t k = 0; k < weights.size(); ++k)
        CHECK(std::abs(mask.weights(std::stoi(row), static_cast<Eigen::Index>(k)) -
                       Rational::parse(weights[k].get<std::string>()).to_double()) <= 1e-13);
  }

  TEST_CASE("the points that the ring fixes have the reference weights exactly for valence 3") {
    const auto exact = outer_weights(outer_traces(outer_map<Rational>(Rational(-1) / Rational(2))));
    const auto five = outer_weights(outer_traces(outer_map<double>(cosine<double>(Rational(2) / Rational(5)))));
    for (int j = 0; j < 8; ++j) {
      for (int k = 0; k < 8; ++k) {
        const std::string key = std::to_string(j) + "," + std::to_string(k);
        if (j >= 5) {
          for (std::size_t a = 0; a < 16; ++a) {
            const auto column = static_cast<Eigen::Index>(a), mirrored = static_cast<Eigen::Index>(4 * (a % 4) + a / 4);
            const Rational expected = Rational::parse(golden()["g2"][0]["boundary_stencils_exact"][key][a].get<std::string>());
            CHECK(exact(8 * j + k, column) == expected);
            CHECK(exact(8 * k + j, mirrored) == expected);
            CHECK(std::abs(five(8 * j + k, column) - golden()["g2"][1]["boundary_stencils"][key][a].get<double>()) <= 1e-14);
          }
        } else if (k < 5) {
          CHECK(exact.row(8 * j + k) == Points<Rational>::Zero(1, 16).row(0));
        }
      }
    }
  }

  TEST_CASE("the traces of the outer map are the polynomials of the corrected paper") {
    for (int p = -9; p <= 9; ++p) {
      const Rational c = Rational(p) / Rational(10), two = c - Rational(2), three = Rational(2) * c - Rational(3);
      const OuterTraces<Rational> traces = outer_traces(outer_map<Rational>(c));
      const auto value = [](const std::vector<Rational>& poly, const Rational& t) {
        Rational sum(0);
        for (std::size_t k = poly.size(); k-- > 0;) sum = sum * t + poly[k];
        return sum;
      };
      for (int q = 0; q <= 5; ++q) {
        const Rational t = Rational(q) / Rational(5), s = Rational(1) - t;
        CHECK(value(traces.x_u, t) == Rational(1) - c * t * s);
        CHECK(value(traces.x_uu, t) == Rational(2) * c * (Rational(3) - c) / two * t * t * s);
        CHECK(value(traces.y_u, t) == c * (Rational(1) - c) / two * t * s * s * s +
                                          c * (Rational(3) - Rational(2) * c) / two * t * t * s * s - c * t * t * t * s);
        CHECK(value(traces.y_uu, t) == Rational(2) * c * c * (c + Rational(1)) / (two * three) * t * s * s * s -
                                           Rational(2) * c * c / two * t * t * s * s - Rational(2) * c * t * t * t * s);
      }
    }
  }

  TEST_CASE("ranks and degrees of freedom are those of the table up to valence 32 and rows sum to 1") {
    for (int n = 3; n <= 32; ++n) {
      CAPTURE(n);
      const FillMask mask = make_fill_mask(n);
      const int freedom = n == 3 ? 34 : n == 4 ? 49 : n == 6 ? 61 : 9 * n + 6;
      CHECK(mask.freedom == freedom);
      CHECK((mask.weights.rowwise().sum().array() - 1).abs().maxCoeff() <= 1e-11);
      CHECK(mask.least_kept >= 1.6e-3);
      CHECK(mask.most_dropped <= 1e-14);
      CHECK(mask.weights.cwiseAbs().rowwise().sum().maxCoeff() <= 1.11);
    }
    CHECK(make_fill_mask(7).ranks == std::vector<int>{14, 15, 15, 16});
    CHECK(make_fill_mask(4).ranks == std::vector<int>{12, 13, 13});
    CHECK_THROWS_WITH_AS(make_fill_mask(2), "there is no fill for valence 2, only for 3 to 100", Error);
    CHECK_THROWS_WITH_AS(make_fill_mask(101), "there is no fill for valence 101, only for 3 to 100", Error);
  }

  TEST_CASE("patches meet the conditions of the joins inside and of the ring outside") {
    for (int n = 3; n <= 8; ++n) {
      const double c = cosine<double>(Rational(2) / Rational(n));
      for (const Points<double>& net : nets(n)) {
        CAPTURE(n);
        const std::vector<BezierPatch> patches = fill_of(net, n);
        double zero = 0, one = 0, two = 0;
        std::array<double, 3> outer{};
        for (int i = 0; i < n; ++i) {
          const BezierPatch &here = patches[at(i)], &next = patches[at((i + 1) % n)], ring = bicubic(net, n, i, 0, 0);
          for (int k = 0; k <= 10; ++k) {
            const double t = k / 10.0, s = c * (1 - t), g = 1 + s;
            const PatchJet p = here.at(0, t), q = next.at(t, 0);
            zero = std::max(zero, (p.point - q.point).norm());
            one = std::max(one, (s * (q.u + p.v) - q.v - p.u).norm());
            two = std::max(two, (2 * c * s * (q.v - p.u) + 2 * s * g * (q.uv - p.uv) - g * (q.vv - p.uu)).norm());
            const auto map = psi(outer_map<double>(c), 1, t);
            const auto b = composed(ring, map);
            const PatchJet right = here.at(1, t);
            const std::array<Vector, 3> r{right.point, right.u, right.uu};
            // the other boundary: u and v change places
            BezierPatch mirrored = ring;
            for (int x = 0; x < 4; ++x)
              for (int y = 0; y < 4; ++y) mirrored.points.row(4 * y + x) = ring.points.row(4 * x + y);
            const auto m = composed(mirrored, map);
            const PatchJet top = here.at(t, 1);
            const std::array<Vector, 3> v{top.point, top.v, top.vv};
            for (std::size_t d = 0; d < 3; ++d) outer[d] = std::max({outer[d], (r[d] - b[d]).norm(), (v[d] - m[d]).norm()});
          }
        }
        CHECK(zero <= 1e-13);
        CHECK(one <= 1e-12);
        CHECK(two <= 1e-11);
        CHECK(outer[0] <= 1e-13);
        CHECK(outer[1] <= 1e-12);
        CHECK(outer[2] <= 1e-11);
      }
    }
  }

  TEST_CASE("patches have equal points and normals and curvature tensors on both sides of every edge and at the centre") {
    for (int n = 3; n <= 8; ++n) {
      CAPTURE(n);
      for (const Points<double>& net : {nets(n)[0], nets(n)[1]}) {
        const std::vector<BezierPatch> patches = fill_of(net, n);
        Difference inner, centre, outer;
        for (int i = 0; i < n; ++i) {
          const BezierPatch ring = bicubic(net, n, i, 1, 0);
          centre.compare(patches[0].at(0, 0), patches[at(i)].at(0, 0));
          for (int k = 0; k <= 10; ++k) {
            const double t = k / 10.0;
            inner.compare(patches[at(i)].at(0, t), patches[at((i + 1) % n)].at(t, 0));
            outer.compare(patches[at(i)].at(1, t), ring.at(0, t));
          }
        }
        inner.check();
        centre.check();
        outer.check();
      }
    }
  }

  TEST_CASE("the fill of valence 4 is the bicubic B-spline") {
    for (const Points<double>& net : nets(4)) {
      const std::vector<BezierPatch> patches = fill_of(net, 4);
      for (int i = 0; i < 4; ++i) {
        const BezierPatch spline = bicubic(net, 4, i, 0, 0);
        for (const double u : {0.0, 0.3, 0.7, 1.0})
          for (const double v : {0.0, 0.5, 1.0}) CHECK((patches[at(i)].at(u, v).point - spline.at(u, v).point).norm() <= 1e-12);
      }
    }
  }

  TEST_CASE("the fill commutes with affine maps and turned and reflected numbering") {
    Dice dice(81);
    for (int n = 3; n <= 8; ++n) {
      CAPTURE(n);
      const FillMask mask = make_fill_mask(n);
      const Points<double> net = nets(n)[2].topRows(ring_size(n, 2)), plain = apply(mask, net);
      Eigen::Matrix3d matrix;
      for (int k = 0; k < 9; ++k) matrix(k / 3, k % 3) = dice.fraction().to_double() / 30;
      const Eigen::RowVector3d shift(0.25, -0.5, 0.125);
      const Points<double> mapped = (net * matrix).rowwise() + shift;
      CHECK((apply(mask, mapped) - Points<double>((plain * matrix).rowwise() + shift)).cwiseAbs().maxCoeff() <= 1e-12);
      Points<double> turned(net.rows(), 3), mirrored(net.rows(), 3);
      turned.row(0) = mirrored.row(0) = net.row(0);
      for (int i = 0; i < n; ++i)
        for (int j = 1; j <= 2; ++j)
          for (int k = 0; k <= 2; ++k) {
            turned.row(ring_number(n, i, j, k)) = net.row(ring_number(n, i + 1, j, k));
            mirrored.row(ring_number(n, i, j, k)) = net.row(ring_number(n, -i, k, j));
          }
      const Points<double> after = apply(mask, turned), reflected = apply(mask, mirrored);
      for (int i = 0; i < n; ++i) {
        CHECK((after.middleRows(64 * i, 64) - plain.middleRows(64 * ((i + 1) % n), 64)).cwiseAbs().maxCoeff() <= 1e-12);
        for (int j = 0; j < 8; ++j)
          for (int k = 0; k < 8; ++k)
            CHECK((reflected.row(64 * i + 8 * j + k) - plain.row(64 * ((n - i) % n) + 8 * k + j)).cwiseAbs().maxCoeff() <= 1e-12);
      }
    }
  }

  TEST_CASE("planar nets give regular patches") {
    for (const int n : {3, 5, 6, 7, 8}) {
      CAPTURE(n);
      const std::vector<BezierPatch> patches = fill_of(ring_mesh(n, 3).points, n);
      double least = 1;
      for (const BezierPatch& patch : patches)
        for (int j = 0; j <= 16; ++j)
          for (int k = 0; k <= 16; ++k) {
            const PatchJet jet = patch.at(j / 16.0, k / 16.0);
            least = std::min(least, (jet.u[0] * jet.v[1] - jet.u[1] * jet.v[0]) / (jet.u.norm() * jet.v.norm()));
          }
      CHECK(least >= std::sin(2 * std::numbers::pi / n) - 1e-9);
    }
  }
}
