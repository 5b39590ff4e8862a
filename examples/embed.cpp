// The library without the language: a word built in C++, in double for modelling and in exact rationals for certainty.
#include <iostream>

#include "files/geometry_file.h"
#include "operators/matrix.h"
#include "operators/run.h"
#include "operators/shapes.h"

int main() {
  using namespace udcp;
  // Catmull-Clark is (UCP)* with omega = 0 and delta = (N - 4)/N.
  Word word;
  for (const Atom atom : {Atom::up, Atom::convolve, Atom::push_back}) {
    Item item;
    item.atom = atom;
    item.omega = Directional<KernelPtr>::all(constant(Rational(0)));
    item.delta = formula([](const auto& c) { return decltype(c.alpha)(c.valence - 4) / c.valence; });
    word.tail.push_back(item);
  }
  const Surface<double> smooth = run(word, cube<double>(), 4);
  save(smooth, "embed.obj");
  const Surface<Rational> exact = run(word, cube<Rational>(), 1);
  std::cout << smooth.mesh->faces() << " faces; the first corner moved to " << exact.points(0, 0) << '\n';
  for (const Rational& weight : mask<Rational>(word).coefficients) std::cout << weight << ' ';
  std::cout << '\n';
  return exact.points(0, 0) == Rational(-5) / Rational(9) ? 0 : 1;
}
