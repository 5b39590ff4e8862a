// Second-order automatic differentiation on enclosures. Constants skip the derivatives: most numbers of a word are constants.
#include "operators/numbers/jet.h"

#include <ostream>

#include "operators/error.h"

namespace udcp {
namespace {

[[noreturn]] void undecided(const std::string& what, const Jet& x) {
  throw Error(ErrorKind::not_exact, "E_UNDECIDED", what + " may have a kink where its argument is in " + x.value().to_string(6),
              "use a smaller range, or write the formula without it");
}

/// g(u) from g, g' and g'' at the value of u.
Jet chain(const Jet& u, Interval g, const Interval& first, const Interval& second) {
  return Jet::of(std::move(g), first * u.first(), second * pow(u.first(), 2) + first * u.second());
}

bool is_exact_zero(const Jet& x) { return x.is_constant() && x.value() == Interval(0); }

}  // namespace

Jet::Jet() = default;
Jet::Jet(const Jet&) = default;
Jet::Jet(Jet&&) noexcept = default;
Jet& Jet::operator=(const Jet&) = default;
Jet& Jet::operator=(Jet&&) noexcept = default;
Jet::~Jet() = default;
Jet::Jet(int value) : value_(value) {}
Jet::Jet(const Rational& value) : value_(value) {}
Jet::Jet(Interval value) : value_(std::move(value)) {}
Jet::Jet(Interval value, Interval first, Interval second, bool constant)
    : value_(std::move(value)), first_(std::move(first)), second_(std::move(second)), constant_(constant) {}

Jet Jet::variable(Interval range) { return {std::move(range), Interval(1), Interval(0), false}; }

Jet Jet::of(Interval value, Interval first, Interval second) {
  return {std::move(value), std::move(first), std::move(second), false};
}

std::string Jet::to_string() const {
  if (constant_) return value_.to_string();
  return value_.to_string() + " with derivatives " + first_.to_string() + " and " + second_.to_string();
}

// ---- arithmetic

Jet& Jet::operator+=(const Jet& other) {
  value_ += other.value_;
  if (other.constant_) return *this;
  first_ += other.first_;
  second_ += other.second_;
  constant_ = false;
  return *this;
}

Jet& Jet::operator-=(const Jet& other) {
  value_ -= other.value_;
  if (other.constant_) return *this;
  first_ -= other.first_;
  second_ -= other.second_;
  constant_ = false;
  return *this;
}

Jet& Jet::operator*=(const Jet& other) {
  if (is_exact_zero(*this)) return *this;
  if (is_exact_zero(other)) return *this = Jet();
  if (other.constant_) {
    if (!constant_) {
      first_ *= other.value_;
      second_ *= other.value_;
    }
    value_ *= other.value_;
    return *this;
  }
  if (constant_) return *this = Jet(value_ * other.value_, value_ * other.first_, value_ * other.second_, false);
  return *this = Jet(value_ * other.value_, first_ * other.value_ + value_ * other.first_,
                     second_ * other.value_ + Interval(2) * (first_ * other.first_) + value_ * other.second_, false);
}

Jet& Jet::operator/=(const Jet& other) {
  Interval quotient = value_ / other.value_;
  if (is_exact_zero(*this)) return *this;
  if (other.constant_) {
    if (!constant_) {
      first_ /= other.value_;
      second_ /= other.value_;
    }
    value_ = std::move(quotient);
    return *this;
  }
  // q v = u, differentiated once and twice
  Interval first = (first_ - quotient * other.first_) / other.value_;
  Interval second = (second_ - Interval(2) * (first * other.first_) - quotient * other.second_) / other.value_;
  return *this = Jet(std::move(quotient), std::move(first), std::move(second), false);
}

Jet Jet::operator-() const { return {-value_, -first_, -second_, constant_}; }

bool Jet::certainly_equal(const Jet& other) const { return constant_ && other.constant_ && value_ == other.value_; }

bool Jet::certainly_less_equal(const Jet& other) const {
  return value_ < other.value_ || (constant_ && other.constant_ && value_ <= other.value_);
}

// ---- functions

Jet cos(const Jet& x) {
  Interval c = cos(x.value());
  if (x.is_constant()) return Jet(std::move(c));
  const Interval second = -c;
  return chain(x, std::move(c), -sin(x.value()), second);
}

Jet sin(const Jet& x) {
  Interval s = sin(x.value());
  if (x.is_constant()) return Jet(std::move(s));
  const Interval second = -s;
  return chain(x, std::move(s), cos(x.value()), second);
}

Jet tan(const Jet& x) {
  Interval t = tan(x.value());
  if (x.is_constant()) return Jet(std::move(t));
  const Interval first = Interval(1) + pow(t, 2);
  const Interval second = Interval(2) * t * first;
  return chain(x, std::move(t), first, second);
}

Jet exp(const Jet& x) {
  const Interval e = exp(x.value());
  return x.is_constant() ? Jet(e) : chain(x, e, e, e);
}

Jet log(const Jet& x) {
  Interval l = log(x.value());
  if (x.is_constant()) return Jet(std::move(l));
  return chain(x, std::move(l), Interval(1) / x.value(), Interval(-1) / pow(x.value(), 2));
}

Jet sqrt(const Jet& x) {
  Interval root = sqrt(x.value());
  if (x.is_constant()) return Jet(std::move(root));
  const Interval first = Interval(1) / (Interval(2) * root);
  return chain(x, std::move(root), first, -first / (Interval(2) * x.value()));
}

Jet pow(const Jet& x, int exponent) {
  if (exponent == 0) return 1;
  if (exponent == 1) return x;
  Interval power = pow(x.value(), exponent);
  if (x.is_constant()) return Jet(std::move(power));
  if (exponent == 2) return chain(x, std::move(power), Interval(2) * x.value(), Interval(2));
  if (exponent < -1'000'000'000)
    throw Error(ErrorKind::limit, "E_POWER_SIZE", "the exponent " + std::to_string(exponent) + " is too large",
                "use an exponent of at most 9 digits");
  const Interval n(exponent);
  return chain(x, std::move(power), n * pow(x.value(), exponent - 1), n * (n - Interval(1)) * pow(x.value(), exponent - 2));
}

Jet abs(const Jet& x) {
  if (x.is_constant()) return Jet(abs(x.value()));
  if (x > Jet(0)) return x;
  if (x < Jet(0)) return -x;
  undecided("abs", x);
}

Jet min(const Jet& a, const Jet& b) {
  if (a <= b) return a;
  if (b <= a) return b;
  if (a.is_constant() && b.is_constant()) return Jet(min(a.value(), b.value()));
  undecided("min or max", a - b);
}

Jet max(const Jet& a, const Jet& b) { return -min(-a, -b); }

std::ostream& operator<<(std::ostream& out, const Jet& value) { return out << value.to_string(); }

}  // namespace udcp
