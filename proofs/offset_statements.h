// Sentences and tests that the proofs about offsets and their checkers share.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "operators/methods/offset/patch_bounds.h"
#include "proofs/loop_facts.h"

namespace udcp {

std::string contraction_claim(int valence, LocalSet set);  // where it is false: without a bound
std::string contraction_statement(int valence, LocalSet set, const Algebraic& bound);
std::string definite_statement(int valence, const Algebraic& bound);
/// These name the mesh by its size and a digest of the data that hold it.
std::string error_statement(const Json& data, const Rational& distance, bool full, const Rational& bound);
std::string embedded_statement(const Json& data);

inline constexpr int offset_precision = 64;  // bits of enclosures
inline constexpr int deepest_patch = 16;

/// Whether the error over a patch, nets of S and delta side by side in six columns, is at most a bound.
class OffsetErrorTest {
 public:
  OffsetErrorTest(const Mesh& mesh, const Rational& distance, bool full, const Rational& bound);
  [[nodiscard]] bool accepts(const Points<Interval>& net) const;
  /// The same in double, which is fast and decides nothing.
  [[nodiscard]] bool likely(const Points<Interval>& net) const;
  /// The four children: at the corner, then the regular ones.
  [[nodiscard]] std::array<Points<Interval>, 4> children(const Points<Interval>& net) const;

 private:
  template <class S>
  using Corners = std::map<int, CornerAnalysis<S>>;
  template <class S>
  [[nodiscard]] bool is_within(const Points<S>& net, const S& distance, const S& bound, const Corners<S>& corners) const;

  Rational distance_, bound_;
  bool full_;
  std::map<int, PatchStep<Interval>> steps_;
  Corners<Interval> corners_;
  Corners<double> near_corners_;
};

/// a times b, leaving zeros out.
Points<Interval> weighted_rows(const Points<Interval>& a, const Points<Interval>& b);

}  // namespace udcp
