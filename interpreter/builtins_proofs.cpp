// Claims as functions (a bare c1(w) decides too), what they measure.
#include "interpreter/builtins.h"

#include "interpreter/analysis.h"
#include "interpreter/claims.h"
#include "interpreter/statements.h"

namespace udcp {

std::vector<Builtin> builtins_proofs() {
  return {
      {"converges", "converges(word)", "Claim: the scheme converges to continuous limits.", 1, 1, {"N"}, claim_converges},
      {"c1", "c1(word, N = valence)", "Claim: limits are C^1, on curves or at vertices of valence N.", 1, 1, {"N"}, claim_c1},
      {"c", "c(word, k)", "Claim: limits have k continuous derivatives.", 2, 2, {"N"}, claim_c},
      {"equal", "equal(word, word, N = valence)", "Claim: two words make the same points.", 2, 2, {"N"}, claim_equal},
      {"keeps_circles", "keeps_circles(word)", "Claim: regular polygons become circles.", 1, 1, {}, claim_circle},
      {"holder", "holder(word)", "The Hoelder exponent of the limits on curves.", 1, 1, {}, show_holder},
      {"eigen",
       "eigen(word, N = valence or list of them)",
       "Eigenvalues of the subdivision matrix at a vertex, by frequency.",
       1,
       1,
       {"N"},
       show_eigen},
      {"jordan",
       "jordan(word, N = valence)",
       "Jordan blocks of the rational eigenvalues at a vertex, by frequency.",
       1,
       1,
       {"N"},
       show_jordan},
      {"charmap", "charmap(word, N = valence)", "The characteristic map at a vertex; plot draws it.", 1, 1, {"N"}, show_charmap},
      {"spectrum",
       "spectrum(word)",
       "Characteristic polynomials in x and c = cos(2 pi m/N), for all valences.",
       1,
       1,
       {},
       show_spectrum},
      {"region",
       "region(claim, x in a .. b, y in c .. d)",
       "The parameters for which a claim on curves holds.",
       2,
       3,
       {},
       nullptr,
       show_region},
      {"report", "report(word)", "What is known about a word; save \"w.tex\" writes LaTeX.", 1, 1, {}, show_report},
      {"identify", "identify(word)", "The standard schemes that the word equals on curves.", 1, 1, {}, show_identity},
      {"normal_form",
       "normal_form(word)",
       "The atoms of one round with C as D D and idle items left out.",
       1,
       1,
       {},
       show_normal_form},
      {"basic_function",
       "basic_function(word, derivatives = 0)",
       "The limit of a single 1; plot draws it.",
       1,
       2,
       {"derivatives"},
       show_basic_function},
      {"diagram", "diagram(word)", "The mask as bars; plot draws it.", 1, 1, {}, show_diagram},
      {"regular",
       "regular(mesh, word = catmull_clark, mode = bspline | interior, test = T2 | T3 | T4, depth = 6, except = nothing | "
       "boundary, "
       "steps = 2, corners = one_face | tagged)",
       "Claim: the Catmull-Clark surface of a mesh has independent tangents everywhere.",
       1,
       2,
       {"word", "mode", "test", "depth", "except", "steps", "corners"},
       claim_regular},
  };
}

}  // namespace udcp
