// The hull certificate of a characteristic map: boxes for the limit derivatives over a cell from the differences it depends on.
// Double arithmetic with one radius for all errors per cell; every bound is rounded to the safe side. Searches for nothing.
#pragma once

#include <array>
#include <complex>
#include <optional>

#include "proofs/characteristic_map.h"

namespace udcp {

/// A scheme on cells in double: its weights within `error` of the exact ones, the points that a cell depends on, and a constant
/// with: for data between -1 and 1 on these points the limit over the cell lies between -hull and hull.
class CellScheme {
 public:
  /// Nothing if no bound is found in few rounds. `hull` is a constant that is known already.
  template <class S>
  static std::optional<CellScheme> of(const LatticeMask<S>& mask, const std::vector<Place>& points,
                                      std::optional<double> hull = std::nullopt);
  [[nodiscard]] double hull() const { return hull_; }
  [[nodiscard]] const std::vector<Place>& points() const { return points_; }

  /// Values at the points with a bound of the error of each real and imaginary part.
  struct Data {
    std::vector<std::complex<double>> values;
    double error = 0;
  };
  /// The data of child (ex, ey), number ex + 2 ey.
  [[nodiscard]] Data child(const Data& data, int number) const;
  /// Encloses the limits over the cell, each value times the number `factor` of modulus at most 1: real part in
  /// re[0] .. re[1], imaginary part in im[0] .. im[1].
  struct Box {
    std::array<double, 2> re{}, im{};
  };
  [[nodiscard]] Box limits(const Data& data, std::complex<double> factor) const;

 private:
  struct Weight {
    std::size_t from;
    double value;
  };
  std::vector<Place> points_;
  std::array<std::vector<std::vector<Weight>>, 4> children_;
  double hull_ = 1, error_ = 0, sum_ = 1;
  std::size_t terms_ = 0;
};

/// The three schemes of a word, for positions and for derivatives, on the ring of one characteristic map.
class RingTest {
 public:
  template <class S>
  static std::optional<RingTest> of(const RegularPart<S>& part, const CellSets& sets);
  struct Cell {
    CellScheme::Data position, du, dv;
  };
  [[nodiscard]] Cell cell(const CharacteristicNet& net, Place corner) const;
  [[nodiscard]] Cell child(const Cell& cell, int number) const;
  /// The Jacobian is positive over the cell and its image lies in the open half plane around the bisector of sector 0 of n.
  [[nodiscard]] bool accepts(const Cell& cell, int valence) const;
  /// The cross product of the mean differences: a picture of the Jacobian, not a bound.
  [[nodiscard]] static double typical_jacobian(const Cell& cell);
  [[nodiscard]] std::array<double, 3> hulls() const { return {position_.hull(), du_.hull(), dv_.hull()}; }
  [[nodiscard]] const CellScheme& position() const { return position_; }

 private:
  RingTest(CellScheme position, CellScheme du, CellScheme dv)
      : position_(std::move(position)), du_(std::move(du)), dv_(std::move(dv)) {}
  CellScheme position_, du_, dv_;
};

}  // namespace udcp
