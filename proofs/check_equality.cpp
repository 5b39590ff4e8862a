// The checker of "equality": compares the operators again. There is nothing to search, so it is the comparison itself.
#include "proofs/checkers.h"
#include "proofs/equality.h"

namespace udcp {

std::string check_equality(const Json& data, StopFlag) {
  require_entries(data, {"first", "second", "rounds", "valences"}, "data");
  const Word first = word_from(entry(data, "first")), second = word_from(entry(data, "second"));
  const Json& rounds = entry(data, "rounds");
  require(rounds.is_array() && rounds.size() == 2, "data.rounds must be two integers");
  const RoundsToCompare compared{integer_from(rounds[0], 1, 6, "data.rounds[0]"),
                                 integer_from(rounds[1], 1, 6, "data.rounds[1]")};
  const Json& valences = entry(data, "valences");
  require(valences.is_array() && valences.size() <= 100, "data.valences must be a list of integers");
  std::vector<int> counted;
  for (const Json& n : valences) counted.push_back(integer_from(n, 3, 100, "a valence"));
  for (const auto& [word, json] : {std::pair{&first, &data["first"]}, std::pair{&second, &data["second"]}}) {
    std::vector<int> all = counted;
    all.push_back(first.triangles ? 6 : 4);
    require(to_json(*word, all) == *json, "a word is not in the form that this program writes");
  }
  std::string where = " on curves";
  if (valences.empty()) {
    const std::string difference = equality::difference_on_curves(first, second, compared);
    require(difference.empty(), "the words differ: " + difference);
  } else {
    where = " on meshes around vertices and faces of valence";
    for (const Json& n : valences) {
      const int valence = integer_from(n, 3, 100, "a valence");
      const std::string difference = equality::difference_on_meshes(first, second, compared, valence);
      require(difference.empty(), "the words differ: " + difference);
      where += " " + std::to_string(valence);
    }
  }
  const auto times = [](int n) { return n == 1 ? std::string("one round") : std::to_string(n) + " rounds"; };
  return times(compared.first) + " of " + describe(data["first"]) + " and " + times(compared.second) + " of " +
         describe(data["second"]) + " are the same operator" + where;
}

}  // namespace udcp
