// The one table of builtins, sorted by name.
#include "interpreter/builtins.h"

#include <algorithm>

namespace udcp {

std::span<const Builtin> builtins() {
  static const std::vector<Builtin> table = [] {
    std::vector<Builtin> all;
    for (const auto& part :
         {builtins_geometry(), builtins_shapes(), builtins_words(), builtins_files(), builtins_math(), builtins_symbols(),
          builtins_regularity(), builtins_interpolation(), builtins_filling(), builtins_offset(), builtins_proofs()})
      all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end(), [](const Builtin& a, const Builtin& b) { return a.name < b.name; });
    return all;
  }();
  return table;
}

const Builtin* find_builtin(std::string_view name) {
  const auto table = builtins();
  const auto found =
      std::lower_bound(table.begin(), table.end(), name, [](const Builtin& b, std::string_view n) { return b.name < n; });
  return found != table.end() && found->name == name ? &*found : nullptr;
}

}  // namespace udcp
