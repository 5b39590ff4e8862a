// counts(cube() |> catmull_clark^10): the sizes of a result from the word and the input alone.
#pragma once

#include "interpreter/builtins.h"
#include "interpreter/expressions.h"

namespace udcp {

Value counts_of_value(CallContext&, const Arguments&);
/// The argument unevaluated: words in its pipe are counted through, everything else is evaluated.
Value counts_of_expression(CallContext&, const grammar::Call&);

}  // namespace udcp
