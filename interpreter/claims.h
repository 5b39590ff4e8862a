// Claims of the language: what they run over, and which proof decides them. The proofs themselves are in proofs/.
#pragma once

#include <map>
#include <set>

#include "interpreter/arguments.h"
#include "proofs/bernstein.h"
#include "proofs/verdict.h"

namespace udcp {

/// What stands behind `for`: continuous parameters, and the valences if the claim speaks of surfaces. Integer ranges of other
/// names are not in here: a claim is decided once for each of their values.
struct ClaimDomain {
  ParameterBox box;
  std::vector<int> valences;
  bool evidence_only = false;               // check: numbers in floating point, never a proof
  std::map<std::string, Rational> fixed{};  // f, omega and delta from lists: the values of this pass
  mutable std::set<std::string> filled{};   // of the names above and in the box: those that a word left open
};

/// prove / check: decides the claim over its domains; the value is a claim report. Throws Located: E_DOMAIN for sets that are no
/// domain, E_NOT_A_CLAIM for expressions that claim nothing.
Value decide_claim(const grammar::Claim& claim, CallContext& context);
/// verify "file": a claim report; `refuted` if the certificate was rejected.
Value verify_file(const std::string& path, CallContext& context);

/// A result as a value. `domain`: its text, may be empty.
Value claim_value(Result result, const std::string& domain = {});
SearchLimits search_limits(const CallContext& context);
/// Parameters of the domain named f, omega and delta stand for those of the word that it leaves open.
Word with_parameters(Word word, const ClaimDomain& domain);
/// "name in set" as a range; a range a .. b is closed. Throws Located E_DOMAIN.
ParameterRange range_of(const std::string& name, const grammar::Expr& set, CallContext& context);

/// Why a claim about meshes is not decided for this word; empty if nothing speaks against it.
std::string not_on_meshes(const Word& word);

/// converges, c1, c, equal, ...: a claim about words, from the arguments of its call, over context.domain or the argument N.
Value claim_converges(CallContext&, const Arguments&);
Value claim_c1(CallContext&, const Arguments&);
Value claim_c(CallContext&, const Arguments&);
Value claim_equal(CallContext&, const Arguments&);
Value claim_circle(CallContext&, const Arguments&);
/// regular: a claim about the surface of one mesh.
Value claim_regular(CallContext&, const Arguments&);

}  // namespace udcp
