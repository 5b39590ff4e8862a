// Exact facts about the G2 fill in the field of cos(2 pi/n): ranks, solutions and residuals as polynomials, from the functions
// that make the running masks. Nothing here is found by trying. "Smooth connection near singular points on subdivision surfaces"
// (AAM 2017); the formulas that are wrong in print can be put back one at a time.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "operators/methods/filling/fill_system.h"
#include "proofs/certificate.h"
#include "proofs/polynomial.h"

namespace udcp {

/// A formula as printed, instead of the one that the fill uses.
enum class Print {
  none,
  psi_x_u,  // the derivatives of psi on u = 1
  psi_y_u,
  psi_x_uu,
  psi_y_uu,
  net,          // entry (0,3) of the net of the hole face: point (1,2) of the next sector
  phi,          // the inner map: x without u, y with sec(2 pi/n)
  points,       // (2) on Bezier points: p_00 of patch i is p_07 of patch i + 1, and so on
  power_basis,  // (3) in the power basis
  psi_symmetry  // psi(u, v) = psi(v, u)
};
/// "psi_x_u" and the like, empty for none; nothing for other names.
std::string to_string(Print print);
std::optional<Print> print_named(const std::string& name);
/// The names of all prints.
std::vector<std::string> print_names();

/// psi on u = 1 - h as polynomials in t, up to h^2: x[k] and y[k] belong to h^k.
struct OuterSeries {
  std::array<Polynomial<Algebraic>, 3> x, y;
};
/// From the matrix of psi alone; with a print, from its derivatives.
OuterSeries outer_series(int valence, Print print = Print::none);
/// Why the Bezier points of the ring do not reproduce the value and two derivatives of the bicubic ring over psi on u = 1 and
/// v = 1, as polynomials in t; empty if they do. `weights` as outer_weights has them.
std::string outer_residual(const OuterSeries& series, const Points<Algebraic>& weights);
/// The weights that the traces of the series make.
Points<Algebraic> weights_of(const OuterSeries& series);
/// psi keeps u = 1, is the identity there and increases x across it, for 0 <= t <= 1.
bool is_regular_outside(const OuterSeries& series);

/// (2) to (4) say that P_{i+1} is P_i after a change of parameters, with derivatives (0, 1) along the edge and (-1, 2c(1-t))
/// across, up to second order: G2 wherever the patches are regular, with the same normal. An identity in t, and g > 0 on [0, 1].
bool conditions_mean_g2(int valence);

/// The equations of one frequency.
struct FrequencyFacts {
  int rank = 0;
  bool consistent = false;        // for every ring of points
  bool residuals_vanish = false;  // (2) to (4) of a solution and of all homogeneous ones, as polynomials in t
  bool fairness_decides = false;  // one solution is fairest
};
FrequencyFacts frequency_facts(int valence, int frequency, const Points<Algebraic>& weights, Print print = Print::none);

/// The mask of patch 0 in exact numbers: rows are its Bezier points, columns the points of two rings. Where every frequency is
/// consistent and decided; digits grow quickly with the degree of the field. Throws
/// Error{interrupted} once `stop` is set.
Points<Algebraic> exact_fill_mask(int valence, const std::atomic<bool>* stop = nullptr);

/// Why the printed formula cannot hold at this valence, by an exact computation; empty if it can. For the prints that are no
/// variant of the system: phi, points, power_basis and psi_symmetry.
std::string contradiction(int valence, Print print);
/// The same for every print: from contradiction, or because the outer conditions or the equations of a frequency fail.
std::string print_failure(int valence, Print print);

/// Degrees and fractions grow with the valence: this one takes seconds, 11 half a minute.
inline constexpr int largest_exact_fill = 10;

/// Throws Rejected unless the faces with regular corners around the hole are bicubic B-splines in the limit of the word.
void require_bicubic_ring(const Json& word, int valence);

std::string g2_statement(const Json& word, int valence, const Rational& mask_error);
std::string print_statement(int valence, Print print, const std::string& failure);

}  // namespace udcp
