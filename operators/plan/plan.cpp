// Compiling: which rounds go first on the general path, the kinds of faces then, their matrices, and the faces in the order of
// their kinds.
#include "operators/plan/plan.h"

#include <algorithm>
#include <limits>

#include "operators/interrupt.h"
#include "operators/limit.h"
#include "operators/plan/block.h"
#include "operators/plan/correspondence.h"
#include "operators/size_limits.h"

namespace udcp {
namespace {

std::size_t at(std::int64_t k) { return static_cast<std::size_t>(k); }

// Nanoseconds on one core of an EPYC 7003; only their ratios matter, and not much. A round on the general path, per face that it
// makes. Of a plan: every level, whatever it holds; looking at a face, per vertex of its neighbourhood; of a kind its share of
// run(), per column of its matrix; and the product that puts its matrix together, per entry and column.
constexpr double general_face = 130, plan_level = 60'000, face_column = 25, kind_column = 1000, matrix_entry = 0.3;
// Deeper matrices leave the caches, and rounds that make one face in 4096 cost little on the general path.
constexpr int most_segments = 64;
// Bytes of tables while compiling: what a mesh of a few exotic vertices may cost, before its rounds go the general path.
constexpr double most_table_bytes = 256e6;
// Bytes of matrices in plans that are executed many times: they fit into the caches, or are less than what is written.
constexpr double kept_bytes = 4e6, kept_share = 0.5;

template <int N>
std::int64_t points_in(const Mesh& mesh, int segments) {
  const std::int64_t n = segments, inside = N == 4 ? (n - 1) * (n - 1) : (n - 1) * (n - 2) / 2;
  return mesh.vertices() + mesh.edges() * (n - 1) + mesh.faces() * inside;
}

// Vertices of a regular neighbourhood: the columns that most matrices have.
template <int N>
double usual_columns(int rings) {
  return N == 4 ? (2.0 * rings + 2) * (2 * rings + 2) : 3.0 * (rings + 1) * (rings + 1);
}

double cost_of_kind(const RoundsAhead& ahead, double columns) {
  const double n = ahead.segments();
  return columns * (kind_column + matrix_entry * columns * (n + 1) * (n + 1));
}

// How many times the usual number of vertices the neighbourhoods of faces have on average: sum of squares of the valences, 1
// where all are regular.
template <int N>
double crowding(const Mesh& mesh) {
  double squares = 0;
  for (const int valence : mesh.valences) squares += static_cast<double>(valence) * valence;
  return std::max(1.0, squares / ((N == 4 ? 4 : 6) * static_cast<double>(mesh.half_edges())));
}

// What kinds of faces may cost: less than to do without a plan, and less than to look again after one more general round.
template <int N>
double budget_for_kinds(const RoundsAhead& ahead, const Mesh& mesh, double columns) {
  const double faces = mesh.faces(), children = ahead.arity * ahead.arity, crowd = crowding<N>(mesh);
  const double look = face_column * columns * faces, looking = look * crowd;
  double round = general_face * faces * children, without_plan = 0;
  const double next_round = round, looking_later = look * (children + crowd - 1);  // new vertices are regular
  for (int k = 0; k < ahead.rounds; ++k, round *= children) without_plan += round;
  const double later = ahead.rounds == 1 ? without_plan : next_round + looking_later;
  return std::min(without_plan, later) - looking - plan_level * ahead.rounds;
}

template <class R, int N>
class Compiler {
 public:
  Compiler(const Word& planned, const PlanControl& control) : planned_(planned), control_(control) {
    content_ = {control.limit_points, control.normals};
  }

  /// Rounds on the general path until the kinds of faces are few; false if that took all of them.
  bool find_kinds(Unplanned& rest, int first_item, int rounds) {
    const int last_rings = content_.limit_points || content_.tangents ? limit_rings(planned_) : 0;
    for (;; ++rest.done) {
      const int left = rounds - rest.done;
      if (left == 0) return false;
      ahead_ = rounds_ahead(planned_, first_item + rest.done * static_cast<int>(planned_.tail.size()), left, last_rings);
      const double columns = usual_columns<N>(ahead_.rings[0]);
      const double budget = control_.always ? 1e300 : budget_for_kinds<N>(ahead_, *rest.surface.mesh, columns);
      const double most = std::min(1e6, budget / cost_of_kind(ahead_, columns));
      if (most >= 1 && ahead_.segments() <= most_segments) {
        groups_ =
            group_faces<N>(*rest.surface.mesh, rest.surface.tags, ahead_.rings[0], static_cast<int>(most), control_.run.stop);
        if (groups_.kinds.size() <= most && is_affordable(*rest.surface.mesh, budget)) return true;
      }
      RunControl one;
      one.first_item = ahead_.first_item;
      one.stop = control_.run.stop;
      one.max_faces = control_.run.max_faces;
      rest.surface = run(planned_, std::move(rest.surface), 1, one);
    }
  }

  Plan<R> plan(const Surface<double>& surface) {
    Plan<R> plan;
    plan.mesh = surface.mesh;
    plan.corners_per_face = N;
    plan.segments = ahead_.segments();
    plan.content = content_;
    check_size(plan);
    const std::vector<Points<double>> matrices = face_matrices<N>(groups_.kinds, ahead_, content_, control_.run.stop);
    std::vector<std::int64_t> jobs(matrices.size(), 0);
    for (std::size_t f = 0; f < groups_.kind.size(); ++f) {
      ++jobs[at(groups_.kind[f])];
      plan.turn.push_back(static_cast<std::uint8_t>(groups_.start[f] - N * static_cast<int>(f)));
    }
    std::vector<std::vector<int>> used;
    for (std::size_t k = 0; k < matrices.size(); ++k) {
      used.push_back(used_columns(matrices[k]));
      add_kind(matrices[k], used[k], jobs[k], plan);
    }
    order_faces(used, plan);
    return plan;
  }

 private:
  // Vertices of high valence have wide matrices: what the kinds cost in time, as tables of doubles, and in the plan.
  [[nodiscard]] bool is_affordable(const Mesh& mesh, double budget) const {
    const FaceKinds<N>& kinds = groups_.kinds;
    const int n = ahead_.segments(), a = ahead_.arity;
    const double rows = Block<N>{n}.points(), rows_of_children = a * a * static_cast<double>(kinds.most_vertices());
    double cost = 0, columns = 0;
    for (int k = 0; k < kinds.size(); ++k) {
      cost += cost_of_kind(ahead_, kinds[k].vertices);
      columns += kinds[k].vertices;
    }
    if (cost > budget || 8 * columns * (rows + rows_of_children) > most_table_bytes) return false;
    if (!control_.always) return true;
    const double written = 3.0 * static_cast<double>(points_in<N>(mesh, n));
    return columns * rows * sizeof(R) <= std::max(kept_bytes, kept_share * written * sizeof(R));
  }

  static void check_size(const Plan<R>& plan) {
    if (points_in<N>(*plan.mesh, plan.segments) <= std::numeric_limits<std::uint32_t>::max()) return;
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "the result would have " + std::to_string(points_in<N>(*plan.mesh, plan.segments)) +
                    " points; a flat mesh holds less than 2^32",
                "apply fewer rounds");
  }

  // The others belong to vertices that play no part.
  static std::vector<int> used_columns(const Points<double>& matrix) {
    std::vector<int> used;
    for (int column = 0; column < matrix.cols(); ++column)
      if (!matrix.col(column).isZero(0)) used.push_back(column);
    return used;
  }

  void add_kind(const Points<double>& matrix, const std::vector<int>& used, std::int64_t jobs, Plan<R>& plan) {
    typename Plan<R>::Kind kind;
    kind.first_job = static_cast<std::int64_t>(plan.face.size());
    kind.first_vertex = plan.vertex.size();
    const int points = Block<N>{plan.segments}.points();
    for (int first = 0; first < matrix.rows(); first += points)
      kind.layers.push_back(make_panels<R>(matrix, first, points, used));
    plan.kinds.push_back(std::move(kind));
    plan.face.resize(plan.face.size() + at(jobs));
    plan.writes.resize(plan.face.size());
    plan.vertex.resize(plan.vertex.size() + at(jobs) * used.size());
  }

  // Of what faces share, one of them writes: of an edge the one along which its points are numbered; of a vertex one with a low
  // corner there, as the rows of the last corner are the last ones, and those that nobody writes at the end are not computed.
  static std::vector<std::uint8_t> writers(const Plan<R>& plan) {
    const Mesh& mesh = *plan.mesh;
    std::vector<std::uint8_t> writes(at(mesh.faces()), 0);
    std::vector<bool> written(at(mesh.vertices()), false);
    for (int corner = 0; corner < N; ++corner) {
      for (std::size_t f = 0; f < writes.size(); ++f) {
        const std::size_t h = N * f + at((corner + plan.turn[f]) % N), v = at(mesh.vertex[h]);
        const bool edge = mesh.edge_half[at(mesh.edge[h])] == static_cast<int>(h), vertex = !written[v];
        writes[f] = static_cast<std::uint8_t>(writes[f] | (int{edge} << corner) | (int{vertex} << (N + corner)));
        written[v] = true;
      }
    }
    return writes;
  }

  // Counting sort; within a kind the faces stay in order.
  void order_faces(const std::vector<std::vector<int>>& used, Plan<R>& plan) {
    std::vector<std::int64_t> next;
    std::vector<std::size_t> vertex;
    for (const auto& kind : plan.kinds) next.push_back(kind.first_job), vertex.push_back(kind.first_vertex);
    const std::vector<std::uint8_t> writes = writers(plan);
    for (std::size_t f = 0; f < groups_.kind.size(); ++f) {
      const std::size_t k = at(groups_.kind[f]);
      plan.writes[at(next[k])] = writes[f];
      plan.face[at(next[k]++)] = static_cast<int>(f);
      for (const int column : used[k]) plan.vertex[vertex[k]++] = groups_.vertex[groups_.first_vertex[f] + at(column)];
    }
  }

  const Word& planned_;
  const PlanControl& control_;
  BlockContent content_;
  RoundsAhead ahead_;
  FaceGroups<N> groups_;
};

// The head, and one round where faces are not all of one size yet.
void start(const Word& word, const Word& planned, int rounds, const RunControl& control, Unplanned& rest) {
  RunControl before;
  before.stop = control.stop;
  before.max_faces = control.max_faces;
  if (!planned.head.empty() && control.first_item == 0) {
    rest.surface = run(word, std::move(rest.surface), 0, before);
    rest.head_done = true;
  }
  if (rounds == 0 || rest.surface.mesh->all_faces_have(word.triangles ? 3 : 4)) return;
  before.first_item = rest.head_done ? static_cast<int>(planned.head.size()) : control.first_item;
  rest.surface = run(planned, std::move(rest.surface), 1, before);
  rest.done = 1;
}

template <class R, int N>
void compile_rounds(const Word& planned, int rounds, const PlanControl& control, Compiled<R>& result) {
  const int first =
      control.run.first_item > 0 || !result.rest.head_done ? control.run.first_item : static_cast<int>(planned.head.size());
  Compiler<R, N> compiler(planned, control);
  if (!compiler.find_kinds(result.rest, first, rounds)) return;
  result.plan = compiler.plan(result.rest.surface);
}

// A plan for the rounds before, where one applies. It is used if it makes the points that were made without it.
void plan_before(const Surface<double>& surface, const Mesh& made, const Points<double>& points, const RunControl& run,
                 RoundsBefore& before) {
  if (before.rounds == 0) return;
  PlanControl control{run};
  control.run.progress = nullptr;
  control.always = true;
  Compiled<double> compiled = compile<double>(before.word, surface, before.rounds, control);
  if (!compiled.plan) return;
  FlatMesh<double> flat;
  execute(*compiled.plan, surface.points, flat, control);
  before.number = numbers_in_plan(made, half_edges_of(flat), *compiled.plan->mesh);
  if (before.number.empty()) return;
  before.plan = std::make_shared<const Plan<double>>(*std::move(compiled.plan));
  const double apart = (points_after(before, surface.points, control) - points).cwiseAbs().maxCoeff();
  if (!(apart <= 1e-9 * points.cwiseAbs().maxCoeff())) before.plan = nullptr;
}

// As run() counts and refuses, for the arrays that a plan makes.
template <class R>
void check_limits(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control) {
  Word rest = word;
  if (control.run.first_item > 0) rest.head.clear();
  const auto check = [&](const Counts& c) { check_elements(c.faces, "faces", control.run.max_faces); };
  const Counts end = counts(rest, counts(*surface.mesh, surface.tags), rounds, check);
  const auto number = static_cast<std::int64_t>(sizeof(R));
  check_memory(3 * number * end.vertices * (control.normals ? 2 : 1) + 4 * end.half_edges, control.run.max_bytes);
}

}  // namespace

template <class R>
std::int64_t Plan<R>::vertices() const {
  return corners_per_face == 3 ? points_in<3>(*mesh, segments) : points_in<4>(*mesh, segments);
}

template <class R>
std::int64_t Plan<R>::faces() const {
  return static_cast<std::int64_t>(segments) * segments * mesh->faces();
}

template <class R>
std::int64_t Plan<R>::bytes() const {
  return vertices() * 3 * static_cast<std::int64_t>(sizeof(R)) * (content.tangents ? 2 : 1) + faces() * corners_per_face * 4;
}

template <class R>
Compiled<R> compile(const Word& word, const Surface<double>& surface, int rounds, const PlanControl& control) {
  validate(word);
  validate(surface);
  if (control.limit_points || control.normals) limit_rings(word);  // throws where there are none
  Compiled<R> result;
  result.rest.surface = surface;
  const std::optional<Word> planned = planned_word(word);
  if (!planned || rounds < 1 || surface.points.cols() > 3) return result;
  check_limits<R>(word, surface, rounds, control);
  start(word, *planned, rounds, control.run, result.rest);
  if (word.triangles) {
    compile_rounds<R, 3>(*planned, rounds, control, result);
  } else {
    compile_rounds<R, 4>(*planned, rounds, control, result);
  }
  if (!result.plan) return result;
  Plan<R>& plan = *result.plan;
  plan.before = {*planned,
                 {surface.mesh, {}, surface.tags, surface.attributes},
                 result.rest.done,
                 control.run.first_item,
                 result.rest.head_done,
                 nullptr,
                 {}};
  result.points = std::move(result.rest.surface.points);
  if (control.always) plan_before(surface, *plan.mesh, result.points, control.run, plan.before);
  return result;
}

#define UDCP_INSTANTIATE(R) \
  template struct Plan<R>;  \
  template Compiled<R> compile(const Word&, const Surface<double>&, int, const PlanControl&);
UDCP_INSTANTIATE(float)
UDCP_INSTANTIATE(double)
#undef UDCP_INSTANTIATE

}  // namespace udcp
