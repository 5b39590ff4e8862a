// The classical schemes as words built in C++, for tests below the language.
#pragma once

#include "operators/word.h"

namespace udcp::oracle {

inline Item item(Atom atom, int sections = 2) {
  Item result;
  result.atom = atom;
  result.sections = sections;
  return result;
}

/// "UCCP" with one kernel for all of its f, omega, delta; null keeps the default 1.
inline Word word(const std::string& atoms, KernelPtr f = nullptr, KernelPtr omega = nullptr, KernelPtr delta = nullptr) {
  Word result;
  for (const char letter : atoms) {
    Item next = item(static_cast<Atom>(letter));
    next.f = Directional<KernelPtr>::all(f);
    next.omega = Directional<KernelPtr>::all(omega);
    next.delta = delta;
    result.tail.push_back(next);
  }
  return result;
}

inline Word catmull_clark() {
  Word result = word("UCP", nullptr, constant(Rational(0)),
                     formula([](const auto& c) { return decltype(c.alpha)(c.valence - 4) / c.valence; }, {true, false, false}));
  result.tail[1].ngon = Ngon::classic;
  return result;
}

inline Word loop() {
  Word result = word("UCP", nullptr, constant(Rational(0)),
                     formula(
                         [](const auto& c) {
                           using Q = std::decay_t<decltype(c.alpha)>;
                           const Q third = Q(3) / 8 + cos(Q::pi(Rational(2)) / c.valence) / 4;
                           return 1 - Q(8) / 3 * (Q(5) / 8 - third * third);
                         },
                         {true, false, false}));
  result.triangles = true;
  return result;
}

}  // namespace udcp::oracle
