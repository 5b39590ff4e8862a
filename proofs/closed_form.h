// Functions of alpha as text in prefix form, so that certificates can carry them: "(/ 1 (cos (/ alpha 2)))". Numbers are
// fractions; names are alpha, N and pi; operators + - * / ^ (two operands), neg sqrt cos sin tan exp log abs (one), min max
// (two).
#pragma once

#include <string>

#include "operators/word.h"
#include "proofs/certificate.h"

namespace udcp {

/// The kernel of such a text; its closed_form() is the text in normal form (one blank between parts, fractions in lowest terms).
/// Throws Error{input, "E_CLOSED_FORM"} for anything else, also past 10,000 characters or 100 levels.
KernelPtr kernel_from(const std::string& text);

/// The formula as a rational function of X = cos(alpha/2). Error{not_exact, "E_PARAMETER"} if alpha occurs elsewhere than in
/// cos(alpha/2), or where the functions are not rational.
Parametric value_in_half_cosine(const std::string& text);

/// word_from() of static_word.h for the certificates that may carry functions of alpha.
Word word_with_formulas_from(const Json& json);

}  // namespace udcp
