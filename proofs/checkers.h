// The table of checkers, one per kind of certificate. A checker repeats exact or outward-rounded checks and searches for nothing;
// the files check_*.cpp that define them include no header of a search.
#pragma once

#include <atomic>
#include <span>
#include <string>
#include <string_view>

#include "proofs/certificate.h"

namespace udcp {

/// Set from outside: the long checkers throw Error{interrupted}. May be null.
using StopFlag = const std::atomic<bool>*;

struct Checker {
  std::string_view kind;
  std::string (*check)(const Json& data, StopFlag stop);  // the statement that the data prove; throws Rejected
};
std::span<const Checker> checkers();

std::string check_all_of(const Json& data, StopFlag stop = nullptr);  // "all-of": several statements at once
// check_curve.cpp
std::string check_curve_smoothness(const Json& data, StopFlag stop = nullptr);  // "curve-smoothness": the scheme is C^k
std::string check_curve_refutation(const Json& data, StopFlag stop = nullptr);  // "curve-refutation": the scheme is not C^k
std::string check_curve_regularity(const Json& data,
                                   StopFlag stop = nullptr);  // "curve-regularity": bounds of the Hoelder exponent
// check_surface.cpp
std::string check_surface_c1(const Json& data, StopFlag stop = nullptr);  // "surface-c1": C^1 at vertices (faces) of one valence
std::string check_surface_spectrum(const Json& data,
                                   StopFlag stop = nullptr);  // "surface-spectrum": condition 2 fails at a valence

// check_box.cpp
std::string check_curve_box(const Json& data, StopFlag stop = nullptr);  // "curve-box": C^k for all parameters of a box
// check_asymptotic.cpp
std::string check_asymptotic(const Json& data, StopFlag stop = nullptr);  // "asymptotic": Theorem 3 of the push-back paper
// check_equality.cpp
std::string check_equality(const Json& data, StopFlag stop = nullptr);  // "equality": two words are the same operator
std::string check_circle(const Json& data, StopFlag stop = nullptr);    // "circle": Theorem 1 of the push-back paper
// check_regularity.cpp
std::string check_regular_surface(const Json& data,
                                  StopFlag stop = nullptr);  // "regular-surface": a Catmull-Clark surface is regular
std::string check_irregular_surface(const Json& data, StopFlag stop = nullptr);  // "irregular-surface": it has a singular point

// check_interpolation.cpp
std::string check_interpolation(const Json& data,
                                StopFlag stop = nullptr);  // "interpolation": points and normals of a mesh are met exactly
std::string check_interpolation_reversed(const Json& data,
                                         StopFlag stop = nullptr);  // "interpolation-reversed": a normal is met on the wrong side
std::string check_interpolation_threshold(const Json& data,
                                          StopFlag stop = nullptr);  // "interpolation-threshold": lambda above 7/20 is enough
std::string check_interpolation_checkerboard(const Json& data,
                                             StopFlag stop = nullptr);  // "interpolation-checkerboard": up to 7/20 it is not

// check_g2.cpp
std::string check_g2_fill(const Json& data, StopFlag stop);   // "g2-fill": the G2 fill of a valence exists and joins
std::string check_g2_print(const Json& data, StopFlag stop);  // "g2-print": with a formula as printed there is none

// check_offset.cpp
std::string check_offset_contraction(const Json& data, StopFlag stop);  // "offset-contraction": the edge iteration converges
std::string check_offset_definite(const Json& data, StopFlag stop);     // "offset-definite": the system is positive definite
std::string check_offset_error(const Json& data, StopFlag stop);        // "offset-error": an offset is within a bound
std::string check_embedded_surface(const Json& data, StopFlag stop);    // "embedded-surface": a Loop surface is embedded

}  // namespace udcp
