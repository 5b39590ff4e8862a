// The execution state of a word on a shape, one step per atom.
#include "operators/run.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "operators/atoms.h"
#include "operators/interrupt.h"
#include "operators/size_limits.h"

namespace udcp {
namespace {

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// What differs between curves and surfaces, as overloads.
template <class S>
Polyline<S> split(const Polyline<S>& shape, const Item& item, const Word&) {
  return up(shape, item.sections);
}
template <class S>
Surface<S> split(const Surface<S>& shape, const Item& item, const Word& word) {
  return up(shape, {item.sections, word.triangles});
}

template <class S>
bool is_old(const Polyline<S>&, const Polyline<S>&, const Item& item, int i) {
  return i % item.sections == 0;
}
template <class S>
bool is_old(const Surface<S>& before, const Surface<S>&, const Item&, int i) {
  return i < before.mesh->vertices();
}

template <class S>
void place_weights(const Polyline<S>&, const Item& last_up, const Word&, KernelWeights<S>& weights) {
  weights.sections = last_up.sections;
}
template <class S>
void place_weights(const Surface<S>& before, const Item& last_up, const Word& word, KernelWeights<S>& weights) {
  weights.origin = origin_of_split(*before.mesh, {last_up.sections, word.triangles});
}

template <class S>
Points<S> push(Points<S> current, const Polyline<S>& before, const Item& last_up, const Word&, const PushBack<S>& parameters) {
  return push_back(std::move(current), before, last_up.sections, parameters);
}
template <class S>
Points<S> push(Points<S> current, const Surface<S>& before, const Item& last_up, const Word& word,
               const PushBack<S>& parameters) {
  return push_back(std::move(current), before, {last_up.sections, word.triangles}, parameters);
}

// Valence classes of the old vertices: class 0 is the regular value, which boundary vertices and all new points have.
struct Classes {
  std::vector<int> valence;  // per class
  std::shared_ptr<const std::vector<int>> slot;
  bool regular_among_old = false;
};

template <class S>
Classes classes_of(const Polyline<S>&, int regular) {
  return {{regular}, nullptr, true};
}
template <class S>
Classes classes_of(const Surface<S>& before, int regular) {
  Classes classes{{regular}, nullptr, false};
  const Mesh& mesh = *before.mesh;
  auto slot = std::make_shared<std::vector<int>>(at(mesh.vertices()), 0);
  std::vector<int> known(at(regular) + 1, -1);  // per valence its class
  known[at(regular)] = 0;
  for (int v = 0; v < mesh.vertices(); ++v) {
    const int n = mesh.on_boundary(v) ? regular : mesh.valence(v);
    if (at(n) >= known.size()) known.resize(at(n) + 1, -1);
    if (known[at(n)] < 0) {
      known[at(n)] = static_cast<int>(classes.valence.size());
      classes.valence.push_back(n);
    }
    (*slot)[at(v)] = known[at(n)];
    classes.regular_among_old |= n == regular;
  }
  if (classes.valence.size() > 1) classes.slot = std::move(slot);
  return classes;
}

// Interior vertices have their own N at the start, before any U; the rest of the rules on N is in parameter().
template <class S>
int start_valence(const Polyline<S>&, int, int regular) {
  return regular;
}
template <class S>
int start_valence(const Surface<S>& shape, int v, int regular) {
  return shape.mesh->on_boundary(v) ? regular : shape.mesh->valence(v);
}

template <class S>
int points_of(const Polyline<S>& shape) {
  return shape.size();
}
template <class S>
int points_of(const Surface<S>& shape) {
  return shape.mesh->vertices();
}

const char* alpha_column(EdgeTag direction) {
  return direction == EdgeTag::latitude ? "@alpha@lat" : direction == EdgeTag::longitude ? "@alpha@lon" : "@alpha";
}

template <class S, class Shape>
class Runner {
 public:
  Runner(const Word& word, Shape shape, const RunControl& control) : word_(word), shape_(std::move(shape)), control_(control) {
    regular_ = word.triangles ? 6 : 4;
    for (; next_item_ < control.first_item; ++next_item_)
      if (word.item(next_item_).atom == Atom::up) count_up(word.item(next_item_));
    start_alpha();
  }

  void step() {
    const Item& item = word_.item(next_item_++);
    switch (item.atom) {
      case Atom::up:
        apply_up(item);
        break;
      case Atom::average:
        apply_average(item);
        break;
      case Atom::convolve:
        apply_convolve(item);
        break;
      case Atom::push_back:
        apply_push_back(item);
        break;
    }
  }

  [[nodiscard]] const Shape& shape() const { return shape_; }

  Shape result() {
    realise();
    for (const EdgeTag direction : {EdgeTag::none, EdgeTag::latitude, EdgeTag::longitude})
      shape_.attributes.erase(alpha_column(direction));
    return std::move(shape_);
  }

 private:
  // ---- alpha ----
  struct Alpha {
    Quantity<S> constant;
    bool varies = false;  // then the start values are a column of the shape, which U and the dual interpolate like any attribute
  };

  void start_alpha() {
    for (const EdgeTag direction : {EdgeTag::none, EdgeTag::latitude, EdgeTag::longitude}) {
      const KernelPtr& kernel = word_.alpha0.at(direction);
      if (!kernel) continue;
      Alpha& alpha = slot(alpha_, direction);
      const Needs needs = kernel->needs();
      alpha.varies = needs.vertex || needs.valence;
      if (!alpha.varies) {
        alpha.constant = kernel->at(Context<S>{{}, regular_, 0, -1, nullptr});
        continue;
      }
      std::vector<S> column;
      for (int v = 0; v < points_of(shape_); ++v)
        column.push_back(kernel->at(Context<S>{{}, start_valence(shape_, v, regular_), 0, v, &shape_.attributes}).value());
      shape_.attributes[alpha_column(direction)] = std::move(column);
    }
  }

  template <class T>
  static T& slot(Directional<T>& directional, EdgeTag direction) {
    return direction == EdgeTag::latitude    ? directional.latitude
           : direction == EdgeTag::longitude ? directional.longitude
                                             : directional.plain;
  }

  [[nodiscard]] Quantity<S> alpha(EdgeTag direction, int v) const {
    const Alpha& start = alpha_.at(direction);
    const Quantity<S> value =
        start.varies ? Quantity<S>::of(shape_.attributes.at(alpha_column(direction))[at(v)]) : start.constant;
    return divisor_ == Rational(1) ? value : value / Quantity<S>(divisor_);
  }

  void count_up(const Item& item) {
    if (ups_ > 0) divisor_ *= Rational(last_up_->sections);
    ++ups_;
    last_up_ = &item;
  }

  // ---- parameters ----
  enum class Where { old_points, new_points, old_and_edge_points };

  [[nodiscard]] S value(const Kernel& kernel, EdgeTag direction, int valence, int vertex) const {
    return kernel.at(Context<S>{alpha(direction, vertex), valence, ups_ - 1, vertex, &shape_.attributes}).value();
  }

  Parameter<S> parameter(const KernelPtr& kernel, EdgeTag direction, Where where) {
    if (!kernel) return Parameter<S>::constant(S(1));
    const Needs needs = kernel->needs();
    if (needs.vertex || alpha_.at(direction).varies) return parameter_per_point(*kernel, direction, where);
    if (where == Where::new_points || !needs.valence) return Parameter<S>::constant(value(*kernel, direction, regular_, -1));
    if (!classes_) classes_ = classes_of(*before_, regular_);
    Parameter<S> result{{}, classes_->slot};
    for (std::size_t k = 0; k < classes_->valence.size(); ++k) {
      const bool used = k > 0 || classes_->regular_among_old || where == Where::old_and_edge_points;
      result.values.push_back(used ? value(*kernel, direction, classes_->valence[k], -1) : S(0));
    }
    return result;
  }

  Parameter<S> parameter_per_point(const Kernel& kernel, EdgeTag direction, Where where) {
    Parameter<S> result;
    const int n = points_of(shape_);
    result.values.assign(at(n), S(0));
    if (n == 1) return Parameter<S>::constant(value(kernel, direction, regular_, 0));
    KernelWeights<S> place;
    place_weights(*before_, *last_up_, word_, place);
    int old_index = 0;
    for (int i = 0; i < n; ++i) {
      const bool old = is_old(*before_, shape_, *last_up_, i);
      const int valence = old ? start_valence(*before_, old_index++, regular_) : regular_;
      const bool wanted = where == Where::old_points ? old : where == Where::new_points ? !old : old || !in_face(place, i);
      if (wanted) result.values[at(i)] = value(kernel, direction, valence, i);
    }
    return result;
  }

  static bool in_face(const KernelWeights<S>& place, int i) {
    if constexpr (std::is_same_v<Shape, Surface<S>>) return place.origin.is_in_face(i);
    (void)place, (void)i;
    return false;
  }

  Directional<Parameter<S>> directional(const Directional<KernelPtr>& kernels, Where where) {
    Directional<Parameter<S>> result;
    for (const EdgeTag direction : {EdgeTag::none, EdgeTag::latitude, EdgeTag::longitude})
      slot(result, direction) = parameter(kernels.at(direction), direction, where);
    return result;
  }

  // ---- atoms ----
  void realise() {
    if (!dual_) return;
    shape_ = realise_dual(shape_, *dual_);
    dual_.reset();
    made_by_up_ = false;
  }

  void apply_up(const Item& item) {
    realise();
    count_up(item);
    before_ = std::move(shape_);
    shape_ = split(*before_, item, word_);
    classes_.reset();
    averages_ = 0;
    made_by_up_ = true;
  }

  // The kernel acts on the first D after U, and wherever an item says so itself.
  [[nodiscard]] bool kernel_acts(const Item& item) const {
    return made_by_up_ && !dual_ && (averages_ == 0 || item.f_everywhere);
  }

  KernelWeights<S> weights(const Item& item) {
    KernelWeights<S> result;
    result.f = directional(item.f, Where::old_and_edge_points);
    place_weights(*before_, *last_up_, word_, result);
    return result;
  }

  void average(const Item* with_kernel) {
    if (dual_) {
      shape_.points = to_primal(shape_, *dual_);
      dual_.reset();
      return;
    }
    if (with_kernel != nullptr) {
      const KernelWeights<S> w = weights(*with_kernel);
      dual_ = to_dual(shape_, &w);
    } else {
      dual_ = to_dual<S>(shape_, nullptr);
    }
  }

  void apply_average(const Item& item) {
    average(kernel_acts(item) ? &item : nullptr);
    ++averages_;
  }

  void apply_convolve(const Item& item) {
    if (!convolve_in_one_pass(item)) {
      average(kernel_acts(item) ? &item : nullptr);
      average(nullptr);
    }
    averages_ += 2;
  }

  // On meshes, but for the C between two D, which starts in the dual. Everywhere else C is two averages.
  bool convolve_in_one_pass(const Item& item) {
    if constexpr (std::is_same_v<Shape, Surface<S>>) {
      if (dual_) return false;
      std::optional<KernelWeights<S>> acting;
      if (kernel_acts(item)) acting = weights(item);
      const KernelWeights<S>* w = acting ? &*acting : nullptr;
      const bool classic = item.ngon == Ngon::classic && made_by_up_ && averages_ == 0 && last_up_->sections == 2;
      shape_.points = word_.triangles ? convolve_triangles(shape_, w)
                      : classic       ? convolve_classic(shape_, *w, *before_->mesh)
                                      : convolve(shape_, w);
      return true;
    }
    (void)item;
    return false;
  }

  void apply_push_back(const Item& item) {
    if (!before_)
      throw Error(ErrorKind::word, "E_P_NO_U", "P pushes back to the points before U, but this round starts without one",
                  "start the round with U");
    PushBack<S> parameters;
    parameters.delta = parameter(item.delta, EdgeTag::none, Where::old_points);
    parameters.omega = directional(item.omega, Where::new_points);
    parameters.has_omega_face = item.omega_face != nullptr;
    if (item.omega_face) parameters.omega_face = parameter(item.omega_face, EdgeTag::none, Where::new_points);
    shape_.points = push(std::move(shape_.points), *before_, *last_up_, word_, parameters);
    if constexpr (std::is_same_v<Shape, Surface<S>>) apply_rings();
  }

  void apply_rings() {
    const auto pass = [&](EdgeTag direction) {
      const KernelPtr cosine = formula([](const auto& c) {
        using std::cos;
        return cos(c.alpha / 2);
      });
      shape_.points = ring_pass(std::move(shape_.points), *before_, direction, parameter(cosine, direction, Where::new_points));
    };
    if (word_.rings == Rings::longitude || word_.rings == Rings::both) pass(EdgeTag::longitude);
    if (word_.rings == Rings::latitude || word_.rings == Rings::both) pass(EdgeTag::latitude);
  }

  const Word& word_;
  Shape shape_;  // K with its primal points
  const RunControl& control_;
  std::optional<Points<S>> dual_;   // set: the values are dual, and the points of shape_ are those before the last D
  std::optional<Shape> before_;     // reference of P: the shape before the last U
  std::optional<Classes> classes_;  // of the old vertices of before_, made when first asked for
  Directional<Alpha> alpha_;
  Rational divisor_{1};  // alpha = start value / divisor
  const Item* last_up_ = nullptr;
  int ups_ = 0, averages_ = 0, regular_ = 4, next_item_ = 0;
  bool made_by_up_ = false;
};

// The work of one atom, for progress: the faces that it leaves, one for a curve.
template <class S>
double work_on(const Surface<S>& shape) {
  return shape.mesh->faces() + 1.0;
}
template <class S>
double work_on(const Polyline<S>&) {
  return 1;
}

// The whole work of what is left to run, checked against the limits.
template <class S>
double plan(const Word& word, const Surface<S>& shape, int rounds, const RunControl& control) {
  double work = 0;
  const auto note = [&](const Counts& c) {
    work += static_cast<double>(c.faces) + 1;
    check_elements(c.faces, "faces", control.max_faces);
  };
  const Counts largest = counts(word, counts(*shape.mesh, shape.tags), rounds, note);
  check_elements(largest.faces, "faces", control.max_faces);
  const std::int64_t per_vertex = 8 + 3 * shape.points.cols() * static_cast<std::int64_t>(sizeof(S));
  check_memory(16 * largest.half_edges + 4 * (largest.edges + largest.faces) + per_vertex * largest.vertices, control.max_bytes);
  return work;
}

template <class S>
double plan(const Word& word, const Polyline<S>& shape, int rounds, const RunControl& control) {
  int corners = 0;
  for (int i = 0; i < shape.size(); ++i) corners += shape.is_corner(i);
  const std::int64_t points = count_points(word, shape.size(), shape.closed, corners, rounds);
  check_elements(points, "points", control.max_faces);
  check_memory(points * 3 * shape.points.cols() * static_cast<std::int64_t>(sizeof(S)), control.max_bytes);
  return word.items(rounds);
}

// What is left of a word that continues.
Word without_head(Word word) {
  word.head.clear();
  return word;
}

template <class S, class Shape>
Shape run_word(const Word& word, Shape shape, int rounds, const RunControl& control) {
  if (rounds < 0)
    throw Error(ErrorKind::input, "E_ROUNDS", "the number of rounds is " + std::to_string(rounds) + "; it cannot be negative",
                "");
  const int from = control.first_item;
  const double total = from == 0 ? plan(word, shape, rounds, control) : plan(without_head(word), shape, rounds, control);
  const int to = from == 0 ? word.items(rounds) : from + rounds * static_cast<int>(word.tail.size());
  double done = 0;
  Runner<S, Shape> runner(word, std::move(shape), control);
  for (int i = from; i < to; ++i) {
    throw_if_stopped(control.stop);
    runner.step();
    done += work_on(runner.shape());
    if (control.progress) control.progress(std::min(1.0, done / total));
  }
  return runner.result();
}

}  // namespace

template <class S>
Polyline<S> run(const Word& word, Polyline<S> curve, int rounds, const RunControl& control) {
  validate_for_curve(word);
  validate_columns(curve);
  return run_word<S>(word, std::move(curve), rounds, control);
}

template <class S>
Surface<S> run(const Word& word, Surface<S> surface, int rounds, const RunControl& control) {
  validate(word);
  validate(surface);
  return run_word<S>(word, std::move(surface), rounds, control);
}

#define UDCP_INSTANTIATE(S)                                                   \
  template Polyline<S> run(const Word&, Polyline<S>, int, const RunControl&); \
  template Surface<S> run(const Word&, Surface<S>, int, const RunControl&);
UDCP_FOR_EACH_NUMBER(UDCP_INSTANTIATE)
#undef UDCP_INSTANTIATE

}  // namespace udcp
