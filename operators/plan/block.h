// How the points of one refined face are arranged. Knows no mesh and no coordinates.
//
// A face with n segments per edge is a grid: quads hold the places (i, j) with 0 <= i, j <= n, corner 0 at (0, 0), corner 1 at
// (n, 0), counter-clockwise; triangles those with i + j <= n, corner 2 at (0, n). Its points are stored as rows: interior row by
// row, then the n - 1 points inside edge 0, 1, .. from corner to corner, then the corners.
#pragma once

namespace udcp {

struct Place {
  int i = 0, j = 0;
};

/// N = 4 (quads) or 3 (triangles), n >= 1 segments.
template <int N>
struct Block {
  static_assert(N == 3 || N == 4);
  int n = 1;

  [[nodiscard]] int interior() const { return N == 4 ? (n - 1) * (n - 1) : (n - 1) * (n - 2) / 2; }
  [[nodiscard]] int points() const { return interior() + N * n; }
  [[nodiscard]] int faces() const { return n * n; }
  [[nodiscard]] int last_i(int j) const { return N == 4 ? n : n - j; }

  /// The edge on whose way from corner to corner, the end left out, the place lies, and how far; edge -1 inside.
  struct Border {
    int edge = -1, step = 0;
  };
  [[nodiscard]] Border border(Place p) const {
    if (p.j == 0 && p.i < n) return {0, p.i};
    if constexpr (N == 4) {
      if (p.i == n && p.j < n) return {1, p.j};
      if (p.j == n && p.i > 0) return {2, n - p.i};
      if (p.i == 0) return {3, n - p.j};
    } else {
      if (p.i + p.j == n && p.i > 0) return {1, p.j};
      if (p.i == 0) return {2, n - p.j};
    }
    return {};
  }

  [[nodiscard]] int interior_row(Place p) const { return (p.j - 1) * (n - 1) - (N == 4 ? 0 : p.j * (p.j - 1) / 2) + p.i - 1; }
  [[nodiscard]] int edge_row(int edge) const { return interior() + edge * (n - 1); }
  [[nodiscard]] int corner_row(int corner) const { return interior() + N * (n - 1) + corner; }
  [[nodiscard]] int row(Place p) const {
    const Border at = border(p);
    return at.edge < 0 ? interior_row(p) : at.step == 0 ? corner_row(at.edge) : edge_row(at.edge) + at.step - 1;
  }

  /// The place (i, j) of a grid that starts at corner `turn`, in the grid that starts at corner 0.
  [[nodiscard]] Place turned(Place p, int turn) const {
    for (; turn > 0; --turn) p = N == 4 ? Place{n - p.j, p.i} : Place{n - p.i - p.j, p.i};
    return p;
  }

  template <class Visit>
  void for_each_place(Visit visit) const {
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= last_i(j); ++i) visit(Place{i, j});
  }
  /// Corners of the n * n faces of the grid, row by row, N places each, counter-clockwise.
  template <class Visit>
  void for_each_face(Visit visit) const {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < last_i(j); ++i) {
        if constexpr (N == 4) {
          visit(Place{i, j}, Place{i + 1, j}, Place{i + 1, j + 1}, Place{i, j + 1});
        } else {
          visit(Place{i, j}, Place{i + 1, j}, Place{i, j + 1});
          if (i + 1 < last_i(j)) visit(Place{i + 1, j + 1}, Place{i, j + 1}, Place{i + 1, j});
        }
      }
    }
  }
};

}  // namespace udcp
