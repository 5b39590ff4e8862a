// The symbol on the unit circle, as polynomials in c = cos(alpha/2).
#include "proofs/circle.h"

#include <algorithm>

#include "operators/matrix.h"
#include "proofs/checkers.h"
#include "proofs/closed_form.h"

namespace udcp {
namespace {

/// The kernel with c in place of cos(alpha/2).
KernelPtr in_cosine(const KernelPtr& kernel) {
  if (!kernel) return kernel;
  if (!kernel->needs().round) {
    const std::vector<std::string> names = kernel->at(Context<Parametric>{}).value().variables();
    require(std::find(names.begin(), names.end(), "X") == names.end(),
            "a parameter may not be called X here, which is cos(alpha/2)");
    return kernel;
  }
  const std::string text = kernel->closed_form();
  require(!text.empty(), "a parameter is a function of alpha that cannot be written down");
  try {
    const Parametric value = value_in_half_cosine(text);
    return formula(
        [value](const auto& context) {
          using S = std::decay_t<decltype(context.alpha.value())>;
          if constexpr (std::is_same_v<S, Parametric>) {
            return Quantity<S>::of(value);
          } else {
            throw Error(ErrorKind::not_exact, "E_PARAMETER", "the value depends on X = cos(alpha/2)");
            return Quantity<S>();
          }
        },
        Needs{false, false, false});
  } catch (const Error& error) {
    throw Rejected(std::string("a parameter is no function of cos(alpha/2): ") + error.what());
  }
}

Word in_cosine(const Word& word) {
  Word result;
  result.tail = word.tail;
  require(!word.triangles && word.rings == Rings::off, "circles are a matter of curves: no triangles and no rings");
  int splits = 0;
  for (Item& item : result.tail) {
    if (item.atom == Atom::up) {
      ++splits;
      require(item.sections == 2, "a round with U[" + std::to_string(item.sections) + "] is not covered, only U");
    }
    item.f = Directional<KernelPtr>::all(in_cosine(item.f.plain));
    item.omega = Directional<KernelPtr>::all(in_cosine(item.omega.plain));
    item.delta = in_cosine(item.delta);
  }
  require(splits == 1, "a round must have exactly one U");
  return result;
}

/// T_0 .. T_n at c: cos(k alpha/2).
std::vector<Parametric> chebyshev(int n) {
  const Parametric c = Parametric::variable("X");
  std::vector<Parametric> t{Parametric(1), c};
  while (static_cast<int>(t.size()) <= n) t.push_back(Parametric(2) * c * t[t.size() - 1] - t[t.size() - 2]);
  return t;
}

/// Even and odd entries give the radii of the two kinds of new points; by symmetry both are real.
CircleRound primal_round(const Mask<Parametric>& mask) {
  const int last = mask.first + static_cast<int>(mask.coefficients.size()) - 1;
  const std::vector<Parametric> t = chebyshev(std::max(std::abs(mask.first), std::abs(last)));
  Parametric even(0), odd(0);
  for (int k = mask.first; k <= last; ++k) {
    const Parametric& a = mask.coefficients[static_cast<std::size_t>(k - mask.first)];
    (k % 2 == 0 ? even : odd) += a * t[static_cast<std::size_t>(std::abs(k))];
  }
  require(even == odd, "old and new points get different radii: the factors are " + even.to_string() + " and " + odd.to_string() +
                           ", X = cos(alpha/2)");
  return {even, false};
}

/// The even entries give a point, the odd ones its mirror image: it must lie in the right direction. With phi = alpha/2,
/// sin((k + 1/2) phi)/sin(phi/2) = 1 + 2 sum cos(j phi) and cos((k + 1/2) phi) = cos(phi/2) (1 + 2 sum (-1)^j cos(j phi)) (-1)^k.
CircleRound dual_round(const Mask<Parametric>& mask) {
  const int last = mask.first + static_cast<int>(mask.coefficients.size()) - 1;
  const int largest = std::max(std::abs(mask.first), std::abs(last)) + 1;
  const std::vector<Parametric> t = chebyshev(largest);
  std::vector<Parametric> sine{Parametric(1)}, cosine{Parametric(1)};  // cosine[k] without the factor cos(phi/2)
  for (int k = 1; k <= largest; ++k) {
    sine.push_back(sine.back() + Parametric(2) * t[static_cast<std::size_t>(k)]);
    cosine.push_back(Parametric(2) * t[static_cast<std::size_t>(k)] - cosine.back());
  }
  Parametric aside(0), radius(0);
  for (int k = mask.first; k <= last; ++k) {
    if (k % 2 != 0) continue;
    const Parametric& a = mask.coefficients[static_cast<std::size_t>(k - mask.first)];
    const auto n = static_cast<std::size_t>(k >= 0 ? k : -1 - k);
    aside += k >= 0 ? a * sine[n] : -(a * sine[n]);
    radius += a * cosine[n];
  }
  require(aside.is_zero(),
          "the new points are not evenly spaced: they turn by a multiple of " + aside.to_string() + ", X = cos(alpha/2)");
  return {radius, true};
}

}  // namespace

CircleRound circle_round(const Word& word) {
  const Mask<Parametric> m = mask<Parametric>(in_cosine(word));
  const int last = m.first + static_cast<int>(m.coefficients.size()) - 1;
  const bool dual = m.shift == Rational(1) / Rational(2);
  require(dual || m.shift.is_zero(), "the mask is neither primal nor dual");
  require(m.first + last == (dual ? -1 : 0) && std::equal(m.coefficients.begin(), m.coefficients.end(), m.coefficients.rbegin()),
          "the mask is not symmetric");
  CircleRound round = dual ? dual_round(m) : primal_round(m);
  require(round.factor.substitute("X", Parametric(1)) == Parametric(1),
          "the radius does not settle: its factor at alpha = 0 is not 1");
  return round;
}

std::string check_circle(const Json& data, StopFlag) {
  require_entries(data, {"word"}, "data");
  const Word word = word_with_formulas_from(entry(data, "word"));
  require(to_json(word, {4}) == data["word"], "the word is not in the form that this program writes");
  const CircleRound round = circle_round(word);
  return describe(data["word"]) +
         " takes regular polygons on a circle to regular polygons on a circle with twice as many corners, if alpha is the angle "
         "between neighbours, wherever its parameters have values; each round multiplies the radius by " +
         (round.dual ? "cos(alpha/4) times " : "") + round.factor.to_string() + " with X = cos(alpha/2)";
}

Result prove_circle(const Word& word) {
  const std::string claim = "regular polygons become circles if alpha0 is the angle between neighbours";
  Word tail;
  tail.tail = word.tail;
  try {
    const Json data = {{"word", to_json(tail, {4})}};
    Result result =
        concluded(Verdict::proved, "an identity in X = cos(alpha/2), exact", seal("circle", check_circle(data), data));
    const CircleRound round = circle_round(word);
    result.details = {{"radius_factor", round.factor.to_string()}, {"times_cos_quarter_alpha", round.dual}};
    return result;
  } catch (const Rejected& rejected) {
    Result result = undecided(claim, rejected.what());
    const std::string why = rejected.what();
    if (why.starts_with("old and new") || why.starts_with("the new points are")) {
      result.verdict = Verdict::refuted;
      result.reason = "the identity in X = cos(alpha/2) fails";
      result.witness = why;
    }
    return result;
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact) throw;
    return undecided(claim, error.what());
  }
}

Interval circle_radius(const Word& word, int corners) {
  constexpr int rounds = 60;
  const auto refuse = [](const std::string& why) {
    return Error(ErrorKind::word, "E_NO_CIRCLE", why,
                 "Theorem 1 needs f(alpha) = cos(alpha/2) and omega(alpha) = 1/cos(alpha/2)");
  };
  try {
    const Interval::Precision precision(192);
    const CircleRound round = circle_round(word);
    Interval product(1);
    Rational angle = Rational(2) / Rational(corners);  // alpha_h over pi
    for (int h = 0; h < rounds; ++h, angle /= Rational(2)) {
      product *= round.factor.at({{"X", udcp::cosine<Interval>(angle / Rational(2))}});
      if (round.dual) product *= udcp::cosine<Interval>(angle / Rational(4));
    }
    // The rest: |factor - 1| <= |R(c) - 1| + |cos(alpha/4) - 1| |R| with 1 - c <= alpha^2/8, 1 - cos(alpha/4) <= alpha^2/32.
    const Interval alpha = Interval(angle) * Interval::pi();
    const Interval near = Interval::hull(udcp::cosine<Interval>(angle / Rational(2)), Interval(1));
    const Interval slope = abs(round.factor.derivative("X").at({{"X", near}})), size = abs(round.factor.at({{"X", near}}));
    Interval sum = slope * alpha * alpha / Interval(8);
    if (round.dual) sum += size * alpha * alpha / Interval(32);
    sum = sum * Interval(Rational(4) / Rational(3));
    const Rational most = sum.upper();
    return product * Interval(Rational(1) - most, exp(Interval(most)).upper());
  } catch (const Rejected& rejected) {
    throw refuse(rejected.what());
  } catch (const Error& error) {
    if (error.code != "E_NAME") throw;
    throw refuse("the radius depends on parameters that have no value");
  }
}

}  // namespace udcp
