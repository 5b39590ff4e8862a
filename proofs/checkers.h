// The table of checkers, one per kind of certificate. A checker repeats exact or outward-rounded checks and searches for nothing;
// the files check_*.cpp that define them include no header of a search.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "proofs/certificate.h"

namespace udcp {

struct Checker {
  std::string_view kind;
  std::string (*check)(const Json& data);  // the statement that the data prove; throws Rejected
};
std::span<const Checker> checkers();

std::string check_all_of(const Json& data);  // "all-of": several statements at once
// check_curve.cpp
std::string check_curve_smoothness(const Json& data);  // "curve-smoothness": the scheme is C^k
std::string check_curve_refutation(const Json& data);  // "curve-refutation": the scheme is not C^k
std::string check_curve_regularity(const Json& data);  // "curve-regularity": bounds of the Hoelder exponent
// check_surface.cpp
std::string check_surface_c1(const Json& data);        // "surface-c1": C^1 at vertices (faces) of one valence
std::string check_surface_spectrum(const Json& data);  // "surface-spectrum": condition 2 fails at a valence

// check_box.cpp
std::string check_curve_box(const Json& data);  // "curve-box": C^k for all parameters of a box
// check_asymptotic.cpp
std::string check_asymptotic(const Json& data);  // "asymptotic": Theorem 3 of the push-back paper
// check_equality.cpp
std::string check_equality(const Json& data);  // "equality": two words are the same operator
std::string check_circle(const Json& data);    // "circle": Theorem 1 of the push-back paper
// check_regularity.cpp
std::string check_regular_surface(const Json& data);    // "regular-surface": a Catmull-Clark surface is regular
std::string check_irregular_surface(const Json& data);  // "irregular-surface": it has a singular point

}  // namespace udcp
