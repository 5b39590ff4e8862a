// Words built in C++, for tests below the language; the classical ones by their names.
#pragma once

#include "operators/schemes.h"

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

using schemes::catmull_clark;
using schemes::loop;

}  // namespace udcp::oracle
