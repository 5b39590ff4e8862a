// Functions of the language that look at a word through proofs/: exponents, eigenvalues, characteristic maps, regions, reports.
#pragma once

#include "interpreter/builtins.h"
#include "interpreter/expressions.h"

namespace udcp {

Value show_holder(CallContext&, const Arguments&);
Value show_eigen(CallContext&, const Arguments&);
Value show_jordan(CallContext&, const Arguments&);
Value show_charmap(CallContext&, const Arguments&);
Value show_spectrum(CallContext&, const Arguments&);
Value show_region(CallContext&, const grammar::Call&);
Value show_report(CallContext&, const Arguments&);
Value show_identity(CallContext&, const Arguments&);
Value show_normal_form(CallContext&, const Arguments&);
Value show_basic_function(CallContext&, const Arguments&);
Value show_diagram(CallContext&, const Arguments&);
Value show_difference_schemes(CallContext&, const Arguments&);

}  // namespace udcp
