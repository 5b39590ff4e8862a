// A word and a mesh compiled to a few small matrices. Start reading here; README.md tells the idea on a page.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "operators/plan/face_matrix.h"
#include "operators/plan/flat_mesh.h"
#include "operators/plan/product.h"
#include "operators/run.h"

namespace udcp {

struct PlanControl {
  RunControl run;             // first_item, limits, stop and progress, as for run()
  bool limit_points = false;  // the limits of the refined points instead of the points
  bool normals = false;       // of the limit surface, at the refined points
  bool always = false;        // plan from the mesh as it is, whatever it costs; for plans that are executed many times
  int threads = 1;
};

/// What compile() makes and execute() runs. R = float or double.
///
/// The result has n = `segments` segments per edge of `mesh`, which is the mesh given, or the one that a few rounds on the
/// general path made of it. Its points: those of `mesh`; then the n - 1 inside every edge e, along mesh.edge_half[e]; then those
/// inside every face, row by row from its first corner, the rows along its first edge. Its faces: n * n per face, likewise.
template <class R>
struct Plan {
  // The rounds that go before on the general path: `before` of them, with the head if there is one.
  Word word;
  Surface<double> base;  // without points
  int before = 0, first_item = 0;
  bool head_before = false;

  std::shared_ptr<const Mesh> mesh;
  int corners_per_face = 4, segments = 1;
  BlockContent content;

  struct Kind {                          // of faces, and the corner from which they look alike
    std::vector<PanelMatrix<R>> layers;  // points; with normals also the two tangents
    std::int64_t first_job = 0;          // its faces are jobs first_job .. up to those of the next kind
    std::size_t first_vertex = 0;        // of its first job in `vertex`
  };
  std::vector<Kind> kinds;
  std::vector<int> face;              // per job
  std::vector<std::uint8_t> writes;   // per job: bit k for its edge k, bit corners_per_face + k for its corner k
  std::vector<std::uint32_t> vertex;  // per job and column of its matrix: the vertex of `mesh` it is multiplied with

  [[nodiscard]] std::int64_t vertices() const;
  [[nodiscard]] std::int64_t faces() const;
  [[nodiscard]] std::int64_t bytes() const;  // of the result
};

/// What is left to do on the general path when no plan applies or pays: the surface after `done` rounds (and the head).
struct Unplanned {
  Surface<double> surface;
  int done = 0;
  bool head_done = false;
};

template <class R>
struct Compiled {
  std::optional<Plan<R>> plan;
  Unplanned rest;         // where there is no plan
  Points<double> points;  // where there is one: the points of plan->mesh, ready for execute_last
};

/// The plan for the rounds that run() would make. No plan: where parameters differ from point to point, for dual results, for
/// rounds without U, and where the general path is faster. Throws what run() and, for limits and normals, limit() throw.
template <class R>
Compiled<R> compile(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control = {});

/// Runs a plan on control points (a row per vertex of the mesh that was compiled, one to three columns) and fills `result`: where
/// its buffers have no size, they are made; otherwise points and normals are overwritten and corners stay, for moving points.
template <class R>
void execute(const Plan<R>& plan, const Points<double>& control_points, FlatMesh<R>& result, const PlanControl& control = {});

/// The same from the points of plan.mesh on, which compile() has at hand.
template <class R>
void execute_last(const Plan<R>& plan, const Points<double>& points, FlatMesh<R>& result, const PlanControl& control = {});

}  // namespace udcp
