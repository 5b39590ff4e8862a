// From the parameters and the reach of a word to rings of faces.
#include "operators/plan/rounds_ahead.h"

#include <algorithm>
#include <cstdint>

#include "operators/matrix.h"

namespace udcp {
namespace {

template <class Holds>
bool any_kernel(const std::vector<Item>& items, Holds holds) {
  for (const Item& item : items)
    for (const KernelPtr& kernel : {item.f.plain, item.f.latitude, item.f.longitude, item.omega.plain, item.omega.latitude,
                                    item.omega.longitude, item.omega_face, item.delta})
      if (kernel && holds(kernel->needs())) return true;
  return false;
}

bool varies_from_point_to_point(const Word& word) {
  for (const KernelPtr& kernel : {word.alpha0.plain, word.alpha0.latitude, word.alpha0.longitude})
    if (kernel && (kernel->needs().vertex || kernel->needs().valence)) return true;
  const auto by_vertex = [](const Needs& needs) { return needs.vertex; };
  return any_kernel(word.head, by_vertex) || any_kernel(word.tail, by_vertex);
}

// A U or the end in the dual state makes a dual mesh.
bool makes_a_dual(const std::vector<Item>& items) {
  bool dual = false;
  for (const Item& item : items) {
    if (item.atom == Atom::up && dual) return true;
    if (item.atom == Atom::average) dual = !dual;
  }
  return dual;
}

// The ring pass reads points up to three steps away on a ring, once per direction and P.
int reach_of_rings(const Word& word) {
  if (word.rings == Rings::off) return 0;
  int pushes = 0;
  for (const Item& item : word.tail) pushes += item.atom == Atom::push_back ? 1 : 0;
  return 3 * pushes * (word.rings == Rings::both ? 2 : 1);
}

// f by valence and rings of edges look at all faces around the outermost points that count, though at no more points.
bool looks_at_rim(const Word& word) {
  if (word.rings != Rings::off) return true;
  for (const Item& item : word.tail)
    for (const KernelPtr& kernel : {item.f.plain, item.f.latitude, item.f.longitude})
      if (kernel && kernel->needs().valence) return true;
  return false;
}

}  // namespace

int RoundsAhead::segments() const {
  std::int64_t segments = 1;
  for (int round = 0; round < rounds; ++round) segments = std::min<std::int64_t>(segments * arity, 1'000'000);
  return static_cast<int>(segments);
}

std::optional<Word> planned_word(const Word& word) {
  if (varies_from_point_to_point(word) || makes_a_dual(word.head) || makes_a_dual(word.tail)) return std::nullopt;
  Word planned = word;
  if (!word.is_scheme()) {
    planned.tail = word.head;
    planned.head.clear();
    try {
      validate(planned);
    } catch (const Error&) {
      return std::nullopt;  // rounds that may stand alone but not follow one another
    }
  }
  if (planned.tail.front().atom != Atom::up) return std::nullopt;  // its P or D would look into the round before
  return planned;
}

RoundsAhead rounds_ahead(const Word& planned, int first_item, int rounds, int last_rings) {
  RoundsAhead ahead{planned, first_item, rounds, arity(planned), std::vector<int>(static_cast<std::size_t>(rounds) + 1)};
  const Reach one = reach_of_round(planned);
  const int reach = std::max(one.high, -one.low) + reach_of_rings(planned), rim = looks_at_rim(planned) ? 1 : 0;
  int values = last_rings;  // rings whose points count
  ahead.rings.back() = last_rings;
  for (int round = rounds - 1; round >= 0; --round) {
    const auto k = static_cast<std::size_t>(round);
    values = (values + reach) / ahead.arity;
    ahead.rings[k] = std::max(values + rim, (ahead.rings[k + 1] + ahead.arity - 1) / ahead.arity);
  }
  return ahead;
}

}  // namespace udcp
