// Names and directions of bindings are checked here; formulas become kernels.
#include "interpreter/bindings.h"

#include <algorithm>

#include "interpreter/formula.h"

namespace udcp {

namespace {

using grammar::Binding;

[[noreturn]] void fail(const Binding& binding, const std::string& message, const std::string& help = {}) {
  throw Located(Error(ErrorKind::word, "E_BINDING", message, help), binding.span);
}

std::string full_name(const Binding& b) { return b.direction.empty() ? b.name : b.name + "@" + b.direction; }

KernelPtr kernel_of(const Binding& binding, CallContext& context) {
  std::string stands_for = binding.name == "delta" ? "N" : "alpha";
  const std::string& p = binding.parameter;
  if (p == "alpha" || p == "N" || p == "h") stands_for = p;
  return make_kernel({binding.value, context.scope, p, stands_for, context.source, context.bounds()});
}

void set_direction(Directional<KernelPtr>& slot, const Binding& binding, CallContext& context) {
  KernelPtr& place = binding.direction == "lat" ? slot.latitude : binding.direction == "lon" ? slot.longitude : slot.plain;
  if (place) fail(binding, "'" + full_name(binding) + "' is bound twice");
  place = kernel_of(binding, context);
}

std::string symbol_of(const Binding& binding, const std::string& choices) {
  if (const auto* name = std::get_if<grammar::Name>(&binding.value->node)) return name->name;
  fail(binding, "'" + binding.name + "' must be one of " + choices);
}

void set_rings(Bindings& to, const Binding& binding) {
  const std::string choices = "lat, lon, both, off";
  const std::string name = symbol_of(binding, choices);
  if (to.has_rings) fail(binding, "'rings' is bound twice");
  to.has_rings = true;
  if (name == "lat")
    to.rings = Rings::latitude;
  else if (name == "lon")
    to.rings = Rings::longitude;
  else if (name == "both")
    to.rings = Rings::both;
  else if (name != "off")
    fail(binding, "'rings' must be one of " + choices + ", not '" + name + "'");
}

void set_ngon(Bindings& to, const Binding& binding) {
  const std::string choices = "classic, dual";
  const std::string name = symbol_of(binding, choices);
  if (to.has_ngon) fail(binding, "'ngon' is bound twice");
  to.has_ngon = true;
  if (name == "classic")
    to.ngon = Ngon::classic;
  else if (name != "dual")
    fail(binding, "'ngon' must be one of " + choices + ", not '" + name + "'");
}

void set_single(KernelPtr& place, const Binding& binding, CallContext& context) {
  if (place) fail(binding, "'" + full_name(binding) + "' is bound twice");
  place = kernel_of(binding, context);
}

void check_direction(const Binding& b) {
  const std::string& d = b.direction;
  const bool lat_lon = b.name == "f" || b.name == "omega" || b.name == "alpha0";
  if (d.empty() || (lat_lon && (d == "lat" || d == "lon")) || (b.name == "omega" && d == "face")) return;
  fail(b, "'" + b.name + "' has no direction '" + d + "'", "f, omega and alpha0 take @lat and @lon; omega also takes @face");
}

void read_one(Bindings& to, const Binding& b, CallContext& context) {
  static const std::vector<std::string> known = {"f", "omega", "delta", "alpha0", "rings", "ngon"};
  if (std::find(known.begin(), known.end(), b.name) == known.end()) {
    const std::string guess = did_you_mean(b.name, known);
    fail(b, "a word has no parameter '" + b.name + "'",
         guess.empty() ? "the parameters are f, omega, delta, alpha0 and rings" : guess);
  }
  check_direction(b);
  if (b.name == "rings" || b.name == "ngon") {
    if (!b.parameter.empty()) fail(b, "'" + b.name + "' is a choice, not a function");
    return b.name == "rings" ? set_rings(to, b) : set_ngon(to, b);
  }
  if (b.name == "f") set_direction(to.f, b, context);
  if (b.name == "alpha0") set_direction(to.alpha0, b, context);
  if (b.name == "delta") set_single(to.delta, b, context);
  if (b.name == "omega" && b.direction == "face") return set_single(to.omega_face, b, context);
  if (b.name == "omega") set_direction(to.omega, b, context);
}

}  // namespace

Bindings read_bindings(const std::vector<Binding>& bindings, CallContext& context) {
  Bindings result;
  for (const Binding& b : bindings) {
    read_one(result, b, context);
    const auto same_name = [&](const auto& written) { return written.first == b.name; };
    if (std::none_of(result.written.begin(), result.written.end(), same_name)) result.written.emplace_back(b.name, b.span);
  }
  return result;
}

bool is_bound(const Directional<KernelPtr>& slot) { return slot.plain || slot.latitude || slot.longitude; }

bool fill(Directional<KernelPtr>& to, const Directional<KernelPtr>& from) {
  if (to.plain || !is_bound(from)) return false;
  bool filled = false;
  const auto one = [&](KernelPtr& place, const KernelPtr& value) {
    if (place || !value) return;
    place = value;
    filled = true;
  };
  one(to.plain, from.plain);
  one(to.latitude, from.latitude);
  one(to.longitude, from.longitude);
  return filled;
}

void fill(Item& item, const Bindings& from, std::set<std::string>& used) {
  if (item.atom == Atom::average || item.atom == Atom::convolve) {
    if (fill(item.f, from.f)) used.insert("f");
  }
  if (item.atom != Atom::push_back) return;
  if (fill(item.omega, from.omega)) used.insert("omega");
  const auto single = [&](KernelPtr& place, const KernelPtr& value, const char* name) {
    if (place || !value) return;
    place = value;
    used.insert(name);
  };
  single(item.omega_face, from.omega_face, "omega");
  single(item.delta, from.delta, "delta");
}

void spread(Directional<KernelPtr>& slot) {
  if (!slot.latitude) slot.latitude = slot.plain;
  if (!slot.longitude) slot.longitude = slot.plain;
}

}  // namespace udcp
