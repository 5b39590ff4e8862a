// Words for tests from their atoms: "U3CDP" is U[3] C D P. Every item gets the same f, omega and delta; null keeps the default 1.
#pragma once

#include "operators/word.h"

namespace udcp::oracle {

inline std::vector<Item> items(const std::string& atoms, KernelPtr f = nullptr, KernelPtr omega = nullptr,
                               KernelPtr delta = nullptr) {
  std::vector<Item> result;
  for (const char letter : atoms) {
    if (letter >= '0' && letter <= '9') {
      result.back().sections = letter - '0';
      continue;
    }
    Item next;
    next.atom = static_cast<Atom>(letter);
    next.f = Directional<KernelPtr>::all(f);
    next.omega = Directional<KernelPtr>::all(omega);
    next.delta = delta;
    result.push_back(next);
  }
  return result;
}

/// (atoms)*
inline Word scheme(const std::string& atoms, KernelPtr f = nullptr, KernelPtr omega = nullptr, KernelPtr delta = nullptr) {
  Word result;
  result.tail = items(atoms, f, omega, delta);
  return result;
}

/// The finite operator.
inline Word operation(const std::string& atoms, KernelPtr f = nullptr, KernelPtr omega = nullptr, KernelPtr delta = nullptr) {
  Word result;
  result.head = items(atoms, f, omega, delta);
  return result;
}

inline Word on_triangles(Word word) {
  word.triangles = true;
  return word;
}

inline Rational ratio(int p, int q) { return Rational(p) / Rational(q); }
inline KernelPtr value(int p, int q = 1) { return constant(ratio(p, q)); }

/// q pi, as for alpha0.
inline KernelPtr turn(const Rational& q) {
  return formula([q](const auto& c) { return std::decay_t<decltype(c.alpha)>::pi(q); }, Needs{false, false, false});
}
/// cos(alpha/2) and its reciprocal: the kernels of the theorems on circles.
inline KernelPtr half_cosine() {
  return formula([](const auto& c) { return cos(c.alpha / Rational(2)); }, Needs{false, false, true});
}
inline KernelPtr inverse_half_cosine() {
  return formula([](const auto& c) { return Rational(1) / cos(c.alpha / Rational(2)); }, Needs{false, false, true});
}
/// (UCP)* and the like with alpha0 = 2 pi/corners.
inline Word circle(int corners, const std::string& atoms, const Rational& delta) {
  Word result = scheme(atoms, half_cosine(), inverse_half_cosine(), constant(delta));
  result.alpha0 = Directional<KernelPtr>::all(turn(ratio(2, corners)));
  return result;
}

}  // namespace udcp::oracle
