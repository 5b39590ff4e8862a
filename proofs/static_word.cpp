// Static limits of words, and words as data of certificates.
#include "proofs/static_word.h"

#include <algorithm>
#include <set>
#include <variant>

#include "proofs/closed_form.h"

namespace udcp {
namespace {

/// A kernel at alpha = 0 in the first round.
class AtZero final : public Kernel {
 public:
  explicit AtZero(KernelPtr kernel) : kernel_(std::move(kernel)) {}
  [[nodiscard]] Needs needs() const override {
    Needs needs = kernel_->needs();
    needs.round = false;
    return needs;
  }
#define UDCP_KERNEL_AT(S)                                                  \
  [[nodiscard]] Quantity<S> at(const Context<S>& context) const override { \
    Context<S> zero = context;                                             \
    zero.alpha = Quantity<S>();                                            \
    zero.round = 0;                                                        \
    return kernel_->at(zero);                                              \
  }
  UDCP_FOR_EACH_NUMBER(UDCP_KERNEL_AT)
#undef UDCP_KERNEL_AT

 private:
  KernelPtr kernel_;
};

/// A function of alpha, as closed_form.h writes it.
struct FormulaOfAlpha {
  std::string text;
  friend bool operator==(const FormulaOfAlpha&, const FormulaOfAlpha&) = default;
};

/// A parameter as certificates have it: exact, a function of the parameters of the claim, or a function of alpha.
using ParameterValue = std::variant<Algebraic, Parametric, FormulaOfAlpha>;

Json to_json(const ParameterValue& value) {
  if (const auto* formula = std::get_if<FormulaOfAlpha>(&value)) return {{"formula", formula->text}};
  if (const auto* exact = std::get_if<Algebraic>(&value)) return udcp::to_json(*exact);
  return udcp::to_json(std::get<Parametric>(value));
}

ParameterValue value_from(const Json& json, const std::string& where) {
  if (json.is_object() && json.contains("formula")) {
    require_entries(json, {"formula"}, where);
    require(json["formula"].is_string(), where + ".formula must be a text");
    FormulaOfAlpha formula{json["formula"].get<std::string>()};
    try {
      require(kernel_from(formula.text)->closed_form() == formula.text, where + ".formula is not in normal form");
    } catch (const Error& error) {
      throw Rejected(where + ".formula: " + error.what());
    }
    return formula;
  }
  if (json.is_object() && json.contains("names")) return parametric_from(json, where);
  return algebraic_from(json, where);
}

template <class S>
Quantity<S> quantity_of(const ParameterValue& value) {
  if (const auto* exact = std::get_if<Algebraic>(&value))
    return exact->is_rational() ? Quantity<S>(exact->rational()) : Quantity<S>::of(number<S>(*exact));
  if constexpr (std::is_same_v<S, Parametric>) {
    return Quantity<S>::of(std::get<Parametric>(value));
  } else {
    throw Error(ErrorKind::not_exact, "E_PARAMETER",
                "the value depends on the parameters of a claim: " + std::get<Parametric>(value).to_string().substr(0, 200),
                "give the parameters values");
  }
}

bool depends_on_alpha(const ParameterValue& value) { return std::holds_alternative<FormulaOfAlpha>(value); }

/// delta from a certificate: a value per listed valence.
KernelPtr table(const std::map<int, ParameterValue>& values) {
  return formula(
      [values](const auto& c) {
        using S = std::decay_t<decltype(c.alpha.value())>;
        const auto found = values.find(c.valence);
        if (found == values.end())
          throw Error(ErrorKind::word, "E_NO_STATIC_LIMIT",
                      "delta has no value at valence " + std::to_string(c.valence) + " in the certificate");
        if (const auto* formula = std::get_if<FormulaOfAlpha>(&found->second)) return kernel_from(formula->text)->at(c);
        return quantity_of<S>(found->second);
      },
      Needs{true, false, std::any_of(values.begin(), values.end(), [](const auto& v) { return depends_on_alpha(v.second); })});
}

KernelPtr constant_of(const ParameterValue& value) {
  if (const auto* formula = std::get_if<FormulaOfAlpha>(&value)) return kernel_from(formula->text);
  return formula([value](const auto& c) { return quantity_of<std::decay_t<decltype(c.alpha.value())>>(value); },
                 Needs{false, false, false});
}

ParameterValue value_at(const KernelPtr& kernel, int valence) {
  if (!kernel) return Algebraic(1);
  if (kernel->needs().round) {
    if (!kernel->closed_form().empty()) return FormulaOfAlpha{kernel->closed_form()};
    throw Error(ErrorKind::not_exact, "E_NO_CLOSED_FORM", "a parameter is a function of alpha that cannot be written down",
                "write it with + - * / ^ sqrt cos sin tan exp log abs min max, without `if`");
  }
  try {
    return kernel->at(Context<Algebraic>{{}, valence, 0, -1, nullptr}).value();
  } catch (const Error& error) {
    if (error.kind != ErrorKind::not_exact) throw;
    try {
      return kernel->at(Context<Parametric>{{}, valence, 0, -1, nullptr}).value();
    } catch (const Error&) {
      throw error;
    }
  }
}

ParameterValue constant_value(const KernelPtr& kernel, const std::vector<int>& valences) {
  const ParameterValue value = value_at(kernel, valences.front());
  for (const int n : valences) {
    if (value_at(kernel, n) != value)
      throw Error(ErrorKind::word, "E_F_BY_VALENCE", "f or omega depends on the valence N; only delta may in proofs",
                  "give f and omega the same value at every valence");
  }
  return value;
}

KernelPtr at_zero(const KernelPtr& kernel) {
  if (!kernel) return nullptr;
  const Needs needs = kernel->needs();
  if (needs.vertex)
    throw Error(ErrorKind::word, "E_MASK_VARIES",
                "the word has parameters that differ from point to point (v.name or noise), so it has no static limit",
                "a proof needs parameters that depend on alpha, and delta on N, only");
  if (needs.level)
    throw Error(ErrorKind::word, "E_NO_STATIC_LIMIT",
                "a parameter depends on h, so it is not known whether the word has a static limit",
                "write the parameter as a function of alpha");
  return std::make_shared<AtZero>(kernel);
}

Item frozen(const Item& item) {
  Item result = item;
  const auto all = [](const Directional<KernelPtr>& k) {
    return Directional<KernelPtr>{at_zero(k.plain), at_zero(k.latitude), at_zero(k.longitude)};
  };
  result.f = all(item.f);
  result.omega = all(item.omega);
  result.omega_face = at_zero(item.omega_face);
  result.delta = at_zero(item.delta);
  return result;
}

/// Which items of a round average with a kernel: the first D or C after U, and those that say so themselves.
std::vector<bool> kernel_acts(const std::vector<Item>& items) {
  std::vector<bool> result;
  bool fresh = false;
  int averages = 0;
  for (const Item& item : items) {
    const bool averages_here = item.atom == Atom::average || item.atom == Atom::convolve;
    if (item.atom == Atom::up) {
      fresh = true;
      averages = 0;
    }
    result.push_back(averages_here && fresh && averages % 2 == 0 && (averages == 0 || item.f_everywhere));
    if (averages_here) averages += item.atom == Atom::convolve ? 2 : 1;
  }
  return result;
}

Json item_to_json(const Item& item, bool with_kernel, const std::vector<int>& valences) {
  Json result = {{"atom", std::string(1, static_cast<char>(item.atom))}};
  switch (item.atom) {
    case Atom::up:
      result["sections"] = item.sections;
      break;
    case Atom::average:
    case Atom::convolve:
      result["f"] = to_json(with_kernel ? constant_value(item.f.plain, valences) : ParameterValue(Algebraic(1)));
      if (item.atom == Atom::convolve) result["ngon"] = item.ngon == Ngon::classic ? "classic" : "dual";
      break;
    case Atom::push_back: {
      result["omega"] = to_json(constant_value(item.omega.plain, valences));
      result["omega_face"] = item.omega_face ? to_json(constant_value(item.omega_face, valences)) : Json(nullptr);
      Json delta = Json::object();
      for (const int n : valences) delta[std::to_string(n)] = to_json(value_at(item.delta, n));
      result["delta"] = std::move(delta);
      break;
    }
  }
  return result;
}

Item item_from(const Json& json, const std::string& where) {
  const Json& atom = entry(json, "atom");
  require(atom.is_string() && atom.get<std::string>().size() == 1, where + ".atom must be one letter");
  Item item;
  switch (atom.get<std::string>().front()) {
    case 'U':
      require_entries(json, {"atom", "sections"}, where);
      item.atom = Atom::up;
      item.sections = integer_from(entry(json, "sections"), 2, 1000, where + ".sections");
      return item;
    case 'D':
      require_entries(json, {"atom", "f"}, where);
      item.atom = Atom::average;
      break;
    case 'C': {
      require_entries(json, {"atom", "f", "ngon"}, where);
      item.atom = Atom::convolve;
      const Json& ngon = entry(json, "ngon");
      require(ngon == "dual" || ngon == "classic", where + ".ngon must be \"dual\" or \"classic\"");
      item.ngon = ngon == "classic" ? Ngon::classic : Ngon::dual;
      break;
    }
    case 'P': {
      require_entries(json, {"atom", "omega", "omega_face", "delta"}, where);
      item.atom = Atom::push_back;
      item.omega = Directional<KernelPtr>::all(constant_of(value_from(entry(json, "omega"), where + ".omega")));
      if (!entry(json, "omega_face").is_null())
        item.omega_face = constant_of(value_from(entry(json, "omega_face"), where + ".omega_face"));
      std::map<int, ParameterValue> delta;
      require(entry(json, "delta").is_object() && !entry(json, "delta").empty(), where + ".delta must map valences to numbers");
      for (const auto& [valence, value] : entry(json, "delta").items()) {
        require(!valence.empty() && valence.size() < 7 && valence.find_first_not_of("0123456789") == std::string::npos &&
                    valence.front() != '0',
                where + ".delta has an entry that is no valence");
        delta[std::stoi(valence)] = value_from(value, where + ".delta." + valence);
      }
      item.delta = table(delta);
      return item;
    }
    default:
      throw Rejected(where + ".atom must be U, D, C or P");
  }
  item.f = Directional<KernelPtr>::all(constant_of(value_from(entry(json, "f"), where + ".f")));
  item.f_everywhere = entry(json, "f") != "1";
  return item;
}

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.contains("formula")) return value["formula"].get<std::string>();
  if (value.contains("names")) return parametric_from(value, "a parameter").to_string();
  return algebraic_from(value, "a parameter").to_string();
}

}  // namespace

bool is_static(const Word& word) {
  const auto fixed = [](const KernelPtr& kernel) {
    return !kernel || !(kernel->needs().round || kernel->needs().vertex || kernel->needs().level);
  };
  return std::all_of(word.tail.begin(), word.tail.end(), [&](const Item& item) {
    const bool with_f = item.atom == Atom::average || item.atom == Atom::convolve;
    return !(with_f && !fixed(item.f.plain)) &&
           (item.atom != Atom::push_back || (fixed(item.omega.plain) && fixed(item.omega_face) && fixed(item.delta)));
  });
}

Word static_limit(const Word& word) {
  if (!word.is_scheme())
    throw Error(ErrorKind::word, "E_NOT_A_SCHEME", "a finite operator has no limit", "write (...)* for a scheme");
  // f acts on the first average after a U of the same run: before the first U a later round differs from the first one.
  if (word.tail.front().atom != Atom::up)
    throw Error(ErrorKind::word, "E_NO_STATIC_LIMIT", "proofs speak of rounds that begin with U, and this one does not",
                "write what stands before the first U into the prefix and to the end of the round: (C U)* is C (U C)*");
  Word result;
  result.triangles = word.triangles;
  result.rings = word.rings;
  for (const Item& item : word.tail) result.tail.push_back(frozen(item));
  return result;
}

Word with_symbols(const Word& word) {
  (void)static_limit(word);
  int level = 0;
  const auto replaced = [&](const KernelPtr& kernel) -> KernelPtr {
    if (!kernel || !kernel->needs().round) return kernel;
    const std::string text = kernel->closed_form();
    if (text.empty() || kernel->needs().valence)
      throw Error(ErrorKind::not_exact, "E_NO_CLOSED_FORM", "a parameter is a function of alpha that cannot be written down",
                  "write it with + - * / ^ sqrt cos sin tan exp log abs min max, without `if`");
    return udcp::symbol("p" + digest(text) + "_" + std::to_string(level));
  };
  Word result;
  result.triangles = word.triangles;
  result.tail = word.tail;
  for (Item& item : result.tail) {
    if (item.atom == Atom::up) ++level;
    for (Directional<KernelPtr>* slot : {&item.f, &item.omega}) *slot = Directional<KernelPtr>::all(replaced(slot->plain));
    item.omega_face = replaced(item.omega_face);
    item.delta = replaced(item.delta);
  }
  return result;
}

Json to_json(const Word& word, const std::vector<int>& valences) {
  Json items = Json::array();
  const std::vector<bool> acts = kernel_acts(word.tail);
  for (std::size_t k = 0; k < word.tail.size(); ++k) items.push_back(item_to_json(word.tail[k], acts[k], valences));
  return {{"triangles", word.triangles}, {"items", std::move(items)}};
}

Word word_from(const Json& json) {
  Word word = word_with_formulas_from(json);
  require(is_static(word), "the word of this certificate must have constant parameters");
  return word;
}

Word word_with_formulas_from(const Json& json) {
  require_entries(json, {"triangles", "items"}, "the word");
  require(entry(json, "triangles").is_boolean(), "word.triangles must be true or false");
  require(entry(json, "items").is_array() && !entry(json, "items").empty() && entry(json, "items").size() <= 200,
          "word.items must be a list of 1 to 200 items");
  Word result;
  result.triangles = json["triangles"].get<bool>();
  for (const Json& item : json["items"])
    result.tail.push_back(item_from(item, "word.items[" + std::to_string(result.tail.size()) + "]"));
  require(result.tail.front().atom == Atom::up, "the word of a certificate begins with U");
  try {
    validate(result);
  } catch (const Error& error) {
    throw Rejected(std::string("the word of the certificate: ") + error.what());
  }
  return result;
}

std::string describe(const Json& word) {
  // One U and one P: the parameters stand behind; otherwise, and for a kernel that is not the first, at their atoms.
  int splits = 0, pushes = 0;
  for (const Json& item : entry(word, "items")) {
    if (entry(item, "atom") == "U") ++splits;
    if (item["atom"] == "P") ++pushes;
  }
  std::string atoms, parameters;
  int averages = 0;
  for (const Json& item : word["items"]) {
    const auto atom = entry(item, "atom").get<std::string>();
    std::string own;
    const auto say = [&](bool behind, const std::string& text) {
      std::string& list = behind ? parameters : own;
      list += (list.empty() ? "" : ", ") + text;
    };
    if (atom == "U" && entry(item, "sections") != 2) own = std::to_string(entry(item, "sections").get<int>());
    if (item.contains("ngon") && item["ngon"] == "classic") own = "ngon = classic";
    if (item.contains("f") && item["f"] != "1") say(splits == 1 && averages == 0, "f = " + text_of(item["f"]));
    if (atom == "C" || atom == "D") ++averages;
    if (atom == "P") {
      const bool behind = pushes == 1;
      say(behind, "omega = " + text_of(entry(item, "omega")));
      if (!entry(item, "omega_face").is_null()) say(behind, "omega@face = " + text_of(item["omega_face"]));
      std::set<std::string> values;
      for (const auto& [valence, value] : entry(item, "delta").items()) values.insert(text_of(value));
      if (values.size() == 1) {
        say(behind, "delta = " + *values.begin());
      } else {
        for (const auto& [valence, value] : item["delta"].items()) say(behind, "delta(" + valence + ") = " + text_of(value));
      }
    }
    atoms += (atoms.empty() ? "" : " ") + atom + (own.empty() ? "" : "[" + own + "]");
  }
  return "(" + atoms + ")*" + (entry(word, "triangles").get<bool>() ? " on triangles" : "") +
         (parameters.empty() ? "" : " where " + parameters);
}

}  // namespace udcp
