// A plan gives what run() gives, face by face and point by point, for every kind of word and mesh; and it looks as far around a
// face as it must.
#include "operators/matrix.h"
#include "operators/plan/block.h"
#include "operators/schemes.h"
#include "tests/operators/plan_compare.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;
using udcp::test::difference_to_run;

namespace {

struct NamedWord {
  std::string name;
  Word word;
};

Word with_alpha0(Word word, const KernelPtr& alpha0) {
  word.alpha0 = Directional<KernelPtr>::all(alpha0);
  return word;
}

Word classic(Word word) {
  for (Item& item : word.tail)
    if (item.atom == Atom::convolve) item.ngon = Ngon::classic;
  return word;
}

KernelPtr catmull_clark_delta() {
  return formula([](const auto& c) { return decltype(c.alpha)(c.valence - 4) / c.valence; }, {true, false, false});
}

// push-back: kernels for circles along latitudes, plain ones along longitudes.
Word pipe(int corners) {
  Word word = with_alpha0(scheme("UCP"), turn(ratio(2, corners)));
  for (Item& item : word.tail) {
    item.f.latitude = half_cosine();
    item.omega.latitude = inverse_half_cosine();
  }
  return word;
}

Word revolve(int corners, Rings rings) {
  Word word = with_alpha0(scheme("UCP", nullptr, nullptr, value(4, 5)), turn(ratio(2, corners)));
  word.rings = rings;
  return word;
}

// The schemes of the prelude that run on quads and have primal results.
std::vector<NamedWord> quad_schemes() {
  const KernelPtr small_cosine = formula([](const auto& c) { return cos(c.alpha / Rational(2)) / 100; }, {false, false, true});
  return {{"cubic", scheme("UC")},
          {"quintic", scheme("UCC")},
          {"bspline(2)", scheme("UDD")},
          {"bspline(4)", scheme("UDDDD")},
          {"cbspline", with_alpha0(scheme("UDD", half_cosine()), turn(ratio(2, 7)))},
          {"four_point(1/32)", scheme("UCP", nullptr, value(1, 2), nullptr)},
          {"circle(5)", circle(5, "UCP", ratio(4, 5))},
          {"circle_through(5)", circle(5, "UCP", Rational(1))},
          {"catmull_clark", schemes::catmull_clark()},
          {"adjustable(1/3)", classic(scheme("UCP", value(2), value(0), catmull_clark_delta()))},
          {"interpolating_quads", scheme("UCP")},
          {"table1_b", with_alpha0(scheme("UCP", half_cosine(), inverse_half_cosine()), turn(ratio(1, 6)))},
          {"table1_c", with_alpha0(scheme("UCP", half_cosine(), inverse_half_cosine(), value(-1, 10)), turn(ratio(1, 6)))},
          {"table1_d", with_alpha0(scheme("UCP", half_cosine()), value(20))},
          {"table1_e", with_alpha0(scheme("UCP", small_cosine, nullptr, value(4, 5)), turn(ratio(1, 4)))},
          {"pipe(8)", pipe(8)},
          {"revolve(8)", revolve(8, Rings::latitude)},
          {"revolve both", revolve(8, Rings::both)}};
}

std::vector<NamedWord> triangle_schemes() {
  return {{"loop", schemes::loop()},
          {"butterfly_like", on_triangles(scheme("UCP"))},
          {"UCCP on triangles", on_triangles(scheme("UCCP"))},
          {"U3CP on triangles", on_triangles(scheme("U3CP"))},
          {"semi-stationary on triangles", on_triangles(circle(6, "UCP", ratio(4, 5)))}};
}

// Words beyond the prelude: more C, more P, other and several splits, kernels by valence.
std::vector<NamedWord> other_words() {
  const KernelPtr by_valence = formula([](const auto& c) { return decltype(c.alpha)(c.valence) / 4; }, {true, false, false});
  return {{"UCCP", scheme("UCCP")},
          {"UCPCP", scheme("UCPCP")},
          {"UCCCC", scheme("UCCCC")},
          {"U3CP", scheme("U3CP")},
          {"UCU3CP", scheme("UCU3CP")},
          {"U", scheme("U")},
          {"f by valence", scheme("UCP", by_valence)},
          {"f everywhere", [] {
             Word word = scheme("UCCP", value(1, 2));
             for (Item& item : word.tail) item.f_everywhere = true;
             return word;
           }()}};
}

Surface<double> with_points(Dice& dice, const Mesh& mesh) { return random_surface<double>(dice, mesh); }

// Rounds so that the result stays small: tests are about agreement.
int rounds_for(const Word& word, int wanted) { return arity(word) > 2 ? std::min(wanted, 2) : wanted; }

void check(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control = {}) {
  const double exact = difference_to_run<double>(word, surface, rounds, control);
  CHECK(exact >= 0);
  CHECK(exact < 1e-14);  // about sixty terms of 2^-53 each, far from the worst case
  const double rounded = difference_to_run<float>(word, surface, rounds, control);
  CHECK(rounded >= 0);
  CHECK(rounded < 1e-6);
}

// The matrices of all faces of a mesh as rows on its vertices.
template <int N>
std::vector<Points<double>> rows_on_mesh(const Mesh& mesh, const Tags& tags, const RoundsAhead& ahead) {
  const FaceGroups<N> groups = group_faces<N>(mesh, tags, ahead.rings[0], mesh.faces());
  const std::vector<Points<double>> matrices = face_matrices<N>(groups.kinds, ahead, {}, nullptr);
  std::vector<Points<double>> result;
  for (int f = 0; f < mesh.faces(); ++f) {
    const Points<double>& matrix = matrices[Mesh::i(groups.kind[Mesh::i(f)])];
    Points<double> rows = Points<double>::Zero(matrix.rows(), mesh.vertices());
    for (Eigen::Index k = 0; k < matrix.cols(); ++k)
      rows.col(groups.vertex[groups.first_vertex[Mesh::i(f)] + static_cast<std::size_t>(k)]) += matrix.col(k);
    result.push_back(std::move(rows));
  }
  return result;
}

// Rounds of the blocks from another corner agree as sets only, so both are compared in the order of corner 0.
template <int N>
double difference_of_wider_rings(const Word& word, const Surface<double>& surface, int rounds) {
  const RoundsAhead ahead = rounds_ahead(*planned_word(word), 0, rounds, 0);
  RoundsAhead wide = ahead;
  for (int& rings : wide.rings) ++rings;
  const Mesh& mesh = *surface.mesh;
  const std::vector<Points<double>> near = rows_on_mesh<N>(mesh, surface.tags, ahead);
  const std::vector<Points<double>> far = rows_on_mesh<N>(mesh, surface.tags, wide);
  const FaceGroups<N> near_groups = group_faces<N>(mesh, surface.tags, ahead.rings[0], mesh.faces());
  const FaceGroups<N> far_groups = group_faces<N>(mesh, surface.tags, wide.rings[0], mesh.faces());
  const Block<N> block{ahead.segments()};
  double difference = 0;
  for (int f = 0; f < mesh.faces(); ++f) {
    const int near_turn = near_groups.start[Mesh::i(f)] - N * f, far_turn = far_groups.start[Mesh::i(f)] - N * f;
    block.for_each_place([&](Place p) {
      const Place q = block.turned(p, (near_turn - far_turn + N) % N);
      const double apart = (near[Mesh::i(f)].row(block.row(p)) - far[Mesh::i(f)].row(block.row(q))).cwiseAbs().maxCoeff();
      difference = std::max(difference, apart);
    });
  }
  return difference;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("plans of the schemes of the prelude on quads agree with run") {
    Dice dice(81);
    for (const NamedWord& scheme : quad_schemes()) {
      for (const NamedMesh& shape : quad_meshes()) {
        CAPTURE(scheme.name);
        CAPTURE(shape.name);
        if (scheme.word.rings != Rings::off || scheme.name == "pipe(8)") continue;
        check(scheme.word, with_points(dice, shape.mesh), rounds_for(scheme.word, 2));
      }
    }
  }

  TEST_CASE("plans of words with directions and rings agree with run on tubes and tori") {
    for (const NamedWord& scheme : quad_schemes()) {
      CAPTURE(scheme.name);
      check(scheme.word, torus<double>(8, 5, 3, 1), 2);
      check(scheme.word, tube<double>(8, (Points<double>(4, 2) << 1, 0, 2, 1, 1, 2, 3, 3).finished()), 3);
    }
  }

  TEST_CASE("plans on triangles agree with run") {
    Dice dice(82);
    for (const NamedWord& scheme : triangle_schemes()) {
      for (const NamedMesh& shape : triangle_meshes()) {
        CAPTURE(scheme.name);
        CAPTURE(shape.name);
        check(scheme.word, with_points(dice, shape.mesh), rounds_for(scheme.word, 3));
      }
    }
  }

  TEST_CASE("plans of longer words agree with run") {
    Dice dice(83);
    for (const NamedWord& word : other_words()) {
      for (const NamedMesh& shape : quad_meshes()) {
        CAPTURE(word.name);
        CAPTURE(shape.name);
        check(word.word, with_points(dice, shape.mesh), rounds_for(word.word, 2));
      }
    }
  }

  TEST_CASE("plans on polygon meshes start after the first round") {
    Dice dice(84);
    for (const NamedMesh& shape : polygon_meshes()) {
      CAPTURE(shape.name);
      check(schemes::catmull_clark(), with_points(dice, shape.mesh), 3);
      check(scheme("UCCP"), with_points(dice, shape.mesh), 3);
    }
  }

  TEST_CASE("plans of random words on random meshes with holes and corners agree with run") {
    Dice dice(85);
    for (int k = 0; k < 40; ++k) {
      const Word word = scheme(random_atoms(dice), dice.one_in(2) ? value(1, 2) : nullptr, dice.one_in(2) ? value(1, 3) : nullptr,
                               value(dice.between(-1, 1)));
      if (!planned_word(word) || arity(word) > 6) continue;
      Surface<double> surface = with_points(dice, random_mesh(dice, true));
      surface.tags = random_corners(dice, *surface.mesh, 4);
      CAPTURE(atoms(word, 1));
      check(word, surface, arity(word) > 3 ? 1 : 2);
    }
  }

  TEST_CASE("plans with a head or of a finite operator or from a later round agree with run") {
    Dice dice(86);
    const Surface<double> surface = with_points(dice, *cube<double>().mesh);
    Word headed = circle(4, "UCP", ratio(4, 5));
    headed.head = items("UCC");
    check(headed, surface, 2);
    check(operation("UCPUC"), surface, 2);
    PlanControl later;
    later.run.first_item = 6;
    check(circle(4, "UCP", ratio(4, 5)), surface, 2, later);
  }

  TEST_CASE("one more ring of faces changes nothing and has weights 0") {
    const Surface<double> surface = torus<double>(8, 5, 3, 1);
    for (const auto& words : {quad_schemes(), other_words()}) {
      for (const NamedWord& word : words) {
        CAPTURE(word.name);
        CHECK(difference_of_wider_rings<4>(word.word, surface, rounds_for(word.word, 2)) < 1e-14);
      }
    }
    for (const NamedMesh& shape : quad_meshes()) {
      CAPTURE(shape.name);
      const Surface<double> open{
          std::make_shared<const Mesh>(shape.mesh), Points<double>::Zero(shape.mesh.vertices(), 1), {}, {}};
      CHECK(difference_of_wider_rings<4>(scheme("UCCP"), open, 2) < 1e-14);
    }
    for (const NamedWord& word : triangle_schemes()) {
      for (const NamedMesh& shape : triangle_meshes()) {
        CAPTURE(word.name);
        CAPTURE(shape.name);
        const Surface<double> open{
            std::make_shared<const Mesh>(shape.mesh), Points<double>::Zero(shape.mesh.vertices(), 1), {}, {}};
        CHECK(difference_of_wider_rings<3>(word.word, open, 2) < 1e-14);
      }
    }
  }
}
