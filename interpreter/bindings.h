// The bindings of a `where` or of an argument list, closed over their formulas, and what they do to items. words.cpp is the only
// user.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "interpreter/expressions.h"

namespace udcp {

/// Parameters as bound in one place; a null kernel is open.
struct Bindings {
  Directional<KernelPtr> f, omega, alpha0;
  KernelPtr omega_face, delta;
  Rings rings = Rings::off;
  bool has_rings = false;
  Ngon ngon = Ngon::dual;
  bool has_ngon = false;
  std::vector<std::pair<std::string, grammar::Span>> written;  // "f", "omega", … once each, where they stand
};

/// Throws Located: E_BINDING for an unknown name, a wrong direction or a double binding; what make_kernel throws.
Bindings read_bindings(const std::vector<grammar::Binding>&, CallContext&);

bool is_bound(const Directional<KernelPtr>&);
/// Fills what `to` leaves open from `from`; true if something was open. A plain value serves all directions.
bool fill(Directional<KernelPtr>& to, const Directional<KernelPtr>& from);
/// Fills one item; adds the names that found an open place to `used`.
void fill(Item& item, const Bindings& from, std::set<std::string>& used);
/// A direction without its own formula gets the plain one.
void spread(Directional<KernelPtr>&);

}  // namespace udcp
