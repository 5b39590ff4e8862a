// The Python checker of certificates, which shares nothing with this program, says the same of certificates about curves and
// about regular surfaces as verify(): of sound ones, of changed ones, and of changed ones with a digest that fits.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "operators/shapes.h"
#include "proofs/curve_smoothness.h"
#include "proofs/regularity/regular_surface.h"
#include "tests/oracle/expected_curves.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/leaves.h"
#include "tests/proofs/regularity_meshes.h"

using namespace udcp;
using oracle::scheme;
using oracle::value;

namespace {

/// A folder of its own, gone at the end.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("udcp_certificates_" + std::to_string(std::random_device{}()));
  Folder() { std::filesystem::create_directory(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

bool has_python() { return std::system("python3 -c 'import fractions' > /dev/null 2>&1") == 0; }

/// The word after the file's name on each line: "accepted", "rejected" or "cannot".
std::vector<std::string> second_opinions(const std::vector<Json>& certificates) {
  const Folder folder;
  std::string names;
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    const std::string name = std::to_string(k) + ".json";
    std::ofstream(folder.path / name) << certificates[k].dump(2);
    names += " " + name;
  }
  const std::string command = "cd '" + folder.path.string() + "' && python3 '" + UDCP_TEST_DATA +
                              "/../../examples/check_certificate.py'" + names + " > answers.txt 2>&1";
  (void)std::system(command.c_str());
  std::vector<std::string> result;
  std::ifstream answers(folder.path / "answers.txt");
  for (std::string line; std::getline(answers, line);) {
    CAPTURE(line);
    const std::string expected = std::to_string(result.size()) + ".json: ";
    REQUIRE(line.rfind(expected, 0) == 0);
    result.push_back(line.substr(expected.size(), line.find_first_of(" :", expected.size()) - expected.size()));
  }
  REQUIRE(result.size() == certificates.size());
  return result;
}

const std::vector<Json>& sound_certificates() {
  static const std::vector<Json> certificates = [] {
    std::vector<Json> result;
    const auto keep = [&](const Result& r) {
      if (r.certificate) result.push_back(*r.certificate);
    };
    for (const Json& record : oracle::expected_curves()["static"]) {
      const Word word = oracle::expected_word(record);
      const Regularity regularity = holder(word);
      keep(regularity.result);
      keep(prove_smooth(word, regularity.smoothness));
      keep(prove_smooth(word, regularity.smoothness + 1));
    }
    keep(prove_smooth(scheme("UCP", nullptr, value(1232, 400)), 1));
    keep(prove_converges(scheme("UCP", nullptr, value(8))));
    keep(holder(scheme("UC", value(0))).result);
    return result;
  }();
  return certificates;
}

/// Some leaves of each certificate changed; in the data also with a digest that fits.
std::vector<Json> changed_certificates(const std::vector<Json>& certificates, int changes, oracle::Dice& dice) {
  std::vector<Json> changed;
  for (const Json& certificate : certificates) {
    const std::vector<std::string> leaves = oracle::leaves(certificate);
    for (int k = 0; k < changes; ++k) {
      const Json::json_pointer leaf(leaves[static_cast<std::size_t>(dice.below(static_cast<int>(leaves.size())))]);
      const auto others = oracle::other_values(certificate[leaf]);
      Json other = certificate;
      other[leaf] = others[static_cast<std::size_t>(dice.below(static_cast<int>(others.size())))];
      if (other == certificate) continue;
      changed.push_back(other);
      if (leaf.to_string().rfind("/data", 0) == 0) changed.push_back(seal(other["kind"], other["statement"], other["data"]));
    }
  }
  return changed;
}

/// How many certificates both checkers accept; they must not differ.
int count_agreed(const std::vector<Json>& certificates) {
  const std::vector<std::string> answers = second_opinions(certificates);
  int accepted = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Verification verification = verify(certificates[k]);
    CAPTURE(certificates[k].dump());
    CAPTURE(verification.reason);
    // A kind that only one of the two has heard of is not accepted by either.
    CHECK((answers[k] == "accepted") == verification.accepted);
    accepted += verification.accepted;
  }
  return accepted;
}

Json surface_certificate(const Surface<Rational>& surface, RegularityTest test = RegularityTest::t2,
                         RegularityMode mode = RegularityMode::bspline) {
  RegularityOptions options;
  options.test = test;
  options.mode = mode;
  options.except_boundary = true;
  const Result result = prove_regular(surface, options);
  REQUIRE(result.certificate);
  return *result.certificate;
}

/// Two rings of quads around a vertex of valence 5 in the plane, one inner vertex pulled over: no patch, and a ring that folds.
Surface<Rational> folded_fan() {
  constexpr int n = 5;
  const int spokes[n][2] = {{10, 0}, {3, 10}, {-8, 6}, {-8, -6}, {3, -10}},
            places[6][2] = {{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {1, 2}};
  Surface<Rational> surface;
  surface.points = Points<Rational>::Zero(1 + 6 * n, 2);
  const auto at = [](int place, int s) { return 1 + n * place + s % n; };
  std::vector<std::vector<int>> faces;
  for (int s = 0; s < n; ++s) {
    for (int place = 0; place < 6; ++place)
      for (int c = 0; c < 2; ++c)
        surface.points(at(place, s), c) = places[place][0] * spokes[s][c] + places[place][1] * spokes[(s + 1) % n][c];
    faces.push_back({0, at(0, s), at(1, s), at(0, s + 1)});
    faces.push_back({at(0, s), at(2, s), at(3, s), at(1, s)});
    faces.push_back({at(1, s), at(3, s), at(4, s), at(5, s)});
    faces.push_back({at(0, s + 1), at(1, s), at(5, s), at(2, s + 1)});
  }
  surface.points.row(at(1, 0)) << Rational(-10), Rational(-10);
  surface.mesh = std::make_shared<const Mesh>(make_mesh(1 + 6 * n, faces));
  return surface;
}

/// In a plane that is turned about the x axis and moved.
Surface<Rational> tilted(Surface<Rational> surface) {
  const Rational c = Rational(3) / Rational(5), s = Rational(4) / Rational(5);
  REQUIRE(surface.points.cols() == 3);
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    const Rational y = surface.points(v, 1);
    REQUIRE(surface.points(v, 2).is_zero());
    surface.points.row(v) << surface.points(v, 0) + Rational(1) / Rational(7), c * y - Rational(2), s * y + Rational(3);
  }
  return surface;
}

/// In the plane and in space, by all tests, split, with and without rings, embedded, and refuted in all ways.
std::vector<Json> certificates_of_surfaces() {
  using oracle::regularity_mesh;
  std::vector<Json> result;
  for (const RegularityTest test : {RegularityTest::t2, RegularityTest::t3, RegularityTest::t4})
    result.push_back(surface_certificate(regularity_mesh("helicoid3d"), test));
  result.push_back(surface_certificate(regularity_mesh("star6")));
  result.push_back(surface_certificate(regularity_mesh("needs_steps_d"), RegularityTest::t4));
  result.push_back(surface_certificate(regularity_mesh("ring5"), RegularityTest::t3, RegularityMode::interior));
  result.push_back(surface_certificate(regularity_mesh("grid_regular")));
  result.push_back(surface_certificate(regularity_mesh("ce_opposite")));
  result.push_back(surface_certificate(regularity_mesh("cusp3d_dyadic")));
  result.push_back(surface_certificate(tilted(regularity_mesh("grid_folded"))));
  result.push_back(surface_certificate(tilted(regularity_mesh("star5"))));
  result.push_back(surface_certificate(folded_fan(), RegularityTest::t2, RegularityMode::interior));
  return result;
}

Json certificate_of_cube() { return surface_certificate(cube<Rational>()); }

}  // namespace

TEST_SUITE_BEGIN("proofs");

TEST_CASE("the Python checker accepts what the provers of curves certify") {
  if (!has_python()) {
    MESSAGE("skipped: there is no python3 here");
    return;
  }
  const std::vector<std::string> answers = second_opinions(sound_certificates());
  CHECK(answers.size() > 70);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    CAPTURE(sound_certificates()[k]["statement"].get<std::string>());
    CHECK(answers[k] == "accepted");
  }
  const KernelPtr golden =
      formula([](const auto& c) { return cos(std::decay_t<decltype(c.alpha)>::pi(Rational(2) / Rational(5))); },
              Needs{false, false, false});
  CHECK(second_opinions({*prove_converges(scheme("UCP", golden)).certificate}) == std::vector<std::string>{"cannot"});
}

TEST_CASE("both checkers agree on changed certificates of curves") {
  if (!has_python()) {
    MESSAGE("skipped: there is no python3 here");
    return;
  }
  oracle::Dice dice(31);
  const int accepted = count_agreed(changed_certificates(sound_certificates(), 4, dice));
  CHECK(accepted < 60);  // other bases of a polytope, other products: proofs of the same
}

TEST_CASE("the Python checker accepts what is certified of regular and irregular surfaces") {
  if (!has_python()) {
    MESSAGE("skipped: there is no python3 here");
    return;
  }
  std::vector<Json> certificates = certificates_of_surfaces();
  REQUIRE(certificates.size() == 12);
  certificates.push_back(certificate_of_cube());
  certificates.push_back(surface_certificate(oracle::regularity_mesh("mech_part")));  // but for faces around boundary vertices
  for (const std::string& answer : second_opinions(certificates)) CHECK(answer == "accepted");
}

TEST_CASE("both checkers agree on changed certificates of surfaces") {
  if (!has_python()) {
    MESSAGE("skipped: there is no python3 here");
    return;
  }
  oracle::Dice dice(32);
  std::vector<Json> changed = changed_certificates(certificates_of_surfaces(), 6, dice);
  for (Json& other : changed_certificates({certificate_of_cube()}, 6, dice)) changed.push_back(std::move(other));
  const int accepted = count_agreed(changed);
  CHECK(accepted < 30);  // other normals that separate, other points where a Jacobian has these signs
}

TEST_CASE("neither checker accepts less than all patches rings and levels") {
  if (!has_python()) {
    MESSAGE("skipped: there is no python3 here");
    return;
  }
  std::vector<Json> wrong;
  const auto resealed = [&](const Json& certificate, const auto& change) {
    Json data = certificate["data"];
    change(data);
    wrong.push_back(seal(certificate["kind"], certificate["statement"], data));
  };
  const Json cube_surface = certificate_of_cube(), split = surface_certificate(oracle::regularity_mesh("ring5"));
  resealed(cube_surface, [](Json& data) { data["patches"].erase(7); });
  resealed(cube_surface, [](Json& data) { data["rings"].erase(7); });
  resealed(cube_surface, [](Json& data) { std::swap(data["rings"][0], data["rings"][1]); });
  resealed(cube_surface, [](Json& data) {  // the ring that is left out is regular, but the inequality needs it
    data["rings"][0]["level"] = data["rings"][0]["level"].get<int>() - 1;
    data["rings"][0]["rings"].erase(data["rings"][0]["rings"].size() - 1);
  });
  resealed(split, [](Json& data) {
    for (Json& leaves : data["patches"])
      if (leaves.size() > 1) leaves.erase(0);
  });
  resealed(split, [](Json& data) {
    for (Json& leaves : data["patches"])
      if (leaves.size() > 1) leaves.push_back(leaves[0]);
  });
  resealed(split, [](Json& data) {
    for (Json& leaves : data["patches"])
      if (leaves.size() > 1) leaves = Json::array({Json{{"path", ""}, {"test", "T2"}, {"sign", 1}}});
  });
  CHECK(count_agreed(wrong) == 0);
}

TEST_SUITE_END();
