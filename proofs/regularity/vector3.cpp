// Integer arithmetic of rational vectors.
#include "proofs/regularity/vector3.h"

namespace udcp {

Rational greatest_common_divisor(const Rational& a, const Rational& b) {
  if (b.is_zero()) return abs(a);
  return abs(b) / (a / b).denominator();  // a/b in lowest terms has the denominator |b|/gcd
}

Rational least_common_multiple(const Rational& a, const Rational& b) { return abs(a * (b / greatest_common_divisor(a, b))); }

Vector3 primitive(const Vector3& a) {
  const Rational common =
      least_common_multiple(least_common_multiple(a[0].denominator(), a[1].denominator()), a[2].denominator());
  Rational divisor(0);
  for (const Rational& x : a) divisor = greatest_common_divisor(divisor, x * common);
  return divisor.is_zero() ? a : (common / divisor) * a;
}

}  // namespace udcp
