// Half-space routines: double arithmetic proposes, exact signs decide, and an exact incremental search answers what is left.
#include "proofs/regularity/half_space.h"

#include <algorithm>
#include <cmath>

namespace udcp {
namespace {

using Vector2 = std::array<Rational, 2>;

Rational det(const Vector2& a, const Vector2& b) { return a[0] * b[1] - a[1] * b[0]; }
Rational dot(const Vector2& a, const Vector2& b) { return a[0] * b[0] + a[1] * b[1]; }

/// x with w.x > 0 for all w, non-zero vectors of the plane. The scan finds the extreme directions if there is such an x; the loop
/// after it makes sure.
std::optional<Vector2> half_plane(const std::vector<Vector2>& vectors) {
  Vector2 low = vectors.front(), high = vectors.front();
  for (const Vector2& w : vectors) {
    if (det(low, w).sign() < 0) low = w;
    if (det(w, high).sign() < 0) high = w;
  }
  for (const Vector2& w : vectors) {
    const int right = det(low, w).sign(), left = det(w, high).sign();
    if (right < 0 || left < 0) return std::nullopt;
    if (right == 0 && dot(low, w).sign() < 0) return std::nullopt;
    if (left == 0 && dot(high, w).sign() < 0) return std::nullopt;
  }
  if (det(low, high).is_zero()) return low;
  return Vector2{high[1] - low[1], low[0] - high[0]};
}

/// A normal in the plane a.x = 0 that is positive on the projections of all `earlier`, by their coordinates there; the vector a
/// itself if they are all multiples of it. Nothing if there is none.
struct OnPlane {
  bool feasible = false;
  std::optional<Vector3> normal;  // nothing: no condition
};
OnPlane normal_on_plane(const Vector3& a, std::span<const Vector3> earlier) {
  Vector3 p = cross(a, {1, 0, 0});
  if (is_zero(p)) p = cross(a, {0, 1, 0});
  p = primitive(p);
  const Vector3 q = primitive(cross(a, p));
  std::vector<Vector2> projected;
  for (const Vector3& w : earlier) {
    Vector2 x = {dot(w, p), dot(w, q)};
    if (!x[0].is_zero() || !x[1].is_zero())
      projected.push_back(std::move(x));
    else if (dot(w, a).sign() < 0)
      return {};
  }
  if (projected.empty()) return {true, std::nullopt};
  const std::optional<Vector2> x = half_plane(projected);
  if (!x) return {};
  return {true, (*x)[0] * p + (*x)[1] * q};
}

/// If a normal exists, the segment from the old one to it meets the plane a_k.x = 0 in a point that is positive on all earlier
/// vectors; a little of a_k added to it is positive on a_k too.
std::optional<Vector3> exact_half_space(std::span<const Vector3> vectors) {
  Vector3 n = vectors.front();
  for (std::size_t k = 1; k < vectors.size(); ++k) {
    const Vector3& a = vectors[k];
    if (dot(n, a).sign() > 0) continue;
    const auto earlier = vectors.first(k);
    const OnPlane on_plane = normal_on_plane(a, earlier);
    if (!on_plane.feasible) return std::nullopt;
    if (!on_plane.normal) {
      n = a;
      continue;
    }
    // n = x + eps a with a_i.n > 0: eps below every a_i.x / -(a_i.a); n = scale x + a for scale = 1 / eps.
    const Vector3& x = *on_plane.normal;
    Rational scale(1);
    for (const Vector3& w : earlier) {
      const Rational along = dot(w, a), across = dot(w, x);
      if (along.sign() < 0) scale = std::max(scale, (-along / across).floor() + Rational(1));
    }
    n = primitive(scale * x + a);
  }
  return n;
}

/// Each ray once, in another order, the same every time: vectors that follow each other in a mesh are nearly parallel, and
/// scattered ones show sooner that there is no half space.
std::vector<Vector3> scattered(std::vector<Vector3> rays) {
  std::sort(rays.begin(), rays.end());
  rays.erase(std::unique(rays.begin(), rays.end()), rays.end());
  constexpr std::size_t prime = 1'000'000'007;  // more than there are edges
  std::vector<Vector3> result;
  result.reserve(rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) result.push_back(rays[k * prime % rays.size()]);
  return result;
}

using Direction = std::array<double, 3>;

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::vector<Direction> directions(std::span<const Vector3> vectors) {
  std::vector<Direction> result;
  result.reserve(vectors.size());
  for (const Vector3& w : vectors) {
    Direction d = {w[0].to_double(), w[1].to_double(), w[2].to_double()};
    const double length = std::sqrt(dot(d, d));
    for (double& x : d) x /= length;  // may be NaN beyond the range of double: then nothing is proposed
    result.push_back(d);
  }
  return result;
}

/// A direction well inside the dual cone: steps towards the vector that is worst served. Not a number of steps that finds one
/// always, but one that finds nearly all.
std::optional<Direction> proposed_normal(const std::vector<Direction>& vectors) {
  Direction n{};
  for (const Direction& w : vectors)
    for (std::size_t c = 0; c < 3; ++c) n[c] += w[c];
  for (int step = 0; step < 60; ++step) {
    const double length = std::sqrt(dot(n, n));
    if (!(length > 1e-6)) return std::nullopt;
    for (double& x : n) x /= length;
    double least = 1;
    const Direction* worst = nullptr;
    for (const Direction& w : vectors) {
      const double value = dot(n, w);
      if (!(value >= least)) {
        least = value;
        worst = &w;
      }
    }
    if (least > 1e-3 || worst == nullptr) return n;
    const double push = 0.05 - least;  // past the boundary by a little
    for (std::size_t c = 0; c < 3; ++c) n[c] += push * (*worst)[c];
  }
  return n;
}

}  // namespace

bool is_positive_on(const Vector3& n, std::span<const Vector3> vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [&](const Vector3& w) { return dot(n, w).sign() > 0; });
}

std::optional<Vector3> half_space(std::span<const Vector3> vectors) {
  if (vectors.empty()) return Vector3{0, 0, 1};
  if (const std::optional<Direction> proposal = proposed_normal(directions(vectors))) {
    Vector3 n;
    for (std::size_t c = 0; c < 3; ++c) n[c] = Rational(static_cast<int>(std::lround((*proposal)[c] * 4096)));
    if (is_positive_on(n, vectors)) return primitive(n);
  }
  std::vector<Vector3> reduced(vectors.begin(), vectors.end());
  for (Vector3& w : reduced) w = primitive(w);
  return exact_half_space(reduced.size() > 64 ? scattered(std::move(reduced)) : reduced);
}

}  // namespace udcp
