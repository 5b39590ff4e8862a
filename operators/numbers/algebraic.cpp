// Arithmetic in Q(cos(2 pi/N)). Notation: c = 2 cos(2 pi/N) generates the field and e_k = 2 cos(2 pi k/N), so that e_0 = 2, e_1 =
// c and c e_k = e_{k+1} + e_{k-1}; the minimal polynomial of c comes from the N-th cyclotomic polynomial by this rule.
#include "operators/numbers/algebraic.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <ostream>

#include "operators/error.h"
#include "operators/numbers/field.h"

namespace udcp {
namespace {

using Polynomial = std::vector<Rational>;

constexpr std::size_t kLargestPower = 10'000'000;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void drop_zeros(Polynomial& p) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
}

}  // namespace

// ---- making values

Algebraic::Algebraic() = default;
Algebraic::Algebraic(const Algebraic&) = default;
Algebraic::Algebraic(Algebraic&&) noexcept = default;
Algebraic& Algebraic::operator=(const Algebraic&) = default;
Algebraic& Algebraic::operator=(Algebraic&&) noexcept = default;
Algebraic::~Algebraic() = default;

Algebraic::Algebraic(int value) : rational_(value) {}
Algebraic::Algebraic(const Rational& value) : rational_(value) {}

Algebraic::Algebraic(std::shared_ptr<const Field> field, Polynomial coefficients) {
  if (std::all_of(coefficients.begin() + 1, coefficients.end(), [](const Rational& x) { return x.is_zero(); })) {
    rational_ = std::move(coefficients.front());
  } else {
    field_ = std::move(field);
    coefficients_ = std::move(coefficients);
  }
}

Algebraic Algebraic::cosine(const Rational& q) {
  const Rational turns = q / Rational(2) - (q / Rational(2)).floor();  // cos(2 pi turns), 0 <= turns < 1
  if (turns.denominator() > Rational(Field::largest_order)) {
    throw Error(
        ErrorKind::limit, "E_FIELD_DEGREE",
        "cos(" + q.to_string().substr(0, 60) + "*pi) lies in a field of a degree above " + std::to_string(Field::largest_degree),
        "use a simpler multiple of pi, or compute in enclosures or floating point");
  }
  int k = turns.numerator().to_int();
  int order = turns.denominator().to_int();
  Rational half = Rational(1) / Rational(2);
  if (order % 4 == 2) {  // the field of the odd half; cos(x) = -cos(x + pi)
    order /= 2;
    k = (k + order) / 2;
    half = -half;
  }
  if (order == 1) return Algebraic(Rational(2) * half);
  if (order == 3) return Algebraic(-half);
  if (order == 4) return Algebraic(0);
  std::shared_ptr<const Field> field = Field::of(order);
  Polynomial coefficients = field->from_cosines({{k, half}});
  return Algebraic(std::move(field), std::move(coefficients));
}

Algebraic::Polynomial Algebraic::lifted(const Field& field) const {
  if (!field_) {
    Polynomial constant(at(field.degree));
    constant[0] = rational_;
    return constant;
  }
  if (field_->order == field.order) return coefficients_;
  // Horner's rule on the basis 1, e_1, e_2, ... turns powers of c into cosines, and those are cosines of the larger field.
  Polynomial weights(at(field_->degree));
  for (std::size_t i = coefficients_.size(); i-- > 0;) {
    Polynomial next(weights.size());
    for (std::size_t k = 0; k + 1 < weights.size(); ++k) next[k + 1] += weights[k];
    for (std::size_t k = 1; k < weights.size(); ++k) next[k - 1] += k == 1 ? Rational(2) * weights[k] : weights[k];
    next[0] += coefficients_[i];
    weights = std::move(next);
  }
  std::vector<std::pair<int, Rational>> terms{{0, weights[0] / Rational(2)}};
  for (int k = 1; k < field_->degree; ++k) terms.emplace_back(k * (field.order / field_->order), weights[at(k)]);
  return field.from_cosines(terms);
}

template <class Operation>
Algebraic& Algebraic::combine(const Algebraic& other, Operation operation) {
  std::shared_ptr<const Field> field = field_ ? field_ : other.field_;
  if (field_ && other.field_ && field_ != other.field_) field = Field::of(std::lcm(field_->order, other.field_->order));
  Polynomial result = operation(*field, lifted(*field), other.lifted(*field));
  return *this = Algebraic(std::move(field), std::move(result));
}

// ---- arithmetic

Algebraic& Algebraic::operator+=(const Algebraic& other) {
  if (!other.field_) {
    (field_ ? coefficients_.front() : rational_) += other.rational_;
    return *this;
  }
  return combine(other, [](const Field&, Polynomial a, const Polynomial& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
  });
}

Algebraic& Algebraic::operator-=(const Algebraic& other) {
  if (!other.field_) {
    (field_ ? coefficients_.front() : rational_) -= other.rational_;
    return *this;
  }
  return combine(other, [](const Field&, Polynomial a, const Polynomial& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
    return a;
  });
}

Algebraic& Algebraic::operator*=(const Algebraic& other) {
  if (is_zero() || other.is_zero()) return *this = Algebraic();
  if (!other.field_) {
    const Rational factor = other.rational_;
    if (!field_) rational_ *= factor;
    for (Rational& coefficient : coefficients_) coefficient *= factor;
    return *this;
  }
  if (!field_) return *this = Algebraic(other) *= Algebraic(rational_);
  return combine(other, [](const Field& field, const Polynomial& a, const Polynomial& b) { return field.product(a, b); });
}

Algebraic& Algebraic::operator/=(const Algebraic& other) { return *this *= other.inverse(); }

Algebraic Algebraic::operator-() const {
  Algebraic result(*this);
  result.rational_ = -result.rational_;
  for (Rational& coefficient : result.coefficients_) coefficient = -coefficient;
  return result;
}

// Extended Euclid on the minimal polynomial m and the value p: keeps r = s p modulo m until r is a constant.
Algebraic Algebraic::inverse() const {
  if (!field_) return Algebraic(Rational(1) / rational_);
  Polynomial r0 = field_->minimal;
  Polynomial r1 = coefficients_;
  Polynomial s0{Rational(0)};
  Polynomial s1{Rational(1)};
  drop_zeros(r1);
  while (r1.size() > 1) {
    const Rational scale = Rational(1) / r1.back();  // monic remainders keep the fractions small
    for (Rational& x : r1) x *= scale;
    for (Rational& x : s1) x *= scale;
    s0.resize(std::max(s0.size(), s1.size() + r0.size() - r1.size()));
    while (r0.size() >= r1.size()) {
      const Rational factor = r0.back();
      const std::size_t shift = r0.size() - r1.size();
      for (std::size_t i = 0; i < r1.size(); ++i) r0[shift + i] -= factor * r1[i];
      for (std::size_t i = 0; i < s1.size(); ++i) s0[shift + i] -= factor * s1[i];
      drop_zeros(r0);
    }
    std::swap(r0, r1);
    std::swap(s0, s1);
  }
  for (Rational& x : s1) x /= r1.front();
  field_->reduce(s1);
  return Algebraic(field_, std::move(s1));
}

// ---- order

namespace {

int checked_precision(int bits) {
  if (bits <= 1 << 19) return bits;
  throw Error(ErrorKind::limit, "E_PRECISION",
              "an algebraic number is so close to zero that half a million bits do not show its sign",
              "use smaller exponents and coefficients");
}

}  // namespace

Interval Algebraic::enclosure() const {
  if (!field_) return Interval(rational_);
  const Interval generator = Interval(2) * cos(Interval(2) * Interval::pi() / Interval(field_->order));
  Interval value;
  for (std::size_t i = coefficients_.size(); i-- > 0;) value = value * generator + Interval(coefficients_[i]);
  return value;
}

int Algebraic::sign() const {
  if (!field_) return rational_.sign();
  for (int bits = 128;; bits *= 2) {  // ends: the value is irrational, so not 0
    const Interval::Precision scope(checked_precision(bits));
    const Interval value = enclosure();
    if (!value.contains_zero()) return value > Interval(0) ? 1 : -1;
  }
}

int Algebraic::compare(const Algebraic& other) const {
  if (!field_ && !other.field_) return rational_.compare(other.rational_);
  if (field_ && other.field_ && field_ != other.field_) {
    const Interval::Precision scope(128);
    const Interval difference = enclosure() - other.enclosure();
    if (!difference.contains_zero()) return difference > Interval(0) ? 1 : -1;
  }
  return (*this - other).sign();
}

bool Algebraic::equals(const Algebraic& other) const {
  if (field_ == other.field_) return rational_ == other.rational_ && coefficients_ == other.coefficients_;
  return field_ && other.field_ && compare(other) == 0;
}

Rational Algebraic::rational() const {
  if (!field_) return rational_;
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT", to_string() + " is irrational, so it is not a fraction",
              "compute in algebraic numbers, enclosures or floating point");
}

double Algebraic::to_double() const {
  if (!field_) return rational_.to_double();
  for (int bits = 128;; bits *= 2) {  // ends: an irrational number is not half-way between two doubles
    const Interval::Precision scope(checked_precision(bits));
    const Interval value = enclosure();
    const double lower = value.lower().to_double();
    if (lower == value.upper().to_double()) return lower;
  }
}

int Algebraic::field_order() const { return field_ ? field_->order : 1; }

std::vector<Rational> Algebraic::coefficients() const { return field_ ? coefficients_ : Polynomial{rational_}; }

// ---- square roots

// x is quadratic if x^2 = s x + t; then x = s/2 +- sqrt(t + s^2/4), and only primes that divide N can stay under the root.
std::optional<Algebraic::Quadratic> Algebraic::quadratic() const {
  if (!field_) return std::nullopt;
  const Polynomial square = field_->product(coefficients_, coefficients_);
  std::size_t pivot = 1;
  while (coefficients_[pivot].is_zero()) ++pivot;
  const Rational s = square[pivot] / coefficients_[pivot];
  for (std::size_t i = 1; i < square.size(); ++i) {
    if (square[i] != s * coefficients_[i]) return std::nullopt;
  }
  const Rational a = s / Rational(2);
  const Rational under = square[0] - s * coefficients_[0] + a * a;
  for (int d = 2; d <= field_->order; ++d) {
    if (field_->order % d != 0 || moebius(d) == 0) continue;
    std::optional<Rational> b = exact_root(under / Rational(d), 2);
    if (b) return Quadratic{a, (*this - Algebraic(a)).sign() < 0 ? -*b : *b, d};
  }
  return std::nullopt;
}

namespace {

// Jacobi symbol (a/n), n odd and positive.
int jacobi(int a, int n) {
  int symbol = 1;
  for (a %= n; a != 0; a %= n) {
    for (; a % 2 == 0; a /= 2) {
      if (n % 8 == 3 || n % 8 == 5) symbol = -symbol;
    }
    std::swap(a, n);
    if (a % 4 == 3 && n % 4 == 3) symbol = -symbol;
  }
  return n == 1 ? symbol : 0;
}

int conductor(int d) { return d % 4 == 1 ? d : 4 * d; }  // of Q(sqrt(d)), d square-free

}  // namespace

// Gauss: sqrt(D) is the sum of (D/k) cos(2 pi k/D) over k mod D, for the discriminant D of Q(sqrt(d)).
Algebraic Algebraic::root_of_integer(int d) {
  const int order = conductor(d);
  const Rational half = Rational(1) / Rational(order == d ? 2 : 4);  // e_k is 2 cos; sqrt(4d) is 2 sqrt(d)
  std::vector<std::pair<int, Rational>> terms;
  for (int k = 1; k < order; ++k) {
    const int symbol = order == d ? jacobi(k, d) : (k % 2 == 0 ? 0 : jacobi(d, k));
    if (symbol != 0) terms.emplace_back(k, symbol < 0 ? -half : half);
  }
  std::shared_ptr<const Field> field = Field::of(order);
  Polynomial coefficients = field->from_cosines(terms);
  return Algebraic(std::move(field), std::move(coefficients));
}

// The square root of a fraction >= 0 if Q(sqrt(d)) lies in a field within the degree limit.
std::optional<Algebraic> root_of_fraction(const Rational& value) {
  if (std::optional<Rational> root = exact_root(value, 2)) return Algebraic(*root);
  if (value.bits() > 10'000) return std::nullopt;
  Rational rest = value.numerator() * value.denominator();
  int d = 1;
  for (int p = 2; p <= Algebraic::Field::largest_order; ++p) {
    for (Rational quotient = rest / Rational(p); quotient.is_integer(); quotient = rest / Rational(p)) {
      rest = quotient;
      d = d % p == 0 ? d / p : d * p;
      if (d > Algebraic::Field::largest_order) return std::nullopt;
    }
  }
  const std::optional<Rational> square = exact_root(rest, 2);
  if (!square || !Algebraic::Field::within_limit(conductor(d))) return std::nullopt;
  // d collected the primes of odd exponent; what was divided out is d times a square.
  const std::optional<Rational> factor = exact_root(value / Rational(d), 2);
  if (!factor) return std::nullopt;
  return Algebraic(*factor) * Algebraic::root_of_integer(d);
}

Algebraic sqrt(const Algebraic& value) {
  if (value.sign() < 0) {
    throw Error(ErrorKind::input, "E_SQRT_NEGATIVE", "the square root of " + value.to_string().substr(0, 60) + " is not real");
  }
  if (value.is_rational()) {
    if (std::optional<Algebraic> root = root_of_fraction(value.rational())) return *root;
  } else if (std::optional<Algebraic::Quadratic> x = value.quadratic()) {
    // sqrt(a + b sqrt(d)) = sqrt((a+e)/2) +- sqrt((a-e)/2) where a^2 - b^2 d is a square e^2.
    const Rational norm = x->a * x->a - x->b * x->b * Rational(x->d);
    const std::optional<Rational> e = norm.sign() < 0 ? std::nullopt : exact_root(norm, 2);
    if (e && x->a.sign() > 0) {
      const std::optional<Algebraic> first = root_of_fraction((x->a + *e) / Rational(2));
      const std::optional<Algebraic> second = root_of_fraction((x->a - *e) / Rational(2));
      if (first && second) return x->b.sign() < 0 ? *first - *second : *first + *second;
    }
  }
  throw Error(ErrorKind::not_exact, "E_NOT_EXACT",
              "the square root of " + value.to_string().substr(0, 60) + " has no exact form here",
              "compute in enclosures or floating point");
}

Algebraic abs(const Algebraic& value) { return value.sign() < 0 ? -value : value; }

Algebraic pow(const Algebraic& base, int exponent) {
  if (base.is_rational()) return Algebraic(pow(base.rational(), exponent));
  if (exponent == 0) return Algebraic(1);
  auto count = static_cast<std::size_t>(std::labs(exponent));
  std::size_t bits = 2;
  for (const Rational& coefficient : base.coefficients()) bits += coefficient.bits() + 2;
  if (bits > kLargestPower / count) {
    throw Error(ErrorKind::limit, "E_POWER_SIZE",
                "the power " + std::to_string(exponent) + " of an algebraic number has too many digits",
                "use a smaller exponent");
  }
  Algebraic square = exponent < 0 ? Algebraic(1) / base : base;
  Algebraic result(1);
  while (true) {
    if (count % 2 == 1) result *= square;
    count /= 2;
    if (count == 0) return result;
    square *= square;
  }
}

// ---- text

namespace {

// Appends "+ p*NAME/q" style terms: the first without a blank before its sign, later ones as " + " and " - ".
void append_term(std::string& text, const Rational& weight, const std::string& name, bool fraction_behind) {
  if (weight.is_zero()) return;
  const bool negative = weight.sign() < 0;
  const Rational size = abs(weight);
  if (text.empty()) {
    text += negative ? "-" : "";
  } else {
    text += negative ? " - " : " + ";
  }
  if (name.empty()) {
    text += size.to_string();
    return;
  }
  const Rational front = fraction_behind ? size.numerator() : size;
  if (front != Rational(1)) text.append(front.to_string()).append("*");
  text += name;
  if (fraction_behind && !size.is_integer()) text.append("/").append(size.denominator().to_string());
}

}  // namespace

std::string Algebraic::to_string() const {
  if (!field_) return rational_.to_string();
  std::string text;
  if (const std::optional<Quadratic> x = quadratic()) {
    append_term(text, x->a, "", true);
    append_term(text, x->b, "sqrt(" + std::to_string(x->d) + ")", true);
    return text;
  }
  const std::string cosine = "cos(2*pi/" + std::to_string(field_->order) + ")";
  Rational power_of_two(1);
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    append_term(text, coefficients_[i] * power_of_two, i == 0 ? "" : (i == 1 ? cosine : cosine + "^" + std::to_string(i)), false);
    power_of_two *= Rational(2);
  }
  return text;
}

std::ostream& operator<<(std::ostream& out, const Algebraic& value) { return out << value.to_string(); }

}  // namespace udcp
