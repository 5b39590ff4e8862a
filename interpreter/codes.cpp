// The one table of error codes: symbol, printed code, title, and the story of `udcp --explain`. The sentence of an error is made
// where it is thrown; this table knows none. Codes are never reused or renumbered.
#include <algorithm>
#include <array>

#include "interpreter/report.h"

namespace udcp {
namespace {

constexpr CodeEntry table[] = {
    // W: words and their parameters
    {"E_EMPTY", "W01", "a word without atoms", "A word needs at least one of the atoms U, D, C, P."},
    {"E_P_NO_U", "W02", "P without an earlier U",
     "P moves the new points back so that the points before the last U are met again. Without a U there is nothing to go back "
     "to. Words\n"
     "are read from left to right, so UCP starts with U; the same word as a product of operators, right to left, is P . C . U."},
    {"E_P_DUAL", "W03", "P on a dual result",
     "Every D moves the points from the vertices to the middles of edges or faces, and back. P compares the points with the "
     "vertices that\n"
     "the last U had, so it can act only after an even number of D. C counts as two. A repeated word is checked round after "
     "round: in\n"
     "(UDP)* the first round fails already; write (UDDP)* or (UCP)*."},
    {"E_TRI_D", "W04", "D on triangles",
     "D leads from a triangle mesh to its dual, which is no triangle mesh; words `on triangles` consist of U, C and P."},
    {"E_STAR", "W05", "a star in the wrong place",
     "w* repeats w for ever, so nothing can come after it: the star stands on the last group of the whole word. UCP* repeats P "
     "alone and\n"
     "is refused; (UCP)* is meant. A start that differs is written first: (UCP[delta = -1/10])^2 (UCP)*."},
    {"E_SECTIONS", "W06", "a section number out of range",
     "U[d] cuts every edge into d sections, with d from 2 to 1000. U alone is U[2]."},
    {"E_RINGS", "W07", "rings where there can be none",
     "The pass on rings follows the edges tagged lat or lon of a quad mesh, so it needs U[2] and quads: neither U[3] nor `on "
     "triangles`."},
    {"E_CURVE_WORD", "W08", "a word of surfaces on a curve",
     "On curves there are no triangles and no rings. The word can be applied to meshes."},
    {"E_BINDING", "W09", "a binding that fits nothing",
     "After `where` and between [ ] stand f, omega, delta, alpha0 and rings, with @lat, @lon or omega@face where a direction "
     "makes sense,\n"
     "each once. f belongs to D and C, omega and delta to P."},
    {"E_WORD_TOO_LONG", "W10", "a word with too many atoms",
     "Powers are written out; the result may have 100,000 atoms. Rounds of a scheme are not written out: (UCP)*^30 is short."},
    {"E_TRIANGLES_MIX", "W11", "triangles and quads in one word",
     "`on triangles` speaks of the whole word. Words for triangles and for quads cannot be joined."},
    {"E_ATTRIBUTE", "W12", "an attribute that the points do not have",
     "v.name is a number that every point carries. Files bring attributes along, and attribute(shape, \"name\", values) adds "
     "one."},
    {"E_ROUNDS", "W13", "rounds missing or negative",
     "A scheme such as (UCP)* can be repeated for ever, so applying it needs a number of rounds: mesh |> (UCP)*^4, or "
     "limit(mesh, word)."},
    {"E_NO_ROUND", "W14", "a round that the word does not have",
     "A finite operator has round 0 only; a scheme has the rounds 0, 1, 2 and so on."},
    {"E_MASK_VARIES", "W15", "a mask of a word that differs from point to point",
     "A mask describes a rule that is the same at every point. With v.name or noise in a parameter there is none; matrix(...) "
     "still works."},
    {"E_LIMIT_DUAL", "W16", "limit points of a dual word",
     "Limit points belong to vertices, so the scheme must lead from vertices to vertices: an even number of D in each round."},
    {"E_LIMIT_VARIES", "W17", "limit points of a word that varies",
     "Limit points need rules that settle; noise and v.name differ from point to point and round to round."},
    {"E_NO_LIMIT", "W18", "no limit found",
     "The rules of the scheme near a vertex do not settle, or the points do not converge there."},
    {"E_NO_SCHEME", "W19", "a limit of a word that ends", "Only a word that repeats for ever, such as (UCP)*, has a limit."},
    {"E_NOT_A_SCHEME", "W20", "a limit of a word that ends",
     "limit(shape, word) needs a word that repeats for ever, such as (UCP)*."},
    {"E_MASK_NO_ROUND", "W21", "a support without U",
     "Without U a word makes no new points, so there is no basis function and no support."},
    {"E_MATRIX_DUAL", "W22", "a matrix at a vertex of a dual word",
     "The matrix at a vertex maps a neighbourhood to the same neighbourhood; a dual word leaves no vertex there. matrix(word, "
     "points = n)\n"
     "gives the matrix on a closed curve."},
    {"E_MATRIX_RINGS", "W23", "a neighbourhood that does not map to itself",
     "The new points depend on old points outside. Ask for more rings, or for fewer new ones."},
    {"E_NO_STATIC_LIMIT", "W24", "a word without a static limit",
     "Proofs about words with functions of alpha start from the word at alpha = 0. A parameter that depends on h on its own, or "
     "has no "
     "value at\n"
     "alpha = 0, leaves that open; write it as a function of alpha."},
    {"E_F_BY_VALENCE", "W25", "f or omega that depends on the valence",
     "Proofs at extraordinary vertices know one f and one omega; delta may depend on N."},
    {"E_SUM_RULES", "W26", "differences of too high an order",
     "A difference scheme of order k exists if the symbol satisfies k sum rules; sum_rules(word) counts them."},
    {"E_NO_STENCIL", "W27", "a word without a limit stencil",
     "Limit stencils at old points need a primal word with a symmetric mask and a simple eigenvalue."},
    {"E_NO_SPECTRUM", "W28", "a word that the theory of extraordinary points does not cover",
     "It speaks of words with one U[2] per round and constant parameters that may depend on the valence."},
    {"E_NO_CIRCLE", "W29", "a word that keeps no circles",
     "Regular polygons become circles where f(alpha) = cos(alpha/2) and omega(alpha) = 1/cos(alpha/2), as keeps_circles(word) "
     "proves."},

    // S: syntax
    {"E_SYNTAX", "S01", "not a sentence of the language",
     "The text stops making sense at the mark. udcp --help and :help statements show what can be written."},
    {"E_DEPTH", "S02", "nested too deeply", "Brackets and operators may be nested 200 levels deep."},
    {"E_ENCODING", "S03", "text that is not UTF-8", "Programs are UTF-8 text without NUL bytes."},
    {"E_USAGE", "S04", "a mistake in the command line", "udcp --help lists actions and options on one page."},
    {"E_REPL", "S05", "a mistake in a :command", ":help lists the commands of the interactive mode."},
    {"E_LIMIT", "S06", "a program that is too long",
     "A program may have 16 MiB and a million names, numbers, atoms and comments. Large data belongs in files."},

    // E: evaluation
    {"E_NAME", "E01", "an unknown name",
     "Names must be defined before the line that uses them. alpha, N, h and v.name have values only inside the formulas of a "
     "word."},
    {"E_TYPE", "E02", "a value of the wrong kind",
     "The operation or function takes another kind of value. type(x) says what x is."},
    {"E_ARGUMENTS", "E03", "wrong arguments", "The function takes other arguments. :help NAME shows them."},
    {"E_INDEX", "E04", "an index out of range",
     "Items of a list, and vertices of a mesh, are counted from 0; OBJ files count from 1."},
    {"E_RANGE", "E05", "a range that cannot be walked", "first .. last step s needs a step that is not 0."},
    {"E_DIV0", "E06", "division by zero",
     "The divisor is zero, or it is an enclosure that contains zero. More --precision makes enclosures narrower; a guard is "
     "written\n"
     "if x == 0 then ... else 1/x."},
    {"E_SQRT_NEGATIVE", "E07", "the square root of a negative number", "Numbers are real here."},
    {"E_LOG_DOMAIN", "E08", "the logarithm of a number that is not positive", "log(x) is real for x > 0 only."},
    {"E_POWER_NEGATIVE", "E09", "a root of a negative number", "A negative base has real powers with integer exponents only."},
    {"E_NOISE_SEED", "E10", "a noise seed that is no integer",
     "noise(seed) takes an integer; equal seeds give equal noise on every machine."},
    {"E_NUMBER", "E11", "not a number",
     "Numbers are integers, fractions such as 3/4, and decimals such as 0.8 or 1.5e-3; all of them exact."},
    {"E_INTERVAL_ORDER", "E12", "an interval with its ends exchanged", "The smaller end is written first: [0, 1]."},
    {"E_NOT_EXACT", "E13", "no exact value",
     "An exact computation met a number that has no exact form here: a measured (double) value, a multiple of pi among "
     "fractions, a root\n"
     "outside the fields that are known. Nothing is rounded silently; approximate(...) rounds aloud."},
    {"E_UNDECIDED", "E14", "enclosures that cannot decide",
     "Two enclosures overlap, so neither order nor equality is known. More --precision may separate them. A formula in free\n"
     "parameters has no order at all until they have values."},
    {"E_NOT_FINITE", "E15", "a number that is not finite", "A result is infinite, undefined, or beyond the largest double."},
    {"E_PRECISION", "E16", "a precision that does not work",
     "Enclosures have 2 to 1,000,000 bits. Exact numbers that half a million bits cannot tell apart are not compared."},
    {"E_WEIGHT", "E17", "weights that sum to zero",
     "An average divides by the sum of its weights. With f = -1 that sum can be zero; choose f with 1 + f nonzero."},
    {"E_RESERVED", "E18", "a name that belongs to the language",
     "pi, true, sqrt and the like keep their meaning. Choose another name."},
    {"E_SETTING", "E19", "a setting that does not exist or does not fit",
     "The settings are precision, seed, max_faces, max_bytes, threads and quiet."},
    {"E_TEXT", "E20", "a mistake inside a text", "\"{expression}\" in a text is replaced by its value; {{ and }} are braces."},
    {"E_ANIMATE", "E21", "an animation that cannot run",
     "animate d in 0 .. 1 frames 60 { ... } runs through a range of numbers, without step, and not inside another one."},
    {"E_DOMAIN", "E24", "a set that is no domain",
     "After `for` stand N in 3 .. 20, names with intervals such as (0, oo) or [0, 1], and names with integer ranges or lists. "
     "Ends are "
     "rational;\n"
     "an infinite end is open."},
    {"E_NOT_A_CLAIM", "E25", "an expression that claims nothing",
     "Claims are converges(w), c1(w), c(w, k), equal(w, w), keeps_circles(w). assert compares values."},
    {"E_PARAMETER", "E26", "a parameter of a claim where a number is needed",
     "Inside a claim over intervals the parameters have no values: words may use them in rational functions, and nothing else "
     "can."},
    {"E_NO_CLOSED_FORM", "E27", "a function of alpha that a certificate cannot carry",
     "Certificates write functions of alpha out, with + - * / ^ sqrt cos sin tan exp log abs min max and no conditions."},
    {"E_CLOSED_FORM", "E28", "a formula in a certificate that cannot be read", "Formulas in certificates are in prefix form."},
    {"E_NO_REGION", "E29", "a claim that has no region",
     "region(c1(word), x in a .. b) draws where a claim on curves holds; the weights of the word must be rational functions of "
     "the "
     "parameters."},
    {"E_VIEW", "E23", "a view without a direction", "A picture of a mesh needs a view direction that is not zero."},
    {"E_LAMBDA", "E30", "a shape parameter outside its range",
     "Points can be interpolated for 7/20 < lambda <= 1: at 7/20 the system stops being invertible on two-colourable meshes."},
    {"E_ADJUSTABLE_C", "E31", "a parameter of adjustable Catmull-Clark outside its range",
     "c is between 0 and 1: 1/2 is Catmull-Clark, 0 leaves the points where they are (bilinear), 1 pulls furthest away from the "
     "mesh. A "
     "surface\n"
     "that is not refined any more needs c above 0."},
    {"E_FILL_STEPS", "E32", "a number of steps that a fill cannot take",
     "fill_g2 takes 0 to 20 steps; steps = auto takes as few as it needs."},
    {"E_TESSELLATION", "E33", "a tessellation that cannot be made", "Each patch is cut into n x n quads, with n from 1 to 1000."},

    // G: geometry
    {"E_NO_FACES", "G01", "a mesh without faces", "A mesh needs at least one face of three corners."},
    {"E_FACE_SIZE", "G02", "a face with too few corners", "Faces have three corners or more."},
    {"E_FACE_REPEATS", "G03", "a face that repeats a vertex",
     "The corners of a face are different vertices. Split the face where it touches itself."},
    {"E_DUPLICATE_FACE", "G04", "the same face twice", "Two faces have the same vertices. Remove one of them."},
    {"E_EDGE_FACES", "G05", "an edge with more than two faces",
     "Meshes are surfaces: an edge has one face (on the boundary) or two."},
    {"E_ORIENTATION", "G06", "neighbouring faces with opposite orientation",
     "Two faces run along their edge in the same direction. Reverse the corners of one of them."},
    {"E_NOT_ORIENTABLE", "G07", "a surface that is not orientable",
     "No choice of orientations makes all faces agree, as on a Moebius strip. Cut the surface open."},
    {"E_VERTEX_FANS", "G08", "surfaces that touch in a vertex",
     "Several fans of faces meet in one vertex. Give each its own copy of the vertex."},
    {"E_ISOLATED", "G09", "a vertex without faces", "Every vertex of a mesh belongs to a face. Remove the others."},
    {"E_NOT_TRIANGLES", "G10", "a face that is no triangle",
     "Words `on triangles` act on meshes of triangles; triangulate(mesh) makes them."},
    {"E_USPLIT", "G11", "a face that U[d] cannot split",
     "U[d] with d above 2 splits quads only (triangles in words `on triangles`). Apply U once first: it leaves quads."},
    {"E_VALENCE2", "G12", "an interior vertex with two edges",
     "In the dual mesh its face would have two corners. Use an even number of D, or a mesh without such vertices."},
    {"E_CORNER", "G13", "a corner inside a dual mesh",
     "A dual mesh keeps corners on its boundary only. Untag the corner, or use an even number of D."},
    {"E_DIMENSION", "G14", "points with too few or too many coordinates", "Points have one to three coordinates."},
    {"E_POINTS", "G15", "a wrong number of points",
     "A closed curve has at least three points, an open one two; a mesh has a point per vertex."},
    {"E_TAGS", "G16", "tags that do not fit", "There is one tag per edge and one per vertex, or none at all."},
    {"E_ATTRIBUTE_SIZE", "G17", "an attribute that does not fit", "An attribute has one value per vertex."},
    {"E_SHAPE", "G18", "a shape that cannot be made",
     "The standard shapes need sensible sizes, such as three corners for a polygon."},
    {"E_RING_MESH", "G19", "a neighbourhood that cannot be made",
     "Neighbourhoods of a vertex have valence 3 or more, and 1 to 50 rings."},
    {"E_NOT_QUADS", "G20", "a face that is no quad",
     "Regularity of Catmull-Clark surfaces speaks of quad meshes. One step of catmull_clark makes quads of all faces."},
    {"E_NO_PATCH", "G21", "a face that is no regular patch",
     "Difference vectors and their cones belong to quads whose four vertices are regular: inside with four faces, on the "
     "boundary "
     "with two,\n"
     "or a corner with one."},
    {"E_NORMAL", "G22", "a normal that is no direction", "A prescribed normal must be finite and not zero."},
    {"E_NORMALS", "G23", "a wrong number of normals",
     "There is one normal of three numbers per vertex; vertices without one are left out by name."},
    {"E_NOT_CLOSED", "G24", "a mesh that is not closed",
     "The studies of the paper (method = literal, kkt) need closed meshes; two_level takes open ones."},
    {"E_TANGENTS", "G25", "a vertex without a tangent plane",
     "Normals are turned about limit tangents, so these must be independent there."},
    {"E_FILL_ISOLATED", "G26", "a vertex that is not isolated enough to be filled",
     "A fill replaces the quads around a vertex; their other corners must be interior vertices of valence 4. One Catmull-Clark "
     "step "
     "makes it\n"
     "so on meshes of quads, two on others. fill_g2(mesh, steps = auto) takes them."},
    {"E_FILL_BOUNDARY", "G27", "a boundary vertex without patches",
     "Next to a boundary there are patches where a vertex has two faces, or one as a corner. Steps do not change the number of "
     "faces "
     "of a\n"
     "boundary vertex; fill_g2(mesh, leave_out = yes) makes the other patches."},
    {"E_FILL_VALENCE", "G28", "a valence without a fill", "Fills are made for valences 3 to 100, exact proofs for 3 to 10."},
    {"E_FILL_C", "G29", "a parameter near a fill that is not 1/2",
     "The patches of a fill join cubic B-splines, so c must be 1/2 at all points in the two rings of the vertex. Steps with "
     "another c "
     "come\n"
     "first: after a step the surface is taken with c = 1/2."},
    {"E_OFFSET_MESH", "G30", "a mesh that is no offset of another",
     "Both meshes have the same faces, or the second those of the first after some Loop steps, as offset makes them."},
    {"E_CORNER_INSIDE", "G31", "a corner inside a mesh", "Corners of the control mesh of a Loop surface lie on its boundary."},
    {"E_BOUNDARY_VALENCE", "G32", "a boundary vertex without a limit normal",
     "Normals of a Loop surface at its boundary exist for vertices with at least two faces, and at corners."},
    {"E_ZERO_NORMAL", "G33", "a surface without a normal",
     "Both tangents are parallel at the place named, so there is no direction to go. Move the control points around it."},
    {"E_PARAMETER_RANGE", "G34", "parameters outside a face",
     "A point of a face has barycentric parameters u, v >= 0 with u + v <= 1, and a face number of the mesh."},
    {"E_NEEDS_REFINEMENT", "G35", "a boundary too irregular for patches",
     "Bounds on patches need boundary vertices with three faces. Refine with loop^1, or use sampled errors."},
    {"E_NOT_CONTRACTIVE", "G36", "an iteration that need not converge",
     "The local systems of this iteration do not contract on the mesh. solver = direct takes every mesh."},
    {"E_TOLERANCE", "G37", "a tolerance that is none", "A tolerance is a positive finite number, in the unit of the points."},
    {"E_OPTION", "G38", "an option out of range", "The message names the option and its range."},
    {"E_FIT_WEIGHT", "G39", "a weight of a fit out of range", "The weight of the slip is positive and at most 1."},

    // F: files
    {"E_FILE_OPEN", "F01", "a file that cannot be opened", "The file is missing, is a folder, or may not be read or written."},
    {"E_FILE_FORMAT", "F02", "an unknown format",
     "The extension decides: obj, off, ply, stl, glb, gltf for meshes, svg for pictures, mtx and json for matrices."},
    {"E_FILE_SYNTAX", "F03", "a file with a mistake", "The file breaks the rules of its format at the place named."},
    {"E_FILE_NUMBER", "F04", "a bad number in a file", "A coordinate is no number, or is not finite."},
    {"E_FILE_INDEX", "F05", "a bad index in a file",
     "A face names a vertex that is not there. OBJ counts from 1, and from -1 backwards."},
    {"E_FILE_COUNT", "F06", "a file shorter or longer than it says",
     "The header announces another number of elements than the file has."},
    {"E_FILE_EMPTY", "F07", "a file without a mesh", "No faces were found."},
    {"E_FILE_TOO_LARGE", "F08", "a file that is too large", "Files are read whole; the limit is 4 GiB."},
    {"E_NOT_PROGRAM", "F09", "a file that is no program",
     "Programs are text. Meshes are read inside programs by load(\"file\"), or refined by udcp apply."},
    {"E_PROGRAM_SIZE", "F10", "a program that is too long", "Programs may have 16 MiB."},
    {"E_OUTPUT", "F11", "results that cannot be written", "Standard output is closed or its disk is full."},
    {"E_FILE_WRITE", "F12", "a file that cannot be written",
     "The folder is missing or may not be written, or the disk is full. An older file of that name is as it was."},
    {"E_FILE_TAG", "F13", "a tag that marks nothing",
     "Points and lines in the groups corner, lat and lon of an OBJ file mark vertices and edges of the mesh."},
    {"E_FORMAT", "F14", "a format that cannot be written", "The extension decides: obj, off, ply, stl, glb, gltf for meshes."},
    {"E_FLOAT_RANGE", "F15", "coordinates too large for the format",
     "STL and glTF keep single precision, up to 3.4e38. OBJ, OFF and PLY have no such limit."},
    {"E_ANIMATION", "F16", "frames that make no animation",
     "All frames of a file have the same connectivity, and there is at least one."},
    {"E_USE_CYCLE", "F17", "files that use each other in a circle",
     "use reads another program first, so two files cannot use each other."},

    // L: limits
    {"E_MAX_FACES", "L01", "more faces than allowed",
     "The size of a result is computed before any work. Apply fewer rounds, or raise the limit: --max-faces N, or set max_faces "
     "= N."},
    {"E_MAX_MEMORY", "L02", "more memory than allowed",
     "The memory of a result is estimated before any work; the limit is three quarters of what the machine has."},
    {"E_MEMORY", "L03", "memory used up", "The machine has no memory left. Nothing was written; earlier results are intact."},
    {"E_TOO_LARGE", "L04", "something larger than a computation takes",
     "The message names the limit, such as 2^31 - 1 half-edges of a mesh."},
    {"E_COUNT_OVERFLOW", "L05", "counts beyond 2^62",
     "Even the number of elements is too large to be written. Apply fewer rounds."},
    {"E_TOO_MANY_ROUNDS", "L06", "too many rounds", "The rounds make a word of more than 2^31 atoms."},
    {"E_ARITY", "L07", "a round that multiplies too much", "One round of the word makes more than a million points of one."},
    {"E_CALL_DEPTH", "L08", "functions that call each other without end",
     "Calls may be nested 200 deep. A recursive function needs an `if` that ends it."},
    {"E_STEPS", "L09", "a computation that does not end", "A formula may take 20 million steps."},
    {"E_NUMBER_SIZE", "L10", "an exact number that grew too long",
     "Exact numbers grow with every operation. Round earlier with approximate(x), or use smaller exponents."},
    {"E_POWER_SIZE", "L11", "an exponent that is too large", "The power would have millions of digits."},
    {"E_FIELD_DEGREE", "L12", "cosines of too many angles",
     "Exact numbers with cos(2 pi/N) form a field whose degree grows with N; the limit is 192. Enclosures and double have no "
     "such limit."},
    {"E_PARAMETRIC_SIZE", "L13", "a formula in free parameters that grew too large",
     "Words run on symbols for up to 6 parameters, with at most 2000 terms and degree 200 in a numerator or denominator."},
    {"E_SINGULAR", "L14", "a linear system that is nearly singular",
     "Its solution cannot be told from others in the precision at hand. The message says what to change."},
    {"E_OFFSET_LEVELS", "L15", "a tolerance that was not met",
     "The message says what was reached, and where the error is largest. Allow more levels, or a larger tolerance."},
    {"E_NO_CONVERGENCE", "L16", "an iteration that does not converge",
     "The residual grew or stopped falling. solver = direct or cg take every positive definite system."},
    {"E_MAX_HITS", "L17", "too many pairs of faces that meet",
     "The surface meets itself nearly everywhere; take a smaller distance."},
    {"E_MAX_PATCHES", "L18", "a bound that needs too many patches", "Allow a larger bound, or refine the mesh first."},
    {"E_NO_CONE", "L19", "normals that fill no cone",
     "The normals of a face turn too far for a certificate. Refine the mesh first."},

    // Others
    {"E_INTERRUPTED", "I01", "interrupted", "Ctrl-C ended the computation. No file was left half-written."},
    {"E_INTERNAL", "X01", "a mistake inside udcp",
     "This should not happen. Please report it together with the program that led to it. The exit code is 70."},
    {"E_UNKNOWN", "X02", "an error without an entry in this table",
     "The message is right, only its code is missing here. Please report it."},
};

constexpr bool before(const CodeEntry& a, const CodeEntry& b) { return std::string_view(a.code) < std::string_view(b.code); }

constexpr auto sorted_table() {
  auto sorted = std::to_array(table);
  std::sort(sorted.begin(), sorted.end(), before);
  return sorted;
}
constexpr auto sorted = sorted_table();

}  // namespace

std::span<const CodeEntry> codes() { return sorted; }

const CodeEntry* find_code(const std::string& symbol_or_code) {
  const auto found = std::find_if(sorted.begin(), sorted.end(), [&](const CodeEntry& entry) {
    return symbol_or_code == entry.symbol || symbol_or_code == entry.code;
  });
  return found != sorted.end() ? &*found : nullptr;
}

}  // namespace udcp
