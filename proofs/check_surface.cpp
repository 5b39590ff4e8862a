// Checkers of surface certificates: conditions of the theorem of Reif, Peters and Zorin at one valence, and their failure. They
// derive rows and masks from the atoms again and search for nothing.
#include "proofs/characteristic_ring.h"
#include "proofs/checkers.h"
#include "proofs/surface_facts.h"

namespace udcp {
namespace {

template <class S>
void check_regular(const RegularPart<S>& part, const Json& data) {
  require_entries(data, {"rounds", "norm"}, "regular");
  const int rounds = integer_from(data["rounds"], 1, longest_contraction, "regular.rounds");
  const S norm = regular_bound(part, rounds);
  require(norm < S(1), "the difference schemes of the regular part do not contract in these rounds");
  require(to_json(norm) == data["norm"], "regular.norm is not the norm of the difference schemes");
}

template <class S>
Eigenpair check_spectrum(const LocalFacts<S>& facts, const Json& data) {
  const ApproximatePair near = pair_from(data);
  const std::optional<Eigenpair> pair = enclose_eigenpair(block(facts.enclosed, facts.radius, 1), near);
  require(pair.has_value(), "eigenpair is not near one eigenpair of frequency 1");
  require(is_nearest(near, *pair), "eigenpair is not the one of frequency 1 in its precision");
  require(pair->value > Interval(0) && pair->value < Interval(1), "the subdominant eigenvalue is not between 0 and 1");
  require(Interval::from_double(other_eigenvalues_bound(facts, *pair)) < pair->value,
          "the other eigenvalues are not bounded below the subdominant one");
  return *pair;
}

/// Follows a list of cells: '1' is a cell in four children, '0' one that must be accepted.
class CellReader {
 public:
  CellReader(const RingTest& test, int valence, const std::string& code) : test_(test), valence_(valence), code_(code) {}

  void read(const RingTest::Cell& cell, int depth) {
    require(next_ < code_.size() && depth <= deepest_cell, "ring.cells ends early or goes too deep");
    const char symbol = code_[next_++];
    require(symbol == '0' || symbol == '1', "ring.cells must consist of 0 and 1");
    if (symbol == '0') return require(test_.accepts(cell, valence_), "a cell of the ring has no positive bound");
    for (int k = 0; k < 4; ++k) read(test_.child(cell, k), depth + 1);
  }
  [[nodiscard]] bool is_at_end() const { return next_ == code_.size(); }

 private:
  const RingTest& test_;
  int valence_;
  const std::string& code_;
  std::size_t next_ = 0;
};

template <class S>
void check_hulls(const SurfaceFacts<S>& facts, const CharacteristicNet& net, const Json& cells) {
  require(cells.is_array() && cells.size() == facts.ring.cells.size(),
          "ring.cells must have " + std::to_string(facts.ring.cells.size()) + " entries");
  const std::optional<RingTest> test = RingTest::of(facts.part, facts.sets);
  require(test.has_value(), "the limits over a cell cannot be bounded");
  for (std::size_t k = 0; k < cells.size(); ++k) {
    require(cells[k].is_string(), "ring.cells must be texts");
    const auto code = cells[k].get<std::string>();
    CellReader reader(*test, net.sectors().valence, code);
    reader.read(test->cell(net, facts.ring.cells[k]), 0);
    require(reader.is_at_end(), "ring.cells has text left over");
  }
}

template <class S>
void check_ring(const SurfaceFacts<S>& facts, const CharacteristicNet& net, const Json& data) {
  if (entry(data, "method") == "hull") {
    require_entries(data, {"method", "cells"}, "ring");
    return check_hulls(facts, net, data["cells"]);
  }
  require_entries(data, {"method"}, "ring");
  require(data["method"] == "bernstein", "ring.method must be \"hull\" or \"bernstein\"");
  require(!net.sectors().triangles && is_bicubic(facts.part.mask), "the regular part is not bicubic");
  const BernsteinBounds bounds = bernstein_bounds(net);
  require(bounds.jacobian > Interval(0), "the Jacobian of the characteristic map has no positive bound");
  require(bounds.half_plane > Interval(0), "the image of a sector is not in its half plane");
}

template <class S>
void check_c1(const Word& word, int valence, const Json& data) {
  const SurfaceFacts<S> facts = surface_facts<S>(word, valence);
  check_regular(facts.part, data["regular"]);
  const Eigenpair pair = check_spectrum(facts.local, data["eigenpair"]);
  check_ring(facts, characteristic_net(facts, pair), data["ring"]);
}

}  // namespace

std::string check_surface_c1(const Json& data, StopFlag) {
  require_entries(data, {"word", "valence", "regular", "eigenpair", "ring"}, "data");
  const Interval::Precision precision(proof_precision);
  const int valence = integer_from(data["valence"], 3, largest_proof_valence, "valence");
  const Word word = surface_word_from(data["word"], valence);
  is_rational_word(data["word"]) ? check_c1<Rational>(word, valence, data) : check_c1<Algebraic>(word, valence, data);
  return c1_statement(data["word"], valence);
}

std::string check_surface_spectrum(const Json& data, StopFlag) {
  const bool multiple = data.is_object() && data.contains("multiple");
  if (multiple)
    require_entries(data, {"word", "valence", "multiple"}, "data");
  else
    require_entries(data, {"word", "valence", "frequency"}, "data");
  const Interval::Precision precision(proof_precision);
  const int valence = integer_from(data["valence"], 3, largest_proof_valence, "valence");
  const Word word = surface_word_from(data["word"], valence);
  if (multiple) {
    const Rational root = rational_from(data["multiple"], "multiple");
    const LocalFacts<Algebraic> facts = local_facts<Algebraic>(word, valence);
    require(is_multiple_and_dominant(facts.patch, facts.radius, root),
            "multiple is not a multiple eigenvalue of frequency 1 above the others");
    return multiple_statement(data["word"], valence, root);
  }
  const int frequency = integer_from(data["frequency"], 0, valence / 2, "frequency");
  require(frequency != 1, "frequency must not be 1");
  require(is_rational_word(data["word"]) ? is_frequency_above(local_facts<Rational>(word, valence), frequency)
                                         : is_frequency_above(local_facts<Algebraic>(word, valence), frequency),
          "no eigenvalue of the frequency is bounded above those of frequency 1");
  return frequency_statement(data["word"], valence, frequency);
}

}  // namespace udcp
