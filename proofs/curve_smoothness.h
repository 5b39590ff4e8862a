// What static words do on curves: convergence, C^k and Hoelder exponents, proved or refuted with certificates. The tail of the
// word is meant; words whose parameters depend on alpha are another file's business.
#pragma once

#include "proofs/budget.h"
#include "proofs/symbol.h"

namespace udcp {

/// Is the scheme C^k on curves, k = 0 for uniform convergence? Proved by a contracting difference scheme, norm(S_(k+1)^L) A^(kL)
/// < 1, or a polytope; refuted by a product of transition matrices, or by missing sum rules, where the theory allows (Dyn,
/// Subdivision schemes in CAGD; Daubechies and Lagarias). `undecided` for words that are not is_static() and for parameters
/// without exact value. Throws what static_limit() and mask() throw about the word, Error{input, "E_ARGUMENTS"} unless 0 <= k <=
/// 1000.
[[nodiscard]] Result prove_smooth(const Word& word, int k, const SearchLimits& limits = {});
[[nodiscard]] Result prove_converges(const Word& word, const SearchLimits& limits = {});

/// The Hoelder exponent s of the limit curves: C^k for every integer k < s, with k-th derivatives of every exponent below s - k.
struct Regularity {
  Result result;                      // proved with a certificate, or the reason why not
  std::string exact;                  // s as a formula, "3 - log2(3/2)"; empty if only bounds are known
  Interval at_least;                  // encloses the lower bound of s; only if proved
  std::optional<Interval> at_most{};  // encloses the upper bound; nothing where stability is not known
  int smoothness = -1;                // the largest k such that C^k follows
};
[[nodiscard]] Regularity holder(const Word& word, const SearchLimits& limits = {});

/// norm(S_(k+1)^length) A^(k length), below 1 for the least such length up to `longest`; nothing if there is none, for masks with
/// too few sum rules, and past some 20000 coefficients.
template <class S>
struct Contraction {
  int length = 0;
  S value;
};
template <class S>
std::optional<Contraction<S>> contraction(const Mask<S>& mask, int k, int longest, Budget& budget);

/// position_stencil() and tangent_stencil() where convergence (C^1) is proved.
struct LimitStencils {
  std::optional<Stencil<Algebraic>> position, tangent;
};
LimitStencils limit_stencils(const Word& word, const SearchLimits& limits = {});

}  // namespace udcp
