// The literal sweeps and the shortest correction: that they diverge, by how much, and what they move.
#include <doctest/doctest.h>

#include "tests/operators/interpolation_golden.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

Sweeps swept(const std::string& name, SweepOrder order, Spread spread, int sweeps) {
  const GoldenMesh mesh = golden_mesh(name);
  SweepOptions options;
  options.order = order;
  options.spread = spread;
  options.sweeps = sweeps;
  return sweep(mesh.cage, mesh.normals, options);
}

struct Growth {
  const char* mesh;
  double jacobi_tied, jacobi_free, average_tied;
};

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("simultaneous sweeps grow by the expected factors") {
    // Spectral radii by dense eigenvalues, to three digits. On torus and sphere free corrections settle before their growing mode
    // shows; there only the tied ones are measured.
    for (const Growth& g :
         {Growth{"cone", 1.199, 1.071, 0.980}, Growth{"torus_tilted", 1.265, 1.099, 0.998},
          Growth{"torus_coarse", 0.989, 0.988, 0.995}, Growth{"torus", 1.262, 0, 0}, Growth{"sphere", 1.318, 0, 0}}) {
      CAPTURE(g.mesh);
      CHECK(swept(g.mesh, SweepOrder::jacobi, Spread::tied, 250).growth == doctest::Approx(g.jacobi_tied).epsilon(2e-3));
      if (g.jacobi_free == 0) continue;
      CHECK(swept(g.mesh, SweepOrder::jacobi, Spread::free, 250).growth == doctest::Approx(g.jacobi_free).epsilon(2e-3));
      CHECK(swept(g.mesh, SweepOrder::average, Spread::tied, 250).growth == doctest::Approx(g.average_tied).epsilon(3e-3));
    }
    for (const char* mesh : {"cube_tilted", "hex"}) CHECK(swept(mesh, SweepOrder::jacobi, Spread::tied, 25).growth < 0.6);
    CHECK(swept("torus_coarse", SweepOrder::gauss, Spread::tied, 300).growth == doctest::Approx(0.978).epsilon(2e-3));
  }

  TEST_CASE("the simultaneous sweeps diverge on the tilted torus and converge on the cube") {
    const Sweeps torus = swept("torus_tilted", SweepOrder::jacobi, Spread::tied, 60);
    CHECK(torus.errors.front().position == doctest::Approx(5.4e-2).epsilon(0.01));
    CHECK(torus.errors.front().normal == doctest::Approx(0.18).epsilon(0.01));
    CHECK(torus.errors.back().position == doctest::Approx(3.2e-1).epsilon(0.03));
    CHECK(torus.errors.back().normal == doctest::Approx(1.4).epsilon(0.03));
    const Sweeps smooth = swept("torus", SweepOrder::jacobi, Spread::tied, 5);  // looks convergent at first
    CHECK(smooth.errors.back().normal == doctest::Approx(1.1e-5).epsilon(0.05));
    for (const SweepOrder order : {SweepOrder::jacobi, SweepOrder::gauss, SweepOrder::average}) {
      const Sweeps cube = swept("cube_tilted", order, Spread::tied, 150);
      CHECK(cube.errors.back().position < 1e-10);
      CHECK(cube.errors.back().normal < 1e-10);
    }
    CHECK(swept("torus_tilted", SweepOrder::average, Spread::tied, 60).errors.back().normal < 0.3);
  }

  TEST_CASE("interpolate reports the divergence of the literal method") {
    const GoldenMesh mesh = golden_mesh("torus_tilted");
    InterpolateOptions options;
    options.method = InterpolationMethod::literal;
    options.step2 = NormalStep::tied;
    options.sweeps = 60;
    const Interpolation result = interpolate(mesh.cage, mesh.normals, options);
    CHECK(result.rounds == 1);
    CHECK(result.control.mesh->faces() == 4 * 96);
    CHECK(result.sweeps.size() == 60);
    CHECK(result.growth > 1.1);
    REQUIRE_FALSE(result.notes.empty());
    CHECK(result.notes[0].find("the sweeps diverge: each changes 1.") == 0);
    CHECK(result.errors.position == result.sweeps.back().position);
  }

  TEST_CASE("the shortest correction interpolates and moves points as far as expected") {
    for (const auto& [key, expected] : std::vector<std::pair<std::string, double>>{
             {"cube_tilted", 0.52}, {"hex", 0.72}, {"cone", 0.28}, {"torus_coarse", 4.3}, {"torus_tilted", 4.1}}) {
      const std::string name = key;
      CAPTURE(name);
      const GoldenMesh mesh = golden_mesh(name);
      const LeastCorrection least = least_correction(mesh.cage, mesh.normals);
      CHECK(least.displacement == doctest::Approx(expected).epsilon(0.02));
      InterpolateOptions options;
      options.method = InterpolationMethod::kkt;
      const Interpolation result = interpolate(mesh.cage, mesh.normals, options);
      CHECK(result.errors.position < 1e-11);
      CHECK((result.errors.reversed > 0 || result.errors.normal < 1e-9));
      CHECK(result.rank <= result.rows);
      CHECK(result.rows == 5 * mesh.cage.mesh->vertices());
    }
  }
}
