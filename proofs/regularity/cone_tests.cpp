// The vectors of the tests T2 to T4, and the signs that make a witness.
#include "proofs/regularity/cone_tests.h"

#include <algorithm>

#include "proofs/regularity/half_space.h"

namespace udcp {
namespace {

std::vector<Vector3> nonzero(std::vector<Vector3> vectors) {
  std::erase_if(vectors, [](const Vector3& w) { return is_zero(w); });
  return vectors;
}

Differences plain_differences(BicubicNet net) {
  net.flagged = {};
  return differences(net);
}

bool have_corners(const Differences& bezier) {
  const auto nonzero_at = [](const std::vector<Vector3>& list, std::initializer_list<std::size_t> corners) {
    return std::none_of(corners.begin(), corners.end(), [&](std::size_t k) { return is_zero(list[k]); });
  };
  return nonzero_at(bezier.u, {0, 2, 9, 11}) && nonzero_at(bezier.v, {0, 3, 8, 11});
}

template <class Condition>
bool all(const std::vector<Vector3>& vectors, Condition condition) {
  return std::all_of(vectors.begin(), vectors.end(), condition);
}

bool have_sign(const std::vector<Vector3>& normals, int sign) {
  return sign != 0 && all(normals, [&](const Vector3& w) { return w[2].sign() == sign; });
}

}  // namespace

std::string to_string(RegularityTest test) {
  return test == RegularityTest::t2 ? "T2" : test == RegularityTest::t3 ? "T3" : "T4";
}

std::optional<RegularityTest> regularity_test_from(const std::string& name) {
  for (const RegularityTest test : {RegularityTest::t2, RegularityTest::t3, RegularityTest::t4})
    if (to_string(test) == name) return test;
  return std::nullopt;
}

std::optional<ConeVectors> cone_vectors(const BicubicNet& net, RegularityTest test) {
  if (test == RegularityTest::t2 && !has_full_corners(net)) return std::nullopt;
  Differences all = test == RegularityTest::t2 ? differences(net) : plain_differences(bezier(net));
  if (test == RegularityTest::t3 && !have_corners(all)) return std::nullopt;
  return ConeVectors{nonzero(std::move(all.u)), nonzero(std::move(all.v))};
}

std::optional<std::vector<Vector3>> normal_vectors(const BicubicNet& net) {
  const std::array<Vector3, 36> all = normal_net(net);
  for (const std::size_t k : {0U, 5U, 30U, 35U})
    if (is_zero(all[k])) return std::nullopt;
  return nonzero({all.begin(), all.end()});
}

std::vector<Vector3> all_determinants(const ConeVectors& cones) {
  std::vector<Vector3> result;
  result.reserve(cones.u.size() * cones.v.size());
  for (const Vector3& u : cones.u)
    for (const Vector3& v : cones.v) result.push_back(cross(u, v));
  return result;
}

bool is_witness(const RegularityWitness& witness, const BicubicNet& net, RegularityTest test, bool planar) {
  if (test == RegularityTest::t4) {
    const std::optional<std::vector<Vector3>> normals = normal_vectors(net);
    if (!normals) return false;
    return planar ? have_sign(*normals, witness.sign) : witness.n && is_positive_on(*witness.n, *normals);
  }
  const std::optional<ConeVectors> cones = cone_vectors(net, test);
  if (!cones) return false;
  if (planar) return have_sign(all_determinants(*cones), witness.sign);
  if (!witness.n || !witness.m) return false;
  return is_positive_on(*witness.n, cones->u) && is_positive_on(-*witness.n, cones->v) && is_positive_on(*witness.m, cones->u) &&
         is_positive_on(*witness.m, cones->v);
}

Vector3 corner_normal(const BicubicNet& net, int r, int c) {
  const CornerValues values = corner(net, r, c);
  return cross(values.du, values.dv);
}

ParameterSquare square_of(const std::string& path) {
  ParameterSquare square{0, 0, 1};
  for (const char digit : path) {
    square.size /= Rational(2);
    if ((digit - '0') % 2 == 1) square.u += square.size;
    if ((digit - '0') / 2 == 1) square.v += square.size;
  }
  return square;
}

}  // namespace udcp
