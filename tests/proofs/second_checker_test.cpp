// The Python checker of certificates, which shares nothing with this program, says the same of certificates about curves as
// verify(): of sound ones, of changed ones, and of changed ones with a digest that fits.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "proofs/curve_smoothness.h"
#include "tests/oracle/expected_curves.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/leaves.h"

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
  std::vector<Json> changed;
  for (const Json& certificate : sound_certificates()) {
    const std::vector<std::string> leaves = oracle::leaves(certificate);
    for (int k = 0; k < 4; ++k) {
      const Json::json_pointer leaf(leaves[static_cast<std::size_t>(dice.below(static_cast<int>(leaves.size())))]);
      const auto others = oracle::other_values(certificate[leaf]);
      Json other = certificate;
      other[leaf] = others[static_cast<std::size_t>(dice.below(static_cast<int>(others.size())))];
      if (other == certificate) continue;
      changed.push_back(other);
      if (leaf.to_string().rfind("/data", 0) == 0) changed.push_back(seal(other["kind"], other["statement"], other["data"]));
    }
  }
  const std::vector<std::string> answers = second_opinions(changed);
  CHECK(answers.size() > 500);
  int accepted = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Verification verification = verify(changed[k]);
    CAPTURE(changed[k].dump());
    CAPTURE(verification.reason);
    // A kind that only one of the two has heard of is not accepted by either.
    CHECK((answers[k] == "accepted") == verification.accepted);
    accepted += verification.accepted;
  }
  CHECK(accepted < 60);  // other bases of a polytope, other products: proofs of the same
}

TEST_SUITE_END();
