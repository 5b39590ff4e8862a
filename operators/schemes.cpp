// Classical schemes as words.
#include "operators/schemes.h"

namespace udcp::schemes {
namespace {

/// (U C P)* where omega = 0 and delta is a formula in the valence.
template <class Delta>
Word split_convolve_push(Ngon ngon, bool triangles, Delta delta) {
  Item split, convolve, push;
  convolve.atom = Atom::convolve;
  convolve.ngon = ngon;
  push.atom = Atom::push_back;
  push.omega = Directional<KernelPtr>::all(constant(Rational(0)));
  push.delta = formula(delta, {true, false, false});
  Word word;
  word.tail = {split, convolve, push};
  word.triangles = triangles;
  validate(word);
  return word;
}

}  // namespace

const Word& catmull_clark() {
  static const Word word =
      split_convolve_push(Ngon::classic, false, [](const auto& c) { return decltype(c.alpha)(c.valence - 4) / c.valence; });
  return word;
}

const Word& loop() {
  static const Word word = split_convolve_push(Ngon::dual, true, [](const auto& c) {
    using Q = std::decay_t<decltype(c.alpha)>;
    const Q root = Q(3) / 8 + cos(Q::pi(Rational(2)) / c.valence) / 4;
    return 1 - Q(8) / 3 * (Q(5) / 8 - root * root);
  });
  return word;
}

}  // namespace udcp::schemes
