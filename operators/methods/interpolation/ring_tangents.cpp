// Trigonometric weights with the amplitudes of the limit masks.
#include "operators/methods/interpolation/ring_tangents.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace udcp {
namespace {

double cosine_of(int p, int q) { return cosine<double>(Rational(p) / Rational(q)); }  // cos(p pi/q)
double sine_of(int p, int q) { return cosine<double>(Rational(1) / Rational(2) - Rational(p) / Rational(q)); }

Eigen::RowVector3d unit(const Eigen::RowVector3d& a) { return a / a.stableNorm(); }

}  // namespace

const RingWeights* RingMasks::weights(const Fan& fan) {
  if (fan.inside) return &inside(fan.faces());
  return fan.faces() == 2 || fan.faces() == 3 ? &boundary(fan.faces()) : nullptr;
}

const RingWeights& RingMasks::inside(int valence) {
  const auto found = inside_.find(valence);
  if (found != inside_.end()) return found->second;
  const TangentMask& mask = masks_.tangents(valence);
  RingWeights result;
  for (int j = 0; j < valence; ++j) {
    result.first.push_back(mask.edge * cosine_of(2 * j, valence));
    result.second.push_back(mask.edge * sine_of(2 * j, valence));
  }
  for (int j = 0; j < valence; ++j) {
    result.first.push_back(mask.face * cosine_of(2 * j + 1, valence));
    result.second.push_back(mask.face * sine_of(2 * j + 1, valence));
  }
  result.movable.assign(result.first.size(), 1);
  for (const double a : result.first) result.squares += a * a;
  for (std::size_t k = 0; k < Mesh::i(valence); ++k) {
    const double a = result.first[k] + result.first[k + Mesh::i(valence)];
    result.tied_squares += a * a;
  }
  return inside_.emplace(valence, std::move(result)).first->second;
}

const RingWeights& RingMasks::boundary(int faces) {
  const auto found = boundary_.find(faces);
  if (found != boundary_.end()) return found->second;
  const AcrossMask& mask = masks_.across(faces);
  RingWeights result;
  for (int j = 0; j <= faces; ++j) {
    const bool is_end = j == 0 || j == faces;
    result.first.push_back(j == 0 ? 1 : j == faces ? -1 : 0);
    result.second.push_back(is_end ? mask.end : mask.inside.edge * sine_of(j, faces));
    result.movable.push_back(is_end ? 0 : 1);
  }
  for (int j = 0; j < faces; ++j) {
    result.first.push_back(0);
    result.second.push_back(mask.inside.face * sine_of(2 * j + 1, 2 * faces));
    result.movable.push_back(1);
  }
  for (std::size_t k = 0; k < result.second.size(); ++k)
    if (result.movable[k] != 0) result.squares += result.second[k] * result.second[k];
  return boundary_.emplace(faces, std::move(result)).first->second;
}

// Differences from v: so a far origin costs no digits.
RingTangents tangents_at(const Points<double>& points, int v, const Fan& fan, const RingWeights& weights) {
  RingTangents result{Eigen::RowVector3d::Zero(), Eigen::RowVector3d::Zero()};
  for (std::size_t k = 0; k < weights.first.size(); ++k) {
    const Eigen::RowVector3d difference = points.row(fan_point(fan, k)) - points.row(v);
    result.first += weights.first[k] * difference;
    result.second += weights.second[k] * difference;
  }
  return result;
}

Points<double> ring_corrections(const Fan& fan, const RingWeights& weights, const RingTangents& change, Spread spread) {
  const std::size_t size = weights.first.size(), n = fan.e.size();
  const bool tied = spread == Spread::tied && fan.inside;
  Points<double> result = Points<double>::Zero(static_cast<Eigen::Index>(size), 3);
  for (std::size_t k = 0; k < size; ++k) {
    if (weights.movable[k] == 0) continue;
    double a = weights.first[k], b = weights.second[k];
    if (tied) {
      a = weights.first[k % n] + weights.first[k % n + n];
      b = weights.second[k % n] + weights.second[k % n + n];
    }
    const auto row = static_cast<Eigen::Index>(k);
    result.row(row) = b * change.second;
    if (fan.inside) result.row(row) += a * change.first;
    result.row(row) /= tied ? weights.tied_squares : weights.squares;
  }
  return result;
}

RingTangents change_to_plane(const RingTangents& tangents, const Eigen::RowVector3d& normal) {
  const Eigen::RowVector3d n = unit(normal);
  return {-tangents.first.dot(n) * n, -tangents.second.dot(n) * n};
}

// By two frames that share the axis of rotation, each orthonormal by itself: so the one normal goes to the other without error
// also where the axis is known to a few digits only.
RingTangents change_by_turn(const RingTangents& tangents, const Eigen::RowVector3d& normal) {
  const Eigen::Vector3d from = unit(normal_of(tangents)).transpose(), to = unit(normal).transpose();
  Eigen::Vector3d axis = from.cross(to);
  const bool is_clear = axis.norm() > 1e-8;
  axis = is_clear ? axis.normalized().eval() : unit(tangents.first).transpose().eval();
  const auto frame = [&axis](const Eigen::Vector3d& n) {
    Eigen::Matrix3d result;
    result.col(0) = n;
    result.col(1) = (axis - axis.dot(n) * n).normalized();
    result.col(2) = n.cross(Eigen::Vector3d(result.col(1)));
    return result;
  };
  const Eigen::Matrix3d turn = frame(to) * frame(from).transpose();
  return {(turn * tangents.first.transpose()).transpose() - tangents.first,
          (turn * tangents.second.transpose()).transpose() - tangents.second};
}

double angle_between(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) {
  const Eigen::RowVector3d u = unit(a), v = unit(b);
  return 2 * std::atan2((u - v).norm(), (u + v).norm());
}

Eigen::RowVector3d normal_of(const RingTangents& tangents) { return tangents.first.cross(tangents.second); }

bool is_degenerate(const RingTangents& tangents) {
  if (tangents.first.isZero(0) || tangents.second.isZero(0)) return true;
  return !(unit(tangents.first).cross(unit(tangents.second)).norm() > 1e-12);
}

}  // namespace udcp
