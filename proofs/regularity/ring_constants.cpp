// The constants of a valence: rows from the running atoms, eigenvectors enclosed from closed forms, bounds of the powers of A.
#include <Eigen/LU>
#include <map>
#include <mutex>

#include "operators/schemes.h"
#include "proofs/regularity/ring_certificate.h"
#include "proofs/surface_facts.h"

namespace udcp {

int ring_index(int valence, const Label& label) {
  if (label.is_centre()) return 0;
  const int i = label.a / 2, j = label.b / 2, r = std::max(i, j);
  return 1 + valence * r * (r - 1) + 2 * r * label.s + (i == r ? j : r + (r - i));
}

std::array<int, 16> ring_net(int valence, int patch) {
  const Sectors sectors{valence, false, false};
  const int s = patch / 3, i = patch % 3 == 2 ? 0 : 1, j = patch % 3 == 0 ? 0 : 1;
  std::array<int, 16> result{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      result[static_cast<std::size_t>(4 * row + column)] =
          ring_index(valence, sectors.label(s, {2 * (i - 1 + column), 2 * (j - 1 + row)}));
  return result;
}

using Index = Eigen::Index;

template <class S>
Points<S> sparse_product(const Points<Rational>& a, const Points<S>& b) {
  Points<S> result = Points<S>::Zero(a.rows(), b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j)
      if (!a(i, j).is_zero()) add(result, static_cast<int>(i), S(a(i, j)), b, static_cast<int>(j));
  return result;
}
template Points<Rational> sparse_product(const Points<Rational>&, const Points<Rational>&);
template Points<Interval> sparse_product(const Points<Rational>&, const Points<Interval>&);

namespace {

Index two_rings(int valence) { return 1 + 6 * valence; }

Points<Rational> outer_rows(const Patch<Rational>& patch) {
  const int n = patch.sectors.valence;
  Points<Rational> result = Points<Rational>::Zero(1 + 12 * n, two_rings(n));
  for (const auto& [label, row] : patch.rows) {
    if (patch.sectors.radius(label) > 6) continue;
    for (int s = 0; s < (label.is_centre() ? 1 : n); ++s)
      for (const auto& [place, weight] : row)
        result(ring_index(n, patch.sectors.rotated(label, s)), ring_index(n, patch.sectors.rotated(place, s))) = weight;
  }
  return result;
}

/// The weights of the limit point of the vertex; the closed form is checked against A.
Points<Rational> mean_row(const Points<Rational>& outer, int n) {
  const Index size = two_rings(n);
  Points<Rational> w = Points<Rational>::Zero(1, size);
  const Rational whole(n * (n + 5));
  w(0, 0) = Rational(n * n) / whole;
  for (int k = 0; k < 2 * n; ++k) w(0, 1 + k) = Rational(k % 2 == 0 ? 4 : 1) / whole;
  Rational sum;
  Points<Rational> image = Points<Rational>::Zero(1, size);
  for (Index i = 0; i < size; ++i) {
    sum += w(0, i);
    if (!w(0, i).is_zero())
      for (Index j = 0; j < size; ++j)
        if (!outer(i, j).is_zero()) image(0, j) += w(0, i) * outer(i, j);
  }
  require(sum == Rational(1) && image == w, "the limit weights of a vertex are not those of Catmull and Clark");
  return w;
}

Rational middle_of(const Interval& x) { return (x.lower() + x.upper()) / Rational(2); }

/// The eigenpair of a block of frequency 1 near a value, with first component 1. Floating point proposes it, and each enclosure
/// the centre of a smaller one.
Eigenpair eigenpair_near(const Points<Interval>& block, double value) {
  const Index n = block.rows();
  Eigen::MatrixXd rest(n - 1, n - 1);
  Eigen::VectorXd first(n - 1);
  for (Index i = 1; i < n; ++i) {
    for (Index j = 1; j < n; ++j) rest(i - 1, j - 1) = block(i, j).midpoint() - (i == j ? value : 0.0);
    first(i - 1) = -block(i, 0).midpoint();
  }
  const Eigen::VectorXd found = rest.partialPivLu().solve(first);
  ApproximatePair near{Rational::from_double(value), {Rational(1)}};
  for (Index i = 0; i < n - 1; ++i) near.vector.push_back(Rational::from_double(found[i]));
  std::optional<Eigenpair> result;
  for (int step = 0; step < 4; ++step) {
    result = enclose_eigenpair(block, near);
    require(result.has_value(), "the subdominant eigenvector at a vertex could not be enclosed");
    near.value = middle_of(result->value);
    for (std::size_t k = 0; k < near.vector.size(); ++k) near.vector[k] = middle_of(result->vector[k]);
  }
  return *result;
}

/// lambda = (4 + A_n)/16, A_n = 1 + c + cos(pi/n) sqrt(2 (9 + c)), c = cos(2 pi/n).
double proposed_lambda(int n) {
  const double c = cosine<double>(Rational(2) / Rational(n)), half = cosine<double>(Rational(1) / Rational(n));
  return (5 + c + half * std::sqrt(2 * (9 + c))) / 16;
}

/// Real and imaginary parts, over two rings, of the net of frequency 1 with these coordinates: a row per point.
Points<Interval> net_of(const Patch<Interval>& patch, const std::vector<Interval>& coordinates_of_net) {
  const int n = patch.sectors.valence;
  const std::vector<Coordinate> names = coordinates(patch.sectors, 4);
  Points<Interval> result = Points<Interval>::Zero(two_rings(n), 2);
  for (const Label& orbit : patch.orbits(4)) {
    for (int s = 0; s < n; ++s) {
      const Label label = patch.sectors.rotated(orbit, s);
      const Complex value = value_at(patch, 1, label, coordinates_of_net, names);
      result(ring_index(n, label), 0) = value.re;
      result(ring_index(n, label), 1) = value.im;
    }
  }
  return result;
}

/// lambda, E and L. The coordinates c of the part of frequency 1 of a net are linear in it, and one round takes them to M c with
/// the real block M; so for a left eigenvector l of M the complex functional l.c is one of A, and its real and imaginary parts
/// are rows of L up to a factor. Of a pair of points (a, b), (b, a) the coordinates x and y are half the sum of the values and
/// 1/2i of the difference, both turned, which explains the halves. The factor makes L E = I: L takes the net with coordinates v
/// to l.v, half of which is in its real part. As l.v is not 0, both eigenvalues are the same.
void store_eigenvectors(const Patch<Interval>& patch, const Points<Interval>& m, const Eigenpair& right, RingConstants& result) {
  const Points<Interval> transposed = m.transpose();
  const double lambda = right.value.midpoint();
  std::vector<Interval> l = eigenpair_near(transposed, lambda).vector;
  Interval product(0);
  for (std::size_t k = 0; k < l.size(); ++k) product += l[k] * right.vector[k];
  require(!product.contains_zero(), "the subdominant eigenvectors at a vertex could not be paired");
  const std::vector<Coordinate> names = coordinates(patch.sectors, 4);
  for (std::size_t k = 0; k < l.size(); ++k)
    if (names[k].orbit.b != 0 && names[k].orbit.a != names[k].orbit.b) l[k] /= Interval(2);
  result.lambda = right.value;
  result.right = net_of(patch, right.vector);
  result.left = Interval(Interval(2) / (Interval(patch.sectors.valence) * product)) * net_of(patch, l).transpose();
}

/// The differences of the `splits` times split patches of a net, as rows over its 16 points: by unit vectors, three at a time.
struct DifferenceRows {
  Points<Rational> u, v;
};
std::vector<DifferenceRows> difference_rows(int splits) {
  std::vector<DifferenceRows> result;
  for (int first = 0; first < 16; first += 3) {
    BicubicNet units;
    for (int c = 0; c < 3 && first + c < 16; ++c)
      units.points[static_cast<std::size_t>(first + c)][static_cast<std::size_t>(c)] = Rational(1);
    std::vector<BicubicNet> nets{units};
    for (int split = 0; split < splits; ++split) {
      std::vector<BicubicNet> finer;
      for (const BicubicNet& net : nets)
        for (int number = 0; number < 4; ++number) finer.push_back(child(net, number));
      nets = std::move(finer);
    }
    const Rational scale = pow(Rational(64), -splits);
    result.resize(nets.size());
    for (std::size_t k = 0; k < nets.size(); ++k) {
      const Differences found = differences(nets[k]);
      const auto store = [&](Points<Rational>& rows, const std::vector<Vector3>& vectors) {
        if (first == 0) rows = Points<Rational>::Zero(static_cast<Index>(vectors.size()), 16);
        for (std::size_t i = 0; i < vectors.size(); ++i)
          for (int c = 0; c < 3 && first + c < 16; ++c)
            rows(static_cast<Index>(i), first + c) = scale * vectors[i][static_cast<std::size_t>(c)];
      };
      store(result[k].u, found.u);
      store(result[k].v, found.v);
    }
  }
  return result;
}

template <class S>
Points<S> net_rows(const Points<S>& rings, int valence, int patch) {
  const std::array<int, 16> numbers = ring_net(valence, patch);
  Points<S> result(16, rings.cols());
  for (std::size_t k = 0; k < 16; ++k) result.row(static_cast<Index>(k)) = rings.row(numbers[k]);
  return result;
}

Interval length(const Points<Interval>& rows, Index i) {
  Interval sum(0);
  for (Index c = 0; c < rows.cols(); ++c) sum += pow(rows(i, c), 2);
  return sqrt(sum);
}

/// kappa and G for a number of splits. The patches of sector 0 suffice: those of the others are rotated copies.
void bound_ring(RingConstants& result, int splits) {
  const Points<Interval> ring = sparse_product(result.outer, result.right);
  const std::vector<DifferenceRows> rows = difference_rows(splits);
  bool first = true;
  result.splits = splits;
  result.size = Interval(0);
  for (int patch = 0; patch < 3; ++patch) {
    const Points<Interval> net = net_rows(ring, result.valence, patch);
    for (const DifferenceRows& leaf : rows) {
      const Points<Interval> u = sparse_product(leaf.u, net), v = sparse_product(leaf.v, net);
      for (Index i = 0; i < u.rows(); ++i) result.size = max(result.size, length(u, i));
      for (Index j = 0; j < v.rows(); ++j) result.size = max(result.size, length(v, j));
      for (Index i = 0; i < u.rows(); ++i) {
        for (Index j = 0; j < v.rows(); ++j) {
          const Interval determinant = u(i, 0) * v(j, 1) - u(i, 1) * v(j, 0);
          result.kappa = first ? determinant : min(result.kappa, determinant);
          first = false;
        }
      }
    }
  }
}

/// D: a difference of a split patch is a sum of those of the patch with weights of sum 1/2.
Rational difference_norm(const Points<Rational>& outer, int valence, int splits) {
  const DifferenceRows rows = difference_rows(0).front();
  Rational result;
  for (int patch = 0; patch < 3; ++patch) {
    const Points<Rational> net = net_rows(outer, valence, patch);
    for (const Points<Rational>& part : {sparse_product(rows.u, net), sparse_product(rows.v, net)}) {
      for (Index i = 0; i < part.rows(); ++i) {
        Rational sum;
        for (Index j = 0; j < part.cols(); ++j) sum += abs(part(i, j));
        if (sum > result) result = sum;
      }
    }
  }
  return result * pow(Rational(2), -splits);
}

/// Norms of Q B^r for r = 0, 1, .. With the projector Q = I - 1 w - E L, which commutes with A, B is A Q/lambda, and Q B^r =
/// lambda^-r A^r Q = lambda^-r (A^r - 1 w - lambda^r E L); for r > 0 that is B^r. The rows of the centre and of sector 0 suffice.
class Powers {
 public:
  explicit Powers(const RingConstants& constants) : lambda_(constants.lambda) {
    const int n = constants.valence;
    const Index size = two_rings(n);
    std::vector<int> numbers{0};
    for (const Label& label : {Label{0, 2, 0}, {0, 2, 2}, {0, 4, 0}, {0, 4, 2}, {0, 4, 4}, {0, 2, 4}})
      numbers.push_back(ring_index(n, label));
    rows_.resize(static_cast<std::size_t>(size));
    for (Index i = 0; i < size; ++i)
      for (Index j = 0; j < size; ++j)
        if (!constants.outer(i, j).is_zero()) rows_[static_cast<std::size_t>(i)].emplace_back(j, Interval(constants.outer(i, j)));
    for (Index j = 0; j < size; ++j) mean_.emplace_back(constants.mean(0, j));
    power_ = Points<Interval>::Zero(static_cast<Index>(numbers.size()), size);
    projection_ = power_;
    for (Index k = 0; k < power_.rows(); ++k) {
      power_(k, numbers[static_cast<std::size_t>(k)]) = Interval(1);
      projection_.row(k) = constants.right.row(numbers[static_cast<std::size_t>(k)]) * constants.left;
    }
  }

  [[nodiscard]] Interval norm() const {
    Interval result(0);
    for (Index k = 0; k < power_.rows(); ++k) {
      Interval sum(0);
      for (Index j = 0; j < power_.cols(); ++j)
        sum += abs(power_(k, j) - mean_[static_cast<std::size_t>(j)] - scale_ * projection_(k, j));
      result = max(result, sum / scale_);
    }
    return result;
  }

  void advance() {
    Points<Interval> next = Points<Interval>::Zero(power_.rows(), power_.cols());
    for (Index k = 0; k < power_.rows(); ++k)
      for (Index i = 0; i < power_.cols(); ++i)
        if (!is_zero(power_(k, i)))
          for (const auto& [j, weight] : rows_[static_cast<std::size_t>(i)]) next(k, j) += power_(k, i) * weight;
    power_ = std::move(next);
    scale_ *= lambda_;
  }

 private:
  Interval lambda_, scale_{1};                                 // lambda^r
  std::vector<std::vector<std::pair<Index, Interval>>> rows_;  // of A
  std::vector<Interval> mean_;
  Points<Interval> power_, projection_;  // rows of A^r and of E L
};

/// K and C. After K powers the norms repeat, at most halved: C serves all r.
void bound_powers(RingConstants& result) {
  constexpr int most_powers = 1000;
  Powers powers(result);
  result.tail = powers.norm();
  while (true) {
    powers.advance();
    ++result.power;
    result.contraction = powers.norm();
    if (result.contraction <= Interval(1) / Interval(2)) return;
    require(result.power < most_powers, "the powers of the subdivision matrix at a vertex do not contract");
    result.tail = max(result.tail, result.contraction);
  }
}

/// The characteristic map is regular and injective, by Bernstein coefficients.
void check_characteristic_map(const SurfaceFacts<Rational>& facts, const Eigenpair& pair) {
  const BernsteinBounds bounds = bernstein_bounds(characteristic_net(facts, pair));
  require(bounds.jacobian > Interval(0) && bounds.half_plane > Interval(0),
          "the characteristic map at a vertex could not be bounded");
}

RingConstants compute(int n) {
  const Interval::Precision precision(ring_precision);
  const SurfaceFacts<Rational> facts = surface_facts<Rational>(schemes::catmull_clark(), n);
  require(facts.local.radius == 4 && facts.local.patch.radius >= 6 && is_bicubic(facts.part.mask),
          "the rows at a vertex are not those of Catmull and Clark");
  RingConstants result;
  result.valence = n;
  result.outer = outer_rows(facts.local.patch);
  result.mean = mean_row(result.outer, n);
  const Points<Interval> m = block(facts.local.enclosed, 4, 1);
  const Eigenpair pair = eigenpair_near(m, proposed_lambda(n));
  check_characteristic_map(facts, pair);
  store_eigenvectors(facts.local.enclosed, m, pair, result);
  // Without a split kappa is small for n = 9 and 10, and negative from n = 11 on.
  bound_ring(result, n < 9 ? 0 : 1);
  require(result.kappa > Interval(0), "the differences of the characteristic ring at a vertex have no positive bound");
  result.difference = difference_norm(result.outer, n, result.splits);
  bound_powers(result);
  return result;
}

}  // namespace

std::shared_ptr<const RingConstants> ring_constants(int valence) {
  if (valence < 3 || valence > largest_ring_valence)
    throw Error(ErrorKind::limit, "E_TOO_LARGE",
                "rings of patches have bounds around vertices of valence 3 to " + std::to_string(largest_ring_valence) +
                    ", not of valence " + std::to_string(valence));
  static std::mutex mutex;
  static std::map<int, std::shared_ptr<const RingConstants>> known;
  const std::scoped_lock lock(mutex);
  std::shared_ptr<const RingConstants>& result = known[valence];
  if (!result) result = std::make_shared<const RingConstants>(compute(valence));
  return result;
}

}  // namespace udcp
