// What a plan promises beside its points: where it applies, its numbering, its limits and errors, normals, threads, second use.
#include "operators/limit.h"
#include "operators/schemes.h"
#include "tests/operators/plan_compare.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

PlanControl always() {
  PlanControl control;
  control.always = true;
  return control;
}

template <class R>
FlatMesh<R> planned(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control = always()) {
  const Compiled<R> compiled = compile<R>(word, surface, rounds, control);
  REQUIRE(compiled.plan);
  FlatMesh<R> result;
  execute(*compiled.plan, surface.points, result, control);
  return result;
}

template <class T>
bool same(const Buffer<T>& a, const Buffer<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

Mesh joined(const Mesh& a, const Mesh& b) {
  std::vector<int> begin = a.face_begin, corners = a.vertex;
  for (int f = 0; f < b.faces(); ++f) begin.push_back(begin.back() + b.size(f));
  for (const int v : b.vertex) corners.push_back(a.vertices() + v);
  return make_mesh(a.vertices() + b.vertices(), std::move(begin), std::move(corners));
}

// Limits at the vertices of run(), in the order of a plan's result.
struct Expected {
  Limit limit;
  std::vector<int> counterpart;  // per vertex of run() the one of the plan
};
Expected expected_limits(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control) {
  const Compiled<double> compiled = compile<double>(word, surface, rounds, control);
  REQUIRE(compiled.plan);
  FlatMesh<double> flat;
  execute(*compiled.plan, surface.points, flat, control);
  const Surface<double> fine = run(word, surface, rounds);
  RunControl after;
  after.first_item = word.items(rounds);
  const Mesh mesh = half_edges_of(flat);
  Expected result{limit(word, fine, after), numbers_in_plan(*fine.mesh, mesh, *compiled.plan->mesh)};
  REQUIRE(result.counterpart.size() == Mesh::i(fine.mesh->vertices()));
  return result;
}

template <class R>
double difference(const Buffer<R>& found, const Points<double>& expected, const std::vector<int>& counterpart) {
  double most = 0;
  for (Eigen::Index v = 0; v < expected.rows(); ++v)
    for (Eigen::Index c = 0; c < 3; ++c) {
      const std::size_t k = 3 * Mesh::i(counterpart[static_cast<std::size_t>(v)]) + static_cast<std::size_t>(c);
      most = std::max(most, std::abs(static_cast<double>(found[k]) - expected(v, c)));
    }
  return most;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("a plan numbers old points first and then edges along their direction and then faces") {
    // U alone is bilinear, so that points tell where they are.
    const Surface<double> surface = torus<double>(6, 5, 3, 1);
    const Compiled<double> compiled = compile<double>(scheme("U"), surface, 2, always());
    REQUIRE(compiled.plan);
    const Plan<double>& plan = *compiled.plan;
    FlatMesh<double> flat;
    execute(plan, surface.points, flat);
    const Mesh& mesh = *surface.mesh;
    const auto point = [&](int k) { return Eigen::Vector3d(flat.points.data() + 3 * k); };
    const auto corner = [&](int v) -> Eigen::Vector3d { return surface.points.row(v).transpose(); };
    REQUIRE(plan.segments == 4);
    for (int v = 0; v < mesh.vertices(); ++v) CHECK((point(v) - corner(v)).norm() < 1e-14);
    for (int e = 0; e < mesh.edges(); ++e) {
      const int h = mesh.edge_half[Mesh::i(e)];
      for (int s = 1; s < 4; ++s) {
        const Eigen::Vector3d wanted = ((4 - s) * corner(mesh.vertex[Mesh::i(h)]) + s * corner(mesh.tip(h))) / 4;
        CHECK((point(mesh.vertices() + 3 * e + s - 1) - wanted).norm() < 1e-14);
      }
    }
    for (int f = 0; f < mesh.faces(); ++f) {
      const int h = 4 * f + plan.turn[Mesh::i(f)], first = mesh.vertices() + 3 * mesh.edges() + 9 * f;
      const int a = mesh.vertex[Mesh::i(h)], b = mesh.tip(h), c = mesh.tip(mesh.next(h)), d = mesh.vertex[Mesh::i(mesh.prev(h))];
      for (int j = 1; j < 4; ++j) {
        for (int i = 1; i < 4; ++i) {
          const Eigen::Vector3d wanted =
              ((4 - i) * (4 - j) * corner(a) + i * (4 - j) * corner(b) + i * j * corner(c) + (4 - i) * j * corner(d)) / 16;
          CHECK((point(first + 3 * (j - 1) + i - 1) - wanted).norm() < 1e-14);
        }
      }
    }
  }

  TEST_CASE("a plan is refused where parameters vary or the result is dual or rounds lack a U") {
    const KernelPtr noise = formula([](const auto& c) { return decltype(c.alpha)(c.vertex % 2); }, {false, true, false});
    const KernelPtr valence = formula([](const auto& c) { return decltype(c.alpha)(c.valence); }, {true, false, false});
    Word by_valence = scheme("UCP", half_cosine());
    by_valence.alpha0.plain = valence;
    for (const Word& word : {scheme("UD"), scheme("UDUD"), scheme("UC", noise), scheme("UCP", nullptr, nullptr, noise),
                             by_valence, scheme("C"), scheme("CU")}) {
      CAPTURE(atoms(word, 1));
      CHECK(!planned_word(word));
      CHECK(!compile<float>(word, cube<double>(), 2, always()).plan);
      const Refined<double> refined = refine<double>(word, cube<double>(), 2);
      const Surface<double> expected = run(word, cube<double>(), 2);
      if (refined.is_flat()) {
        const auto& flat = std::get<FlatMesh<double>>(refined.mesh);
        REQUIRE(flat.vertices() == expected.mesh->vertices());
        CHECK(std::equal(flat.points.begin(), flat.points.end(), expected.points.data()));
        CHECK(std::equal(flat.corners.begin(), flat.corners.end(), expected.mesh->vertex.begin()));
      } else {
        CHECK(std::get<Surface<double>>(refined.mesh).points == expected.points);
        CHECK_FALSE(expected.mesh->all_faces_have(4));
      }
    }
  }

  TEST_CASE("refine gives the result of run whatever way it takes") {
    Dice dice(91);
    for (const int rounds : {0, 1, 2, 5}) {
      for (const Word& word : {schemes::catmull_clark(), scheme("UCCP")}) {
        const Surface<double> surface = random_surface<double>(dice, *cube<double>().mesh);
        const Refined<float> refined = refine<float>(word, surface, rounds);
        REQUIRE(refined.is_flat());
        const auto& flat = std::get<FlatMesh<float>>(refined.mesh);
        const Surface<double> expected = run(word, surface, rounds);
        CHECK(flat.vertices() == expected.mesh->vertices());
        CHECK(flat.faces() == expected.mesh->faces());
        for (int v = 0; v < 8; ++v)
          for (int c = 0; c < 3; ++c) CHECK(std::abs(flat.points[Mesh::i(3 * v + c)] - expected.points(v, c)) < 1e-4);
        // the mean of all points does not depend on their order
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::int64_t v = 0; v < flat.vertices(); ++v)
          for (int c = 0; c < 3; ++c) sum[c] += flat.points[static_cast<std::size_t>(3 * v + c)];
        const double n = static_cast<double>(flat.vertices());
        CHECK((sum / n - expected.points.colwise().mean().transpose()).norm() < 1e-4);
      }
    }
  }

  TEST_CASE("many rounds on a small mesh go over an intermediate level and agree") {
    const Compiled<double> compiled = compile<double>(schemes::catmull_clark(), cube<double>(), 7);
    REQUIRE(compiled.plan);
    CHECK(compiled.plan->before.rounds > 0);
    CHECK(compiled.plan->before.rounds < 7);
    Dice dice(92);
    const Surface<double> surface = random_surface<double>(dice, *cube<double>().mesh);
    FlatMesh<double> flat;
    execute(*compiled.plan, surface.points, flat);
    const Surface<double> expected = run(schemes::catmull_clark(), surface, 7);
    const Mesh mesh = half_edges_of(flat);
    const std::vector<int> counterpart = numbers_in_plan(*expected.mesh, mesh, *compiled.plan->mesh);
    REQUIRE_FALSE(counterpart.empty());
    CHECK(difference(flat.points, expected.points, counterpart) < 1e-12);
  }

  TEST_CASE("a plan for many rounds has no more than 64 segments per edge") {
    const Compiled<double> compiled = compile<double>(schemes::catmull_clark(), cube<double>(), 8, always());
    REQUIRE(compiled.plan);
    CHECK(compiled.plan->before.rounds == 2);
    CHECK(compiled.plan->segments == 64);
    CHECK(compiled.plan->faces() == 393216);  // 6 * 4^8
    CHECK(compiled.plan->vertices() == 393218);
    CHECK(compiled.plan->bytes() == 393218 * 24 + 393216 * 16);
  }

  TEST_CASE("the rounds before a plan that is kept have a plan too and agree in all parts of a mesh") {
    Dice dice(96);
    const Surface<double> two = random_surface<double>(dice, joined(*cube<double>().mesh, *torus<double>(3, 4, 3, 1).mesh));
    for (const Word& word : {schemes::catmull_clark(), scheme("UCP", half_cosine())}) {
      const Compiled<double> compiled = compile<double>(word, two, 7, always());
      REQUIRE(compiled.plan);
      CHECK(compiled.plan->before.rounds == 1);
      CHECK(compiled.plan->before.plan);
      CHECK(test::difference_to_run<double>(word, two, 7) < 1e-12);
    }
    const Compiled<double> cold = compile<double>(schemes::catmull_clark(), two, 7);
    REQUIRE(cold.plan);
    CHECK_FALSE(cold.plan->before.plan);
  }

  TEST_CASE("the matrices of a plan that is kept stay smaller than the caches or the result") {
    Dice dice(97);
    Mesh uneven = random_mesh(dice, true);
    while (uneven.faces() < 300) uneven = joined(uneven, random_mesh(dice, true));
    const Surface<double> surface = random_surface<double>(dice, uneven);
    const Word word = scheme("UCCP");
    const Compiled<float> compiled = compile<float>(word, surface, 5, always());
    REQUIRE(compiled.plan);
    CHECK(compiled.plan->before.rounds > 0);  // at once there would be too many kinds
    CHECK(compiled.plan->before.plan);
    double matrices = 0;
    for (const auto& kind : compiled.plan->kinds) matrices += static_cast<double>(kind.layers[0].values.size() * sizeof(float));
    CHECK(matrices <= std::max(4e6, 0.5 * sizeof(float) * 3 * static_cast<double>(compiled.plan->vertices())));
    CHECK(test::difference_to_run<float>(word, surface, 5) < 1e-6);
  }

  TEST_CASE("vertices of high valence are planned or go the general path and agree") {
    Dice dice(95);
    const Surface<double> star = random_surface<double>(dice, *ring_mesh(200, 2).mesh);
    CHECK(test::difference_to_run<double>(schemes::catmull_clark(), star, 2) < 1e-12);
    CHECK(test::difference_to_run<double>(scheme("UCCP"), star, 2) < 1e-12);
    const Refined<double> refined = refine<double>(scheme("UCCP"), star, 3);
    CHECK(std::get<FlatMesh<double>>(refined.mesh).vertices() == run(scheme("UCCP"), star, 3).mesh->vertices());
  }

  TEST_CASE("progress rises to 1") {
    const Surface<double> surface = torus<double>(20, 30, 3, 1);
    const Compiled<float> compiled = compile<float>(schemes::catmull_clark(), surface, 5, always());
    for (const int threads : {1, 2}) {
      std::vector<double> seen;
      PlanControl control;
      control.threads = threads;
      control.run.progress = [&](double fraction) { seen.push_back(fraction); };
      FlatMesh<float> flat;
      execute(*compiled.plan, surface.points, flat, control);
      CHECK(std::is_sorted(seen.begin(), seen.end()));
      if (threads == 1) CHECK(seen.size() > 2);  // else the other thread may be the faster one
      CHECK(seen.back() == 1);
    }
  }

  TEST_CASE("limit points and normals of a plan are those of limit") {
    Dice dice(93);
    for (const Word& word : {schemes::catmull_clark(), scheme("UCC"), circle(6, "UCP", ratio(4, 5))}) {
      for (const NamedMesh& shape : quad_meshes()) {
        const bool settles_slowly = word.alpha0.plain != nullptr;
        if (settles_slowly && shape.name != "star 5" && shape.name != "cube") continue;
        CAPTURE(atoms(word, 1));
        CAPTURE(shape.name);
        PlanControl control = always();
        control.limit_points = control.normals = true;
        const Surface<double> surface = random_surface<double>(dice, shape.mesh);
        const Expected expected = expected_limits(word, surface, 1, always());
        const FlatMesh<double> flat = planned<double>(word, surface, 1, control);
        CHECK(difference(flat.points, expected.limit.points, expected.counterpart) < 30 * 1e-12);
        CHECK(difference(flat.normals, expected.limit.normals, expected.counterpart) < 1e-9);
        control.limit_points = false;
        const FlatMesh<float> refined = planned<float>(word, surface, 1, control);
        CHECK(difference(refined.normals, expected.limit.normals, expected.counterpart) < 1e-3);
        CHECK(difference(refined.points, run(word, surface, 1).points, expected.counterpart) < 30 * 1e-6);
      }
    }
  }

  TEST_CASE("normals on triangles are those of limit") {
    Dice dice(94);
    PlanControl control = always();
    control.limit_points = control.normals = true;
    const Surface<double> surface = random_surface<double>(dice, *icosahedron<double>().mesh);
    const Expected expected = expected_limits(schemes::loop(), surface, 2, always());
    const FlatMesh<double> flat = planned<double>(schemes::loop(), surface, 2, control);
    CHECK(difference(flat.points, expected.limit.points, expected.counterpart) < 1e-12 * 30);
    CHECK(difference(flat.normals, expected.limit.normals, expected.counterpart) < 1e-9);
  }

  TEST_CASE("a plan executed again on other points gives what a new plan gives") {
    const Surface<double> surface = torus<double>(40, 30, 3, 1);
    for (const int rounds : {2, 6}) {
      const Compiled<float> compiled = compile<float>(schemes::catmull_clark(), surface, rounds, always());
      REQUIRE(compiled.plan);
      FlatMesh<float> kept, fresh;
      execute(*compiled.plan, surface.points, kept);
      const float* place = kept.points.data();
      const Points<double> moved = surface.points * 2 + Points<double>::Ones(surface.points.rows(), 3);
      execute(*compiled.plan, moved, kept);
      CHECK(kept.points.data() == place);
      execute(*compiled.plan, moved, fresh);
      CHECK(same(kept.points, fresh.points));
      CHECK(same(kept.corners, fresh.corners));
    }
  }

  TEST_CASE("two threads give the same bits as one") {
    const Surface<double> surface = torus<double>(20, 30, 3, 1);
    PlanControl one = always(), two = always();
    one.normals = two.normals = true;
    two.threads = 2;
    const FlatMesh<float> a = planned<float>(scheme("UCCP"), surface, 4, one),
                          b = planned<float>(scheme("UCCP"), surface, 4, two);
    CHECK(same(a.points, b.points));
    CHECK(same(a.normals, b.normals));
    CHECK(same(a.corners, b.corners));
  }

  TEST_CASE("points with fewer than three coordinates are filled up with zeros") {
    Surface<double> surface = grid<double>(3, 3);
    surface.points = surface.points.leftCols(2).eval();
    const FlatMesh<double> flat = planned<double>(scheme("UC"), surface, 2);
    for (std::int64_t v = 0; v < flat.vertices(); ++v) CHECK(flat.points[static_cast<std::size_t>(3 * v + 2)] == 0);
    surface.points = Points<double>::Zero(surface.points.rows(), 5);
    CHECK_FALSE(refine<double>(scheme("UC"), surface, 2).is_flat());
  }

  TEST_CASE("a far away mesh keeps its shape in float") {
    Surface<double> surface = cube<double>();
    const FlatMesh<double> near = planned<double>(schemes::catmull_clark(), surface, 3);
    surface.points.array() += 1024;
    const FlatMesh<float> far = planned<float>(schemes::catmull_clark(), surface, 3);
    // half a unit in the last place of 1024 .. 2048, and the rounding of what is added
    for (std::size_t k = 0; k < near.points.size(); ++k)
      CHECK(std::abs(far.points[k] - 1024.0 - near.points[k]) < 0.52 * 0x1p-13);
  }

  TEST_CASE("limits of faces and memory are those of run and come before any work") {
    PlanControl control = always();
    control.run.max_faces = 100;
    CHECK(refusal([&] { compile<float>(schemes::catmull_clark(), cube<double>(), 3, control); }) ==
          "E_MAX_FACES: the result would have 384 faces; the limit is 100");
    CHECK(refusal([&] { refine<float>(schemes::catmull_clark(), cube<double>(), 25); }).starts_with("E_MAX_FACES"));
    CHECK(refusal([&] { refine<float>(schemes::catmull_clark(), cube<double>(), 100); }).starts_with("E_MAX_FACES"));
    control.run.max_faces = 50'000'000;
    control.run.max_bytes = 1 << 20;
    CHECK(refusal([&] { compile<float>(schemes::catmull_clark(), cube<double>(), 4, control); }) == "accepted");
    const std::string text = refusal([&] { compile<float>(schemes::catmull_clark(), cube<double>(), 8, control); });
    CHECK(text == "E_MAX_MEMORY: the result would need about 10 MiB; the limit is 1 MiB");  // 393218 * 12 + 393216 * 16 bytes
    CHECK(refusal([&] { refine<float>(schemes::catmull_clark(), cube<double>(), -1); }) ==
          "E_ROUNDS: the number of rounds is -1; it cannot be negative");
  }

  TEST_CASE("errors of words and meshes are those of run") {
    CHECK(refusal([] { compile<float>(scheme("PU"), cube<double>(), 1, always()); }).starts_with("item 0: E_P_NO_U"));
    CHECK(refusal([] { compile<float>(schemes::loop(), cube<double>(), 1, always()); }).starts_with("E_NOT_TRIANGLES"));
    CHECK(refusal([] { compile<float>(scheme("U3C"), icosahedron<double>(), 1, always()); }).starts_with("E_USPLIT"));
    PlanControl normals = always();
    normals.normals = true;
    CHECK(refusal([&] { compile<float>(operation("UC"), cube<double>(), 1, normals); }).starts_with("E_NO_SCHEME"));
    CHECK(refusal([&] { refine<float>(scheme("UD"), cube<double>(), 1, normals); }).starts_with("E_LIMIT_DUAL"));
    const Compiled<float> compiled = compile<float>(schemes::catmull_clark(), cube<double>(), 2, always());
    FlatMesh<float> flat;
    CHECK(refusal([&] { execute(*compiled.plan, Points<double>::Zero(7, 3), flat); }) ==
          "E_POINTS: the plan needs 8 points with one to three coordinates, got 7 with 3");
    CHECK(refusal([&] { execute(*compiled.plan, Points<double>::Zero(8, 4), flat); }).starts_with("E_POINTS"));
  }

  TEST_CASE("a plan stops between pieces when asked and can be executed again") {
    const Surface<double> surface = torus<double>(20, 30, 3, 1);
    std::atomic<bool> stop{false};
    for (const int threads : {1, 2}) {
      PlanControl control = always();
      control.threads = threads;
      control.run.stop = &stop;
      stop = false;
      const Compiled<float> compiled = compile<float>(schemes::catmull_clark(), surface, 5, control);
      FlatMesh<float> flat;
      control.run.progress = [&](double) { stop = true; };
      CHECK(refusal([&] { execute(*compiled.plan, surface.points, flat, control); }) == "E_INTERRUPTED: interrupted");
      stop = false;
      control.run.progress = nullptr;
      execute(*compiled.plan, surface.points, flat, control);
      CHECK(same(flat.corners, planned<float>(schemes::catmull_clark(), surface, 5).corners));
      stop = true;
      CHECK(refusal([&] { compile<float>(schemes::catmull_clark(), surface, 5, control); }) == "E_INTERRUPTED: interrupted");
    }
  }

  TEST_CASE("large buffers are aligned and movable and small ones too") {
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{3} << 20}) {
      Buffer<double> buffer(size);
      CHECK(buffer.size() == size);
      CHECK(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64 == 0);
      std::fill(buffer.begin(), buffer.end(), 1.5);
      const Buffer<double> moved = std::move(buffer);
      CHECK(moved.size() == size);
      CHECK(std::count(moved.begin(), moved.end(), 1.5) == static_cast<std::ptrdiff_t>(size));
    }
    CHECK(refusal([] { Buffer<double>(static_cast<std::size_t>(-1) / 4); }).starts_with("E_MAX_MEMORY"));
    CHECK(refusal([] { Buffer<double>(std::size_t{1} << 50); }).starts_with("E_MAX_MEMORY"));
  }
}
