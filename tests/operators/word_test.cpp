// Static checks of words with their texts, and counts against the meshes and curves that words really make.
#include "operators/word.h"

#include <doctest/doctest.h>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

namespace {

std::string checked(const Word& word) {
  return refusal([&] { validate(word); });
}

Word with_head(const std::string& head, const std::string& tail) {
  Word word = scheme(tail);
  word.head = items(head);
  return word;
}

Counts without_flags(Counts c) {
  c.all_quads = c.all_triangles = false;
  return c;
}

}  // namespace

TEST_SUITE("operators") {
  TEST_CASE("sound words are accepted") {
    for (const char* atoms : {"UCP", "UD", "UDD", "D", "UDDPDDP", "DDUCP", "UUCP", "UPCP", "UDUCP", "U9CP"}) {
      CAPTURE(atoms);
      CHECK(checked(scheme(atoms)) == "accepted");
      CHECK(checked(operation(atoms)) == "accepted");
    }
    CHECK(checked(with_head("UC", "PUC")) == "accepted");
    CHECK(checked(on_triangles(scheme("UCP"))) == "accepted");
  }

  TEST_CASE("each static error names its item") {
    CHECK(checked({}) == "E_EMPTY: the word has no atom");
    CHECK(checked(scheme("PCU")) == "item 0: E_P_NO_U: P pushes back to the points before U, but no U stands before it");
    CHECK(checked(with_head("CC", "CPU")).starts_with("item 3: E_P_NO_U"));
    CHECK(checked(scheme("UDP")) ==
          "item 2: E_P_DUAL: P needs the points to correspond to the vertices before U, but here they are dual");
    CHECK(checked(scheme("UCDDDP")).starts_with("item 5: E_P_DUAL"));
    CHECK(checked(scheme("UDPU")).starts_with("item 2: E_P_DUAL"));
    Word sections = scheme("UCUP");
    sections.tail[2].sections = 1;
    CHECK(checked(sections) == "item 2: E_SECTIONS: U[1]: the section number is from 2 to 1000");
    sections.tail[2].sections = 1001;
    CHECK(checked(sections) == "item 2: E_SECTIONS: U[1001]: the section number is from 2 to 1000");
    CHECK(checked(on_triangles(scheme("UD"))) ==
          "item 1: E_TRI_D: D leaves triangle meshes, so a word `on triangles` cannot use it");
    Word rings = scheme("UCPU3");
    rings.rings = Rings::latitude;
    CHECK(checked(rings) == "item 3: E_RINGS: rings need U[2]; here it is U[3]");
    rings = on_triangles(scheme("UCP"));
    rings.rings = Rings::both;
    CHECK(checked(rings) == "E_RINGS: rings are made of quads; the word is `on triangles`");
  }

  TEST_CASE("parity is checked also where the tail comes round again") {
    CHECK(checked(with_head("U", "PUD")).starts_with("item 1: E_P_DUAL"));
    CHECK(checked(with_head("UDD", "PD")).starts_with("item 3: E_P_DUAL"));
    CHECK(checked(with_head("U", "PDD")) == "accepted");
  }

  TEST_CASE("curves take no rings and no triangles") {
    Word word = scheme("UCP");
    CHECK(refusal([&] { validate_for_curve(word); }) == "accepted");
    word.rings = Rings::longitude;
    CHECK(refusal([&] { validate_for_curve(word); }) == "E_CURVE_WORD: rings has no meaning on curves");
    CHECK(refusal([] { validate_for_curve(on_triangles(scheme("UC"))); }) ==
          "E_CURVE_WORD: `on triangles` has no meaning on curves");
  }

  TEST_CASE("items run through the head once and the tail for ever") {
    const Word word = with_head("UC", "UDD");
    std::string letters;
    for (int i = 0; i < 9; ++i) letters += static_cast<char>(word.item(i).atom);
    CHECK(letters == "UCUDDUDDU");
    CHECK(word.items(0) == 2);
    CHECK(word.items(3) == 11);
    CHECK(operation("UCP").items(2) == 6);
    CHECK(static_cast<char>(operation("UCP").item(4).atom) == 'C');
    CHECK(atoms(with_head("UC", "U3DD"), 2) == "UCU3DD U3DD");
    CHECK(atoms(operation("UD"), 3) == "UD UD UD");
    CHECK(atoms(scheme("UCCP"), 2) == "UCCP UCCP");
    CHECK(refusal([] { (void)scheme("UCP").items(2'000'000'000); }) ==
          "E_TOO_MANY_ROUNDS: 2000000000 rounds make a word of more than 2^31 atoms");
  }

  TEST_CASE("counts foretell the mesh that a word makes") {
    Dice dice(81);
    int compared = 0;
    for (int trial = 0; trial < 150; ++trial) {
      const bool quads = trial % 2 == 0;
      Surface<double> surface = random_surface<double>(dice, random_mesh(dice, quads), 1);
      surface.tags = random_corners(dice, *surface.mesh, 4);
      const std::string text = random_atoms(dice);
      const Word word = dice.one_in(2) ? scheme(text) : operation(text);
      if (arity(scheme(text)) > 8) continue;
      CAPTURE(text);
      CAPTURE(trial);
      const std::string outcome = refusal([&] {
        const Surface<double> fine = run(word, surface, 1);
        const Counts found = counts(*fine.mesh, fine.tags), foretold = counts(word, counts(*surface.mesh, surface.tags), 1);
        CHECK(without_flags(found) == without_flags(foretold));
        ++compared;
      });
      CHECK((outcome == "accepted" || outcome.starts_with("E_USPLIT")));
    }
    CHECK(compared > 75);
  }

  TEST_CASE("counts foretell triangle meshes and closed meshes over two rounds") {
    Dice dice(82);
    for (const NamedMesh& named : triangle_meshes()) {
      for (const char* text : {"UCP", "U3C", "UU4"}) {
        CAPTURE(named.name);
        CAPTURE(text);
        const auto surface = random_surface<double>(dice, named.mesh, 1);
        const Word word = on_triangles(scheme(text));
        const auto fine = run(word, surface, 1);
        CHECK(counts(*fine.mesh, fine.tags) == counts(word, counts(named.mesh, {}), 1));
      }
    }
    for (const NamedMesh& named : polygon_meshes()) {
      for (const char* text : {"UD", "UDD", "UDUD", "UDDD"}) {
        CAPTURE(named.name);
        CAPTURE(text);
        const auto fine = run(scheme(text), random_surface<double>(dice, named.mesh, 1), 2);
        CHECK(without_flags(counts(*fine.mesh, fine.tags)) == without_flags(counts(scheme(text), counts(named.mesh, {}), 2)));
      }
    }
  }

  TEST_CASE("count_points foretells curves") {
    Dice dice(83);
    for (int trial = 0; trial < 100; ++trial) {
      auto curve = random_curve<double>(dice, dice.between(3, 6), dice.one_in(2), 1);
      curve.corner.assign(static_cast<std::size_t>(curve.size()), 0);
      for (char& c : curve.corner) c = dice.one_in(4);
      int corners = 0;
      for (int i = 0; i < curve.size(); ++i) corners += curve.is_corner(i);
      const std::string text = random_atoms(dice);
      CAPTURE(text);
      CAPTURE(trial);
      CHECK(run(scheme(text), curve, 2).size() == count_points(scheme(text), curve.size(), curve.closed, corners, 2));
    }
  }

  TEST_CASE("counts are exact far beyond what memory holds and say where they end") {
    const Counts cube_counts = counts(*cube<Rational>().mesh, {});
    const Counts huge = counts(scheme("U"), cube_counts, 28);
    CHECK(huge.faces == 6 * (std::int64_t{1} << 56));
    CHECK(huge.vertices == huge.faces + 2);  // Euler: every quad has two edges of its own
  }

  TEST_CASE("counts that pass 2^62 or cannot be split are errors") {
    const Counts cube_counts = counts(*cube<Rational>().mesh, {});
    CHECK(refusal([&] { counts(scheme("U"), cube_counts, 40); }) ==
          "E_COUNT_OVERFLOW: the result would have more than 2^62 elements");
    CHECK(refusal([] { count_points(scheme("U9"), 5, true, 0, 30); }) ==
          "E_COUNT_OVERFLOW: the result would have more than 2^62 elements");
    CHECK(refusal([&] { counts(on_triangles(scheme("U")), cube_counts, 1); }) ==
          "E_NOT_TRIANGLES: a word `on triangles` needs a mesh of triangles");
    CHECK(refusal([] { counts(scheme("U3"), counts(prism(5), {}), 1); }) ==
          "E_USPLIT: U[3] splits quads only, and the mesh has other faces");
  }
}
