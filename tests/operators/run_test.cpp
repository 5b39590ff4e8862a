// The execution model: alpha and h, attributes, noise, continuing a run, and the limits of a run.
#include "operators/run.h"

#include <doctest/doctest.h>

#include <cstdint>

#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

KernelPtr one_plus_alpha() {
  return formula([](const auto& c) { return Rational(1) + c.alpha; }, {false, false, true});
}
KernelPtr one_plus_h() {
  return formula([](const auto& c) { return std::decay_t<decltype(c.alpha)>(1 + c.round); }, {false, false, true});
}
KernelPtr attribute(const std::string& name) {
  return formula([name](const auto& c) { return c.attribute(name); }, {false, true, false});
}
KernelPtr noise_of(int seed) {
  return formula([seed]<class S>(const Context<S>& c) { return noise<S>(Rational(seed), c.round, c.vertex); },
                 {false, true, true});
}

// noise(seed) at point i of round h, from the definition of the splitmix64 finaliser.
Rational noise_by_hand(std::uint64_t seed, int h, int i) {
  const std::uint64_t golden = 0x9E3779B97F4A7C15u;
  std::uint64_t x =
      seed + golden * (static_cast<std::uint64_t>(h) * (std::uint64_t{1} << 40) + static_cast<std::uint64_t>(i) + 1);
  x ^= x >> 30;
  x *= 0xBF58476D1CE4E5B9u;
  x ^= x >> 27;
  x *= 0x94D049BB133111EBu;
  x ^= x >> 31;
  return Rational(static_cast<long>(x >> 11)) / pow(Rational(2), 52) - Rational(1);
}

std::vector<Rational> random_column(Dice& dice, int n) {
  std::vector<Rational> column;
  for (int i = 0; i < n; ++i) column.push_back(dice.positive());
  return column;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("alpha halves with every U so that grouping does not matter") {
    Word once = scheme("UCUC", half_cosine()), twice = scheme("UC", half_cosine());
    once.alpha0 = twice.alpha0 = Directional<KernelPtr>::all(turn(ratio(2, 5)));
    Dice dice(91);
    const auto curve = random_curve<Algebraic>(dice, 4, false);
    CHECK(run(once, curve, 1).points == run(twice, curve, 2).points);
    const auto surface = random_surface<Algebraic>(dice, make_mesh(4, Faces{{0, 1, 2}, {2, 1, 3}}), 1);
    CHECK(run(once, surface, 1).points == run(twice, surface, 2).points);
  }

  TEST_CASE("alpha is divided by the section number of the U before") {
    Word word = operation("U3CUCUC", one_plus_alpha());
    word.alpha0.plain = value(5);
    Word expected = operation("U3CUCUC");
    expected.head[1].f.plain = value(1 + 5);
    expected.head[3].f.plain = constant(Rational(1) + ratio(5, 3));
    expected.head[5].f.plain = constant(Rational(1) + ratio(5, 6));
    Dice dice(92);
    for (const bool closed : {true, false}) {
      const auto curve = random_curve<Rational>(dice, 4, closed);
      CHECK(run(word, curve, 1).points == run(expected, curve, 1).points);
    }
    const auto surface = random_surface<Rational>(dice, l_shape(), 1);
    CHECK(run(word, surface, 1).points == run(expected, surface, 1).points);
  }

  TEST_CASE("h counts the U before the last one") {
    Word expected = operation("UCUCUUCUC");
    for (const auto& [item, h] : {std::pair{1, 0}, {3, 1}, {6, 3}, {8, 4}})
      expected.head[static_cast<std::size_t>(item)].f = Directional<KernelPtr>::all(value(1 + h));
    Dice dice(93);
    const auto curve = random_curve<Rational>(dice, 4, true);
    CHECK(run(operation("UCUCUUCUC", one_plus_h()), curve, 1).points == run(expected, curve, 1).points);
  }

  TEST_CASE("the kernel acts on the first D after U only unless the item asks for it") {
    Dice dice(94);
    const auto curve = random_curve<Rational>(dice, 5, true);
    const KernelPtr f = value(3, 7);
    const Word word = operation("UCC", f);
    Word expected = operation("UCC");
    expected.head[1].f.plain = f;
    CHECK(run(word, curve, 1).points == run(expected, curve, 1).points);
    CHECK(run(operation("CUC", f), curve, 1).points == run(operation("UC", f), run(operation("C"), curve, 1), 1).points);
    Word everywhere = word;
    everywhere.head[2].f_everywhere = true;
    CHECK(run(everywhere, curve, 1).points != run(word, curve, 1).points);
    // the second C with weights: twice the curve rule with f at the old points
    const auto first = run(expected, curve, 1), once = run(operation("UC", f), curve, 1);
    const auto second = run(everywhere, curve, 1);
    const int n = once.size();
    for (int i = 0; i < n; ++i) {
      const auto weight = [&](int k) { return k % 2 == 0 ? ratio(3, 7) : Rational(1); };
      const auto row = [&](int k) { return once.points.row((k + n) % n); };
      const Points<Rational> mean =
          (weight(i - 1) * row(i - 1) + weight(i) * row(i)) / (weight(i - 1) + weight(i)) / Rational(2) +
          (weight(i) * row(i) + weight(i + 1) * row(i + 1)) / (weight(i) + weight(i + 1)) / Rational(2);
      CHECK(second.points.row(i) == mean.row(0));
    }
    CHECK(first.size() == n);
  }

  TEST_CASE("alpha0 and attributes differ per vertex and are interpolated") {
    Dice dice(95);
    auto curve = random_curve<Rational>(dice, 5, true);
    curve.attributes["a"] = random_column(dice, 5);
    Word word = operation("UCP", nullptr, one_plus_alpha(), attribute("a"));
    word.alpha0.plain = attribute("a");
    const auto smooth = run(operation("UC"), curve, 1).points, fine = run(word, curve, 1).points;
    const auto& a = curve.attributes.at("a");
    const auto delta = [&](int i) {
      return Points<Rational>(a[static_cast<std::size_t>(i)] * (curve.points.row(i) - smooth.row(2 * i)));
    };
    for (int i = 0; i < 5; ++i) {
      const int j = (i + 1) % 5;
      const Points<Rational> even = smooth.row(2 * i) + delta(i), mean = (delta(i) + delta(j)) / Rational(2);
      const Rational alpha = (a[static_cast<std::size_t>(i)] + a[static_cast<std::size_t>(j)]) / Rational(2);
      const Points<Rational> odd = smooth.row(2 * i + 1) + (Rational(1) + alpha) * mean;
      CHECK(fine.row(2 * i) == even.row(0));
      CHECK(fine.row(2 * i + 1) == odd.row(0));
    }
    // f at the vertex's own alpha
    word = operation("UD", one_plus_alpha());
    word.alpha0.plain = attribute("a");
    const auto up = run(operation("U"), curve, 1).points, dual = run(word, curve, 1).points;
    for (int i = 0; i < 5; ++i) {
      const Rational w = Rational(1) + a[static_cast<std::size_t>(i)];
      const Points<Rational> after = (w * up.row(2 * i) + up.row(2 * i + 1)) / (w + Rational(1));
      CHECK(dual.row(2 * i) == after.row(0));
    }
  }

  TEST_CASE("attributes get linear means by U and plain means by the dual and nothing by D C P") {
    Dice dice(96);
    auto curve = random_curve<Rational>(dice, 4, false);
    curve.attributes["a"] = random_column(dice, 4);
    auto carrier = curve;
    carrier.points = Eigen::Map<const Points<Rational>>(curve.attributes.at("a").data(), 4, 1);
    for (const char* atoms : {"U3", "UD", "D", "UDUD"}) {
      CAPTURE(atoms);
      const auto column = run(operation(atoms, value(5)), curve, 1).attributes.at("a");
      const auto rows = run(operation(atoms), carrier, 1).points;  // plain weights
      CHECK(column == std::vector<Rational>(rows.data(), rows.data() + rows.size()));
    }
    CHECK(run(operation("UCPCP"), curve, 1).attributes == run(operation("U"), curve, 1).attributes);
    auto surface = random_surface<Rational>(dice, prism(5));
    surface.attributes["a"] = random_column(dice, 10);
    auto mesh_carrier = surface;
    mesh_carrier.points = Eigen::Map<const Points<Rational>>(surface.attributes.at("a").data(), 10, 1);
    for (const char* atoms : {"U", "UD", "D", "UDUD"}) {
      CAPTURE(atoms);
      const auto column = run(operation(atoms, value(5)), surface, 1).attributes.at("a");
      const auto rows = run(operation(atoms), mesh_carrier, 1).points;
      CHECK(column == std::vector<Rational>(rows.data(), rows.data() + rows.size()));
    }
    CHECK(run(operation("UCPCP"), surface, 1).attributes == run(operation("U"), surface, 1).attributes);
  }

  TEST_CASE("alpha0 per vertex leaves no attribute behind") {
    Dice dice(97);
    auto curve = random_curve<Rational>(dice, 4, true);
    curve.attributes["a"] = random_column(dice, 4);
    Word word = operation("UC");
    word.alpha0 = Directional<KernelPtr>::all(attribute("a"));
    CHECK(run(word, curve, 1).attributes.size() == 1);
  }

  TEST_CASE("noise is the splitmix64 number of seed and round and point") {
    Dice dice(98);
    const auto curve = random_curve<Rational>(dice, 4, true, 1);
    const Word word = scheme("UCP", nullptr, value(0), noise_of(7));
    Polyline<Rational> now = curve;
    for (int h = 0; h < 3; ++h) {
      RunControl control;
      control.first_item = 3 * h;
      const auto smooth = run(operation("UC"), now, 1).points;
      const auto fine = run(word, now, 1, control);
      for (int i = 0; i < now.size(); ++i)
        CHECK(fine.points(2 * i, 0) == smooth(2 * i, 0) + noise_by_hand(7, h, 2 * i) * (now.points(i, 0) - smooth(2 * i, 0)));
      now = fine;
    }
    CHECK(now.points == run(word, curve, 3).points);
    const auto surface = random_surface<Rational>(dice, prism(5), 1);
    const auto smooth = run(operation("UC"), surface, 1).points, fine = run(word, surface, 1).points;
    for (int v = 0; v < 10; ++v)
      CHECK(fine(v, 0) == smooth(v, 0) + noise_by_hand(7, 0, v) * (surface.points(v, 0) - smooth(v, 0)));
  }

  TEST_CASE("first_item continues a run") {
    Dice dice(99);
    Word word = scheme("UCP", one_plus_alpha(), one_plus_h(), noise_of(3));
    word.head = items("UUC", one_plus_alpha());
    word.alpha0 = Directional<KernelPtr>::all(value(2));
    const auto surface = random_surface<Rational>(dice, make_mesh(4, Faces{{0, 1, 2}, {2, 1, 3}}), 1);
    auto stepwise = run(word, surface, 0);
    for (int round = 0; round < 2; ++round) {
      RunControl control;
      control.first_item = word.items(round);
      stepwise = run(word, stepwise, 1, control);
    }
    CHECK(stepwise.points == run(word, surface, 2).points);
    CHECK(faces_of(*stepwise.mesh) == faces_of(*run(word, surface, 2).mesh));
  }

  TEST_CASE("stationary words may be run round by round") {
    Dice dice(100);
    for (const char* atoms : {"UCP", "UD", "UDUD", "UDDD", "U3CP"}) {
      CAPTURE(atoms);
      const Word word = scheme(atoms, constant(dice.positive()), constant(dice.fraction()), constant(dice.fraction()));
      for (const bool closed : {true, false}) {
        const auto curve = random_curve<Rational>(dice, 4, closed);
        CHECK(run(word, run(word, curve, 1), 1).points == run(word, curve, 2).points);
      }
      const auto surface = random_surface<Rational>(dice, *grid<Rational>(2, 1).mesh, 1);
      if (std::string(atoms) != "UDUD") CHECK(run(word, run(word, surface, 1), 1).points == run(word, surface, 2).points);
    }
  }

  TEST_CASE("a finite operator is applied as often as asked") {
    Dice dice(101);
    const auto curve = random_curve<Rational>(dice, 4, true);
    CHECK(run(operation("UC"), curve, 2).points == run(operation("UCUC"), curve, 1).points);
    CHECK(run(operation("UC"), curve, 0).points == curve.points);
  }

  TEST_CASE("P compares with the points before the latest U as often as it stands") {
    Dice dice(102);
    const auto curve = random_curve<Rational>(dice, 5, true, 1);
    CHECK(run(operation("UP"), curve, 1).points == run(operation("U"), curve, 1).points);
    const auto between = run(operation("U"), curve, 1);
    CHECK(run(operation("UUCP", nullptr, value(3), value(2)), curve, 1).points ==
          run(operation("UCP", nullptr, value(3), value(2)), between, 1).points);
    // twice the same reference: with omega 0 and delta 1 the old points stand where they stood
    const auto fine = run(operation("UCPCP", nullptr, value(0)), curve, 1).points;
    for (int i = 0; i < 5; ++i) CHECK(fine(2 * i, 0) == curve.points(i, 0));
  }
}
