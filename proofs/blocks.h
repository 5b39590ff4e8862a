// The subdivision matrix by frequencies: its blocks under the discrete Fourier transform around an extraordinary point, enclosed
// as real matrices or exact over the cosine of the frequency. Knows no eigenvalues.
#pragma once

#include "proofs/patch.h"
#include "proofs/polynomial.h"

namespace udcp {

/// Real coordinates of a net of frequency m that equals its mirror image: the value at (s, a, b) is e^{2 pi i m s/n} times
/// x (on the spoke), x e^{i pi m/n} (on the diagonal), x + iy and e^{2 pi i m/n} (x - iy) at a pair (a, b), (b, a) with a > b.
/// Such nets carry every block B_m as a real matrix, because the rows are mirror symmetric.
struct Coordinate {
  Label orbit;             // of sector 0; a >= b
  bool imaginary = false;  // y
};
std::vector<Coordinate> coordinates(const Sectors& sectors, int radius);

/// B_m on the points within an invariant radius, in the coordinates above. For m = 0 it acts on nets modulo constants: those that
/// vanish at the centre (which is no coordinate), or in the first coordinate, which is dropped, if there is no centre.
Points<Interval> block(const Patch<Interval>& patch, int radius, int frequency);

/// The value of a net with these coordinates at a point, as real and imaginary part.
struct Complex {
  Interval re, im;
};
Complex value_at(const Patch<Interval>& patch, int frequency, const Label& label, const std::vector<Interval>& coordinates,
                 const std::vector<Coordinate>& names);
/// e^{pi i numerator/valence}
Complex unit(int numerator, int valence);
Complex operator*(const Complex& a, const Complex& b);
Complex operator+(const Complex& a, const Complex& b);
Complex operator-(const Complex& a, const Complex& b);

/// The characteristic polynomial of B_m, exact, over Q(cos(2 pi m/n)) and the field of the rows. m = 0: with the centre.
Polynomial<Algebraic> block_polynomial(const Patch<Algebraic>& patch, int radius, int frequency);
/// Sizes of the Jordan blocks of B_m at an eigenvalue, largest first.
std::vector<int> block_jordan(const Patch<Algebraic>& patch, int radius, int frequency, const Algebraic& eigenvalue);

/// p(x, c) with c = cos(2 pi m/n), m != 0, for all valences at once: [i][j] is the coefficient of x^i c^j, monic in x. `patch`
/// must have parameters that do not depend on the valence (or matter at the centre only, where m != 0 does not look) and a
/// valence so large that no row reaches round; means over all sectors count as 0. Error{limit, "E_TOO_LARGE"} otherwise.
std::vector<std::vector<Algebraic>> polynomial_in_cosine(const Patch<Algebraic>& patch, int radius);

}  // namespace udcp
