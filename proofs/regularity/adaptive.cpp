// The tests T2 to T4 with their witnesses, and the adaptive decision, breadth first.
#include "proofs/regularity/adaptive.h"

#include <algorithm>
#include <map>

#include "proofs/budget.h"
#include "proofs/regularity/cone_tests.h"
#include "proofs/regularity/half_space.h"

namespace udcp {
namespace {

std::optional<RegularityWitness> planar_witness(const std::vector<Vector3>& normals) {
  int sign = 0;
  for (const Vector3& w : normals) {
    const int s = w[2].sign();
    if (s == 0 || (sign != 0 && s != sign)) return std::nullopt;
    sign = s;
  }
  return RegularityWitness{sign, std::nullopt, std::nullopt};
}

struct Live {
  int patch;
  std::string path;
  BicubicNet net;
};

/// Level 0 first: signs are compared with the first one seen in the same group.
class Breadth {
 public:
  Breadth(const std::vector<BicubicNet>& nets, const std::vector<int>& groups, const AdaptiveOptions& options)
      : groups_(groups), options_(options), budget_(options.limits), open_(nets.size(), 0) {
    level_.reserve(nets.size());
    for (std::size_t k = 0; k < nets.size(); ++k) level_.push_back({static_cast<int>(k), {}, nets[k]});
  }

  AdaptiveResult decide() {
    for (int level = 0;; ++level) {
      result_.depth = level;
      if (find_singular_corner()) return std::move(result_);
      result_.out_of_budget = !test_level();
      if (level_.empty()) {
        result_.status = AdaptiveResult::Status::regular;
        return std::move(result_);
      }
      if (result_.out_of_budget || level == options_.depth) return undecided();
      split_level();
    }
  }

 private:
  /// A zero ends it; in the plane so does a sign that differs from the first one seen in the group.
  bool find_singular_corner() {
    for (const Live& live : level_) {
      budget_.check_stop();
      for (int number = 0; number < 4; ++number) {
        const Vector3 normal = corner_normal(live.net, number / 2, number % 2);
        const SingularPoint here = point_of(live, number);
        if (is_zero(normal)) return ends(AdaptiveResult::Status::zero, {here});
        if (!options_.planar) continue;
        const int sign = normal[2].sign();
        const auto [first, fresh] = signs_.try_emplace(groups_[static_cast<std::size_t>(live.patch)], sign, here);
        if (!fresh && first->second.first != sign) return ends(AdaptiveResult::Status::sign, {first->second.second, here});
      }
    }
    return false;
  }

  static SingularPoint point_of(const Live& live, int number) {
    const ParameterSquare square = square_of(live.path);
    return {live.patch, square.u + Rational(number % 2) * square.size, square.v + Rational(number / 2) * square.size};
  }

  bool ends(AdaptiveResult::Status status, std::vector<SingularPoint> witness) {
    result_.status = status;
    result_.witness = std::move(witness);
    return true;
  }

  void report(double share_of_level) {
    if (options_.progress && ++reported_ % 256 == 0) options_.progress((result_.depth + share_of_level) / (options_.depth + 1));
  }

  /// Leaves those that failed, and those that the budget did not reach, in level_.
  bool test_level() {
    std::vector<Live> failed;
    bool within_budget = true;
    const int tested = static_cast<int>(level_.size());
    for (Live& live : level_) {
      report(static_cast<double>(&live - level_.data()) / tested);
      within_budget = within_budget && budget_.spend();
      std::optional<RegularityWitness> witness;
      if (within_budget) witness = find_witness(live.net, options_.test, options_.planar);
      if (witness)
        result_.leaves.push_back({live.patch, live.path, std::move(*witness)});
      else
        failed.push_back(std::move(live));
    }
    level_ = std::move(failed);
    if (within_budget) result_.per_level.emplace_back(tested, tested - static_cast<int>(level_.size()));
    return within_budget;
  }

  void split_level() {
    std::vector<Live> next;
    next.reserve(4 * level_.size());
    for (const Live& live : level_) {
      const std::array<BicubicNet, 4> quarters = children(live.net);
      for (std::size_t k = 0; k < 4; ++k) next.push_back({live.patch, live.path + static_cast<char>('0' + k), quarters[k]});
    }
    level_ = std::move(next);
  }

  AdaptiveResult undecided() {
    for (const Live& live : level_) open_[static_cast<std::size_t>(live.patch)] = 1;
    for (std::size_t k = 0; k < open_.size(); ++k)
      if (open_[k] != 0) result_.open.push_back(static_cast<int>(k));
    return std::move(result_);
  }

  const std::vector<int>& groups_;
  const AdaptiveOptions& options_;
  Budget budget_;
  std::vector<Live> level_;
  std::vector<char> open_;
  std::map<int, std::pair<int, SingularPoint>> signs_;
  AdaptiveResult result_;
  int reported_ = 0;
};

}  // namespace

std::optional<RegularityWitness> separating_pair(const ConeVectors& cones) {
  std::vector<Vector3> both = cones.u;
  both.insert(both.end(), cones.v.begin(), cones.v.end());
  const std::optional<Vector3> m = half_space(both);
  if (!m) return std::nullopt;
  for (std::size_t k = cones.u.size(); k < both.size(); ++k) both[k] = -both[k];
  const std::optional<Vector3> n = half_space(both);
  if (!n) return std::nullopt;
  return RegularityWitness{0, n, m};
}

std::optional<RegularityWitness> find_witness(const BicubicNet& net, RegularityTest test, bool planar) {
  if (test == RegularityTest::t4) {
    const std::optional<std::vector<Vector3>> normals = normal_vectors(net);
    if (!normals) return std::nullopt;
    if (planar) return planar_witness(*normals);
    std::optional<Vector3> n = half_space(*normals);
    if (!n) return std::nullopt;
    return RegularityWitness{0, std::move(n), std::nullopt};
  }
  const std::optional<ConeVectors> cones = cone_vectors(net, test);
  if (!cones) return std::nullopt;
  return planar ? planar_witness(all_determinants(*cones)) : separating_pair(*cones);
}

AdaptiveResult decide_patches(const std::vector<BicubicNet>& nets, const std::vector<int>& groups,
                              const AdaptiveOptions& options) {
  return Breadth(nets, groups, options).decide();
}

}  // namespace udcp
