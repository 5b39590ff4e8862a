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
  bool always = false;        // for plans that are executed many times: execute() shall be fast, whatever compile() costs
  int threads = 1;
};

template <class R>
struct Plan;

/// What goes before a plan on the general path: the head of the word and a few rounds. With PlanControl::always these have a plan
/// of their own where one applies.
struct RoundsBefore {
  Word word;
  Surface<double> base;  // the mesh that was compiled, without points
  int rounds = 0, first_item = 0;
  bool head = false;
  std::shared_ptr<const Plan<double>> plan;
  std::vector<int> number;  // with a plan: per vertex that run() makes its number in the result of the plan
  [[nodiscard]] bool is_empty() const { return rounds == 0 && !head; }
};

/// The points that the rounds before make of control points, in the order of run().
Points<double> points_after(const RoundsBefore& before, const Points<double>& control_points, const PlanControl& control);

/// What compile() makes and execute() runs. R = float or double.
///
/// The result has n = `segments` segments per edge of `mesh`, which is the mesh given, or the one that a few rounds on the
/// general path made of it. Its points: those of `mesh`; then the n - 1 inside every edge e, along mesh.edge_half[e]; then those
/// inside every face, row by row from the corner where the face looks as others of its kind do, the rows along the edge that
/// leaves it. Its faces: n * n per face, row by row from its first corner.
template <class R>
struct Plan {
  RoundsBefore before;
  std::shared_ptr<const Mesh> mesh;
  int corners_per_face = 4, segments = 1;
  BlockContent content;

  struct Kind {                          // of faces
    std::vector<PanelMatrix<R>> layers;  // points; with normals also the two tangents
    std::int64_t first_job = 0;          // its faces are jobs first_job .. up to those of the next kind
    std::size_t first_vertex = 0;        // of its first job in `vertex`
  };
  std::vector<Kind> kinds;
  std::vector<std::uint8_t> turn;     // per face of `mesh`: its corner and edge that are 0 for its kind
  std::vector<int> face;              // per job
  std::vector<std::uint8_t> writes;   // per job: bit k for edge k of the kind, bit corners_per_face + k for corner k
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
