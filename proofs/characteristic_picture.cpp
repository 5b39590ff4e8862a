// Limit points and Jacobians over the cells of the characteristic ring.
#include "proofs/characteristic_picture.h"

#include <algorithm>
#include <cmath>

#include "proofs/characteristic_ring.h"
#include "proofs/eigenvalues.h"
#include "proofs/surface_facts.h"

namespace udcp {
namespace {

/// The limit at a corner of the cell: its data shrink to it.
std::complex<double> limit_at(const CellScheme& scheme, CellScheme::Data data, int corner) {
  for (int round = 0; round < 16; ++round) data = scheme.child(data, corner);
  std::complex<double> sum = 0;
  for (const auto& value : data.values) sum += value;
  return sum / static_cast<double>(data.values.size());
}

void collect(const RingTest& test, const RingTest::Cell& cell, int depth, std::vector<CharacteristicCell>& result) {
  if (depth > 0) {
    for (int k = 0; k < 4; ++k) collect(test, test.child(cell, k), depth - 1, result);
    return;
  }
  CharacteristicCell& out = result.emplace_back();
  constexpr std::array<int, 4> around{0, 1, 3, 2};
  for (std::size_t k = 0; k < 4; ++k) out.corners[k] = limit_at(test.position(), cell.position, around[k]);
  out.jacobian = RingTest::typical_jacobian(cell);
}

template <class S>
std::vector<CharacteristicCell> cells_of(const Word& word, int valence, int depth, int rings) {
  const SurfaceFacts<S> facts = surface_facts<S>(word, valence);
  const Points<Interval> matrix = block(facts.local.enclosed, facts.local.radius, 1);
  const std::optional<ApproximatePair> near = approximate_eigenpair(matrix);
  require(near.has_value(), "frequency 1 has no simple real dominant eigenvalue (numerically)");
  const std::optional<Eigenpair> pair = enclose_eigenpair(matrix, *near);
  require(pair.has_value(), "the dominant eigenvalue of frequency 1 cannot be enclosed as a simple one");
  const CharacteristicNet net = characteristic_net(facts, *pair);
  const std::optional<RingTest> test = RingTest::of(facts.part, facts.sets);
  require(test.has_value(), "the limits over a cell cannot be bounded");
  std::vector<CharacteristicCell> sector;
  for (const Place& corner : facts.ring.cells) collect(*test, test->cell(net, corner), depth, sector);
  std::vector<CharacteristicCell> result;
  for (int ring = 0; ring < rings; ++ring) {
    for (int s = 0; s < valence; ++s) {
      const std::complex<double> factor = std::polar(std::pow(pair->value.midpoint(), ring), 2 * std::acos(-1.0) * s / valence);
      for (CharacteristicCell cell : sector) {
        cell.sector = s;
        for (auto& corner : cell.corners) corner *= factor;
        cell.jacobian *= std::norm(factor);
        result.push_back(cell);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<CharacteristicCell> characteristic_cells(const Word& word, int valence, int depth, int rings, std::string* why) {
  const Interval::Precision precision(proof_precision);
  try {
    std::string reason;
    require(has_one_split(word, &reason), reason);
    require(is_static(word), "the parameters change from round to round");
    require(valence >= 3 && valence <= largest_proof_valence, "pictures are made for valences from 3 to 200");
    require(depth >= 0 && depth <= 6 && rings >= 1 && rings <= 20, "at most 6 splits and 20 rings");
    const Json json = to_json(static_limit(word), valences_of(word, valence));
    return is_rational_word(json) ? cells_of<Rational>(word_from(json), valence, depth, rings)
                                  : cells_of<Algebraic>(word_from(json), valence, depth, rings);
  } catch (const Rejected& reason) {
    if (why != nullptr) *why = reason.what();
    return {};
  }
}

}  // namespace udcp
