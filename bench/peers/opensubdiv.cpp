// OpenSubdiv (Pixar) in the comparison, as its documentation recommends uniform refinement.
// --way cold:    face lists to a refiner, refined without the last level's full topology; points by PrimvarRefiner, level by
// level;
//                the refiner's own face lists are the corners, nothing is copied.
//       levels:  warm, a table whose stencils reach one level back, points of four numbers, applied by its UpdateValues;
//                levels3: points of three numbers; evaluator: four numbers, applied by Osd::CpuEvaluator (float only).
//       factored: warm, a table from the control points to the last level, points of four numbers, by UpdateValues.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/osd/cpuEvaluator.h>

#include <memory>
#include <type_traits>

#include "bench/peers/harness.h"

namespace {

using namespace peers;
namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
namespace Osd = OpenSubdiv::Osd;

template <class R, int width>
struct Point {
  R x[width];
  void Clear(void* = nullptr) {
    for (R& c : x) c = 0;
  }
  void AddWithWeight(const Point& from, R weight) {
    for (int k = 0; k < width; ++k) x[k] += weight * from.x[k];
  }
};

std::unique_ptr<Far::TopologyRefiner> refiner_of(const Job& job, const Cage& cage) {
  Far::TopologyDescriptor face_lists;
  face_lists.numVertices = cage.vertices();
  face_lists.numFaces = cage.faces();
  face_lists.numVertsPerFace = cage.sizes.data();
  face_lists.vertIndicesPerFace = cage.corners.data();
  Sdc::Options scheme;
  scheme.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  if (job.scheme != "catmull_clark" && job.scheme != "loop") refuse("OpenSubdiv has no scheme " + job.scheme);
  const Factory::Options options(job.scheme == "loop" ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, scheme);
  std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(face_lists, options));
  if (!refiner) refuse("OpenSubdiv refuses the mesh");
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(job.rounds));  // without full topology of the last level
  return refiner;
}

template <class R, int width>
std::vector<Point<R, width>> control_points(const Cage& cage) {
  std::vector<Point<R, width>> points(static_cast<std::size_t>(cage.vertices()));
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < static_cast<std::size_t>(width); ++k)
      points[v].x[k] = k < 3 ? static_cast<R>(cage.points[3 * v + k]) : R(0);
  return points;
}

template <class P>
Result result_of(const Far::TopologyRefiner& refiner, const P* points) {
  const Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
  Result result;
  for (int v = 0; v < last.GetNumVertices(); ++v) result.points.insert(result.points.end(), points[v].x, points[v].x + 3);
  for (int f = 0; f < last.GetNumFaces(); ++f)
    for (const int v : {0, 1, 2, 3})
      if (v < last.GetFaceVertices(f).size()) result.corners.push_back(static_cast<std::uint32_t>(last.GetFaceVertices(f)[v]));
  result.corners_per_face = last.GetFaceVertices(0).size();
  return result;
}

Sizes sizes_in(const Far::TopologyRefiner& refiner, const Job& job, bool with_corners) {
  const Far::TopologyLevel& last = refiner.GetLevel(refiner.GetMaxLevel());
  return sizes_of(last.GetNumVertices(), last.GetNumFaces(), job, with_corners);
}

template <class R>
Program cold(const Job& job, const Cage& cage) {
  struct State {
    Job job;
    std::vector<Point<R, 3>> control;
    std::unique_ptr<Far::TopologyRefiner> refiner;
    std::unique_ptr<Point<R, 3>[]> points;
  };
  auto state = std::make_shared<State>(State{job, control_points<R, 3>(cage), nullptr, nullptr});
  Program program;
  program.drop = [state] { state->refiner.reset(), state->points.reset(); };
  program.run = [state, &cage] {
    State& s = *state;
    s.refiner = refiner_of(s.job, cage);
    const Far::PrimvarRefinerReal<R> primvar(*s.refiner);
    const Point<R, 3>* from = s.control.data();
    std::unique_ptr<Point<R, 3>[]> before;
    for (int level = 1; level <= s.job.rounds; ++level) {
      // Not initialised: the refiner clears every point before it adds to it.
      std::unique_ptr<Point<R, 3>[]> to(new Point<R, 3>[static_cast<std::size_t>(s.refiner->GetLevel(level).GetNumVertices())]);
      Point<R, 3>* target = to.get();
      primvar.Interpolate(level, from, target);
      before = std::move(to);
      from = before.get();
    }
    s.points = std::move(before);
  };
  program.sizes = [state] { return sizes_in(*state->refiner, state->job, true); };
  program.result = [state] { return result_of(*state->refiner, state->points.get()); };
  return program;
}

/// A stencil table and its points: the control points, then those of each level (by levels), or of the last one (factored).
template <class R, int width, bool by_evaluator>
struct Tabled {
  using P = Point<R, width>;
  std::unique_ptr<Far::TopologyRefiner> refiner;
  std::unique_ptr<const Far::StencilTableReal<R>> table;
  std::vector<P> points;

  Tabled(const Job& job, const Cage& cage, bool factored)
      : refiner(refiner_of(job, cage)), points(control_points<R, width>(cage)) {
    typename Far::StencilTableFactoryReal<R>::Options options;
    options.generateOffsets = true;
    options.generateIntermediateLevels = !factored;
    options.factorizeIntermediateLevels = factored;
    options.maxLevel = static_cast<unsigned>(job.rounds) & 15U;
    table.reset(Far::StencilTableFactoryReal<R>::Create(*refiner, options));
    points.resize(points.size() + static_cast<std::size_t>(table->GetNumStencils()));
  }

  /// Stencils first .. last-1 of the table, which count from point `source`, to the points behind the controls.
  void apply(int source, int first, int last) {
    P *from = points.data() + source, *to = points.data() + table->GetNumControlVertices();
    if constexpr (by_evaluator) {
      const int offset = table->GetOffsets()[static_cast<std::size_t>(first)];
      const Osd::BufferDescriptor packed(0, width, width);
      Osd::CpuEvaluator::EvalStencils(from->x, packed, (to + first)->x, packed, table->GetSizes().data() + first,
                                      table->GetOffsets().data() + first, table->GetControlIndices().data() + offset,
                                      table->GetWeights().data() + offset, 0, last - first);
    } else {
      table->UpdateValues(from, to, first, last);
    }
  }

  /// The stencils of a level count from the first point of the level before.
  void apply_by_levels() {
    int source = 0, first = 0;
    for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
      const int count = refiner->GetLevel(level).GetNumVertices();
      apply(source, first, first + count);
      source = table->GetNumControlVertices() + first;
      first += count;
    }
  }
};

template <class R, int width, bool by_evaluator = false>
Program warm(const Job& job, const Cage& cage, bool factored) {
  auto tabled = std::make_shared<Tabled<R, width, by_evaluator>>(job, cage, factored);
  Program program;
  program.run = [tabled, factored] {
    if (factored)
      tabled->apply(0, 0, tabled->table->GetNumStencils());
    else
      tabled->apply_by_levels();
  };
  program.run();  // touches every page of the result
  program.sizes = [tabled, job] { return sizes_in(*tabled->refiner, job, false); };
  program.result = [tabled] {
    const int last = tabled->refiner->GetLevel(tabled->refiner->GetMaxLevel()).GetNumVertices();
    return result_of(*tabled->refiner, tabled->points.data() + tabled->points.size() - last);
  };
  return program;
}

template <class R>
Program make_in(const Job& job, const Cage& cage) {
  if (job.way == "cold") return cold<R>(job, cage);
  if (job.way == "levels") return warm<R, 4>(job, cage, false);
  if (job.way == "levels3") return warm<R, 3>(job, cage, false);
  if (job.way == "factored") return warm<R, 4>(job, cage, true);
  if constexpr (std::is_same_v<R, float>)
    if (job.way == "evaluator") return warm<R, 4, true>(job, cage, false);
  refuse("OpenSubdiv knows the ways cold, levels, levels3, factored and, in float, evaluator");
}

Program make(const Job& job, const Cage& cage) {
  return job.real == "float" ? make_in<float>(job, cage) : make_in<double>(job, cage);
}

}  // namespace

int main(int argc, char** argv) { return run_main(argc, argv, make); }
