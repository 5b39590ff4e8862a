// Ours in the comparison. Schemes: catmull_clark, loop, and uccp = (UCCP)* with omega = 1, which no other library has.
// --way cold:    refine(), which plans where it pays; the result is flat arrays of points and corners.
//       warm:    a plan compiled before and executed before, run again on the control points.
//       general: the atoms one after the other, in double; the reference of the others.
#include <memory>

#include "bench/peers/harness.h"
#include "operators/plan/refine.h"
#include "operators/schemes.h"

namespace {

using namespace peers;

/// (UCCP)* where f = omega = delta = 1, the defaults.
udcp::Word uccp() {
  udcp::Word word;
  word.tail.resize(4);
  word.tail[1].atom = word.tail[2].atom = udcp::Atom::convolve;
  word.tail[3].atom = udcp::Atom::push_back;
  udcp::validate(word);
  return word;
}

udcp::Word word_of(const Job& job) {
  if (job.scheme == "catmull_clark") return udcp::schemes::catmull_clark();
  if (job.scheme == "loop") return udcp::schemes::loop();
  if (job.scheme == "uccp") return uccp();
  refuse("no scheme " + job.scheme);
}

/// From face lists, as every library starts: what makes the half-edges is timed.
udcp::Surface<double> surface_of(const Cage& cage) {
  std::vector<int> begin{0};
  for (const int size : cage.sizes) begin.push_back(begin.back() + size);
  udcp::Surface<double> surface;
  surface.mesh = std::make_shared<const udcp::Mesh>(udcp::make_mesh(cage.vertices(), std::move(begin), cage.corners));
  surface.points = Eigen::Map<const udcp::Points<double>>(cage.points.data(), cage.vertices(), 3);
  return surface;
}

Result result_of(const udcp::Surface<double>& refined) {
  const udcp::Mesh& mesh = *refined.mesh;
  Result result;
  result.points.assign(refined.points.data(), refined.points.data() + refined.points.size());
  result.corners.assign(mesh.vertex.begin(), mesh.vertex.end());
  result.corners_per_face = mesh.size(0);
  return result;
}

template <class R>
Result result_of(const udcp::FlatMesh<R>& mesh) {
  return {{mesh.points.begin(), mesh.points.end()}, {mesh.corners.begin(), mesh.corners.end()}, mesh.corners_per_face};
}

Program general(const Job& job, const Cage& cage) {
  auto refined = std::make_shared<udcp::Surface<double>>();
  Program program;
  program.drop = [refined] { *refined = {}; };
  program.run = [refined, job, &cage, word = word_of(job)] { *refined = udcp::run(word, surface_of(cage), job.rounds); };
  program.sizes = [refined, job] { return sizes_of(refined->mesh->vertices(), refined->mesh->faces(), job, true); };
  program.result = [refined] { return result_of(*refined); };
  return program;
}

udcp::PlanControl control_of(const Job& job) {
  udcp::PlanControl control;
  control.threads = job.threads;
  return control;
}

template <class R>
Program cold(const Job& job, const Cage& cage) {
  auto refined = std::make_shared<udcp::FlatMesh<R>>();
  Program program;
  program.drop = [refined] { *refined = {}; };
  program.run = [refined, job, &cage, word = word_of(job)] {
    udcp::Refined<R> result = udcp::refine<R>(word, surface_of(cage), job.rounds, control_of(job));
    if (!result.is_flat()) refuse("refine() made no flat mesh of this");
    *refined = std::get<0>(std::move(result.mesh));
  };
  program.sizes = [refined, job] { return sizes_of(refined->vertices(), refined->faces(), job, true); };
  program.result = [refined] { return result_of(*refined); };
  return program;
}

template <class R>
Program warm(const Job& job, const Cage& cage) {
  struct State {
    udcp::Compiled<R> compiled;
    udcp::Points<double> control_points;
    udcp::FlatMesh<R> mesh;
    udcp::PlanControl control;
  };
  auto state = std::make_shared<State>();
  const udcp::Surface<double> surface = surface_of(cage);
  state->control = control_of(job);
  state->control.always = true;
  state->control_points = surface.points;
  state->compiled = udcp::compile<R>(word_of(job), surface, job.rounds, state->control);
  if (!state->compiled.plan) refuse("there is no plan for this");
  Program program;
  program.run = [state] { udcp::execute(*state->compiled.plan, state->control_points, state->mesh, state->control); };
  program.run();  // touches every page of the result
  program.sizes = [state, job] { return sizes_of(state->mesh.vertices(), state->mesh.faces(), job, false); };
  program.result = [state] { return result_of(state->mesh); };
  return program;
}

template <class R>
Program make_in(const Job& job, const Cage& cage) {
  if (job.way == "cold") return cold<R>(job, cage);
  if (job.way == "warm") return warm<R>(job, cage);
  if (job.way == "general") return general(job, cage);
  refuse("we know the ways cold, warm and general");
}

Program make(const Job& job, const Cage& cage) {
  return job.real == "float" ? make_in<float>(job, cage) : make_in<double>(job, cage);
}

}  // namespace

int main(int argc, char** argv) { return run_main(argc, argv, make); }
