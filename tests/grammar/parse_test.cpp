// What programs and words become: shapes of the tree, not its printing.
#include "grammar/parse.h"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

using namespace udcp::grammar;

namespace {

std::string read(const std::string& name) {
  std::ifstream in(std::string(UDCP_TEST_DATA) + "/grammar/" + name);
  REQUIRE(in.good());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

template <class T>
T node(const ExprPtr& expr) {
  REQUIRE(expr != nullptr);
  REQUIRE(std::holds_alternative<T>(expr->node));
  return std::get<T>(expr->node);
}

template <class T>
T only(const std::string& source) {
  const Program program = parse(source);
  REQUIRE(program.statements.size() == 1);
  REQUIRE(std::holds_alternative<T>(program.statements[0].node));
  return std::get<T>(program.statements[0].node);
}

/// Full brackets around every operation: the tree of an arithmetic expression as text.
std::string tree(const ExprPtr& expr) {
  if (const Number* number = std::get_if<Number>(&expr->node)) return number->text;
  if (const Name* name = std::get_if<Name>(&expr->node)) return name->name;
  if (const Unary* unary = std::get_if<Unary>(&expr->node)) return "(" + unary->op + " " + tree(unary->operand) + ")";
  if (const Conditional* choice = std::get_if<Conditional>(&expr->node)) {
    return "(" + tree(choice->condition) + " ? " + tree(choice->then) + " : " + tree(choice->otherwise) + ")";
  }
  const Binary& binary = node<Binary>(expr);
  return "(" + tree(binary.left) + " " + binary.op + " " + tree(binary.right) + ")";
}

/// A word with one letter an item: groups in ( ), names in < >, and marks for arguments and repeats.
std::string items(const WordExpr& word) {
  std::string result;
  for (const WordItem& item : word.items) {
    if (const AtomItem* atom = std::get_if<AtomItem>(&item.what)) result += atom->letter;
    if (const GroupItem* group = std::get_if<GroupItem>(&item.what)) result += "(" + items(*group->word) + ")";
    if (const NamedItem* named = std::get_if<NamedItem>(&item.what)) result += "<" + named->name + ">";
    if (item.sections) result += "[" + tree(item.sections) + "]";
    for (const Binding& binding : item.bindings) result += "[" + binding.name + "]";
    if (item.star) result += "*";
    if (item.power) result += "^" + tree(item.power);
  }
  return result;
}
std::string word(const std::string& source) { return items(node<WordExpr>(parse_expression(source))); }

SyntaxError error_of(const std::string& source) {
  try {
    static_cast<void>(parse_expression(source));
  } catch (const SyntaxError& error) {
    return error;
  }
  FAIL("no error: " << source);
  return {"", "", {}};
}

}  // namespace

TEST_SUITE_BEGIN("grammar");

TEST_CASE("every program line of the language parses") {
  const std::string text = read("language_programs.udcp");
  CHECK(parse(text).statements.size() == 28);  // 30 lines, of which circle takes three
  std::istringstream lines(text);
  std::string statement, line;
  int count = 0;
  const auto finish = [&] {
    if (statement.empty()) return;
    CAPTURE(statement);
    CHECK(parse(statement).statements.size() == 1);
    ++count;
  };
  while (std::getline(lines, line)) {
    if (!line.empty() && line[0] != ' ') {
      finish();
      statement.clear();
    }
    statement += line + "\n";
  }
  finish();
  CHECK(count == 28);
}

TEST_CASE("words are read item by item") {
  CHECK(word("(UCCP)*") == "(UCCP)*");
  CHECK(word("U C^3 P") == "UC^3P");
  CHECK(word("UC(UCP)*") == "UC(UCP)*");
  CHECK(word("(UD)^3") == "(UD)^3");
  CHECK(word("U[3] C (U D^2)^2") == "U[3]C(UD^2)^2");
  CHECK(word("(UCP[delta = -1/10])^2 (UCP)*") == "(UCP[delta])^2(UCP)*");
  CHECK(word("(U C[ngon = classic] P)*") == "(UC[ngon]P)*");
  CHECK(word("P[delta = 1/2, omega = 1]") == "P[delta][omega]");
  CHECK(word("(U D^m)*") == "(UD^m)*");
  CHECK(word("D^(m+1) C^-1 P") == "D^(m + 1)C^(- 1)P");
  CHECK(word("w^2 U catmull_clark four_point(1/16)") == "<w>^2U<catmull_clark><four_point>");
  CHECK(word("loop[delta = 1] U") == "<loop>[delta]U");
  CHECK(word("(w) U") == "(<w>)U");
  CHECK(word("(w^2)^3 U") == "(<w>^2)^3U");
  CHECK(word("w*") == "<w>*");
  CHECK(word("( U\n C # comment\n P )*") == "(UCP)*");
}

TEST_CASE("a product of atoms is the word from right to left") {
  CHECK(word("P . C . U") == "UCP");
  CHECK(word("P . C^2 . U") == "UC^2P");
  CHECK(word("P.C.U") == "UCP");
  CHECK(word("(P . C . U)*") == "(UCP)*");
  CHECK(word("P . (CC) . w") == "<w>(CC)P");
  CHECK(node<WordExpr>(parse_expression("P . C . U")).written_right_to_left);
  CHECK_FALSE(node<WordExpr>(parse_expression("UCP")).written_right_to_left);
}

TEST_CASE("the specified error codes of words") {
  CHECK(error_of("(U)*C").code == "E_STAR");
  CHECK(error_of("UCP*").code == "E_STAR");
  CHECK(error_of("UCP*").label == "did you mean (UCP)*?");
  CHECK(error_of("C[3]").code == "E_SYNTAX");
  CHECK(error_of("UX").code == "E_SYNTAX");
  CHECK(error_of("U[1]C").code == "E_SYNTAX");
  CHECK(error_of("(UC").code == "E_SYNTAX");
  CHECK(error_of("(UC").incomplete);
  CHECK(error_of("").code == "E_SYNTAX");
  CHECK(error_of("").incomplete);
  CHECK(std::string(error_of("").what()) == "a word or an expression is expected");
  CHECK(std::string(error_of("UC = 3").what()) == "the expression should end here");
  CHECK(error_of("U; C").help == "write one word or expression and nothing after it");
}

TEST_CASE("names and calls and their powers are values until they are used in a word") {
  CHECK(node<Name>(parse_expression("catmull_clark")).name == "catmull_clark");
  CHECK(node<Call>(parse_expression("circle(5)")).arguments.size() == 1);
  CHECK(node<Binary>(parse_expression("circle(5)^6")).op == "^");
  CHECK(node<Binary>(parse_expression("(w)^2")).op == "^");
  const Binary& rounds = node<Binary>(parse_expression("((UCP)*)^4"));
  CHECK(items(node<WordExpr>(rounds.left)) == "(UCP)*");
  CHECK(tree(rounds.right) == "4");
  CHECK(items(node<WordExpr>(node<Binary>(parse_expression("(UCP)*^4")).left)) == "(UCP)*");
  CHECK(node<Binary>(parse_expression("(a)*(b)")).op == "*");
  CHECK(node<Binary>(parse_expression("3*(a+b)")).op == "*");
  CHECK(items(node<WordExpr>(parse_expression("((UCP))"))) == "UCP");
}

TEST_CASE("operators have the usual precedences") {
  const auto shape = [](const std::string& source) { return tree(parse_expression(source)); };
  CHECK(shape("-2^2") == "(- (2 ^ 2))");
  CHECK(shape("2^-3") == "(2 ^ (- 3))");
  CHECK(shape("2^3^2") == "(2 ^ (3 ^ 2))");
  CHECK(shape("2^-3^2*4") == "((2 ^ (- (3 ^ 2))) * 4)");
  CHECK(shape("a - b - c") == "((a - b) - c)");
  CHECK(shape("a/b*c") == "((a / b) * c)");
  CHECK(shape("a + b*c^d") == "(a + (b * (c ^ d)))");
  CHECK(shape("-a*b") == "((- a) * b)");
  CHECK(shape("a - -b") == "(a - (- b))");
  CHECK(shape("not a == b and c or d") == "(((not (a == b)) and c) or d)");
  CHECK(shape("a + 1 <= b*2") == "((a + 1) <= (b * 2))");
  CHECK(shape("(a + b)*c") == "((a + b) * c)");
  CHECK(shape("1 + if a < b then c else d + e") == "(1 + ((a < b) ? c : (d + e)))");
  CHECK(shape("a and b == c or not d") == "((a and (b == c)) or (not d))");
}

TEST_CASE("numbers stay text and texts lose their escapes") {
  CHECK(node<Number>(parse_expression("0.8")).text == "0.8");
  CHECK(node<Number>(parse_expression("12e-3")).text == "12e-3");
  CHECK(node<Number>(parse_expression("0")).text == "0");
  CHECK(node<Text>(parse_expression(R"("a\"b\\c\n\t{d} ω")")).raw == "a\"b\\c\n\t{d} ω");
}

TEST_CASE("Greek letters are the spelled-out names") {
  for (const auto& [greek, name] : {std::pair{"ω", "omega"}, {"δ", "delta"}, {"α", "alpha"}, {"α0", "alpha0"}, {"π", "pi"}}) {
    CHECK(node<Name>(parse_expression(greek)).name == name);
  }
  const WordExpr& bound = node<WordExpr>(parse_expression("(UCP)* where ω(α) = 1/cos(α/2), α0@lat = 2*π/5"));
  CHECK(bound.where[0].name == "omega");
  CHECK(bound.where[0].parameter == "alpha");
  CHECK(bound.where[1].name == "alpha0");
  CHECK(bound.where[1].direction == "lat");
}

TEST_CASE("bindings have names and directions and parameters") {
  const WordExpr& pipe =
      node<WordExpr>(parse_expression("(UCP)* on triangles where {f@lat(alpha) = 1, omega@face = 2,\n rings = lat}"));
  CHECK(pipe.on_triangles);
  REQUIRE(pipe.where.size() == 3);
  CHECK(pipe.where[0].name == "f");
  CHECK(pipe.where[0].direction == "lat");
  CHECK(pipe.where[0].parameter == "alpha");
  CHECK(pipe.where[1].direction == "face");
  CHECK(node<Name>(pipe.where[2].value).name == "lat");
  CHECK(items(node<WordExpr>(parse_expression("catmull_clark where omega = 1"))) == "<catmull_clark>");
  CHECK(items(node<WordExpr>(parse_expression("(UCP where delta = 1/2)^2 (UCP)*"))) == "(UCP)^2(UCP)*");
}

TEST_CASE("values have methods and attributes and indices") {
  const Index& index = node<Index>(parse_expression("mesh.points(0, side = left)[2]"));
  const Method& method = node<Method>(index.object);
  CHECK(method.name == "points");
  CHECK(node<Name>(method.object).name == "mesh");
  CHECK(method.arguments[1].name == "side");
  CHECK(node<Attribute>(parse_expression("v.delta")).name == "delta");
  CHECK(node<List>(parse_expression("[]")).items.empty());
  CHECK(node<List>(parse_expression("[a, [b], 1 .. 2]")).items.size() == 3);
  CHECK(node<Method>(parse_expression("(UC).mask()")).name == "mask");
}

TEST_CASE("definitions and functions") {
  const Define value = only<Define>("x = 1");
  CHECK(value.name == "x");
  CHECK_FALSE(value.is_function);
  const Define function = only<Define>("f(p, q) = p + q");
  CHECK(function.is_function);
  CHECK(function.parameters == std::vector<std::string>{"p", "q"});
  CHECK(only<Define>("f() = 1").is_function);
  CHECK(only<Define>("ω = 1").name == "omega");
}

TEST_CASE("pipes and steps") {
  const Pipe& saved = node<Pipe>(only<Evaluate>("cube() |> catmull_clark^4 |> save \"cube.glb\"").value);
  const Step& save = node<Step>(saved.step);
  CHECK(save.verb == "save");
  CHECK(node<Text>(save.arguments[0].value).raw == "cube.glb");
  CHECK(node<Step>(only<Evaluate>("plot(\"a.svg\", size = 3)").value).arguments[1].name == "size");
  CHECK(node<Step>(node<Pipe>(only<Evaluate>("x |> print").value).step).arguments.empty());
  const Pipe& bound = node<Pipe>(only<Evaluate>("a |> (UCP)* where f = 1, delta = 2 |> b").value);
  CHECK(node<Name>(bound.step).name == "b");
  CHECK(node<WordExpr>(node<Pipe>(bound.input).step).where.size() == 2);
}

TEST_CASE("loops hold statements") {
  const Sweep sweep = only<Sweep>("sweep d in 0 .. 1 step 1/4\n{\n print d; x = 2\n\n sweep n in [1, 2] { n } }");
  CHECK(sweep.name == "d");
  CHECK(sweep.body.size() == 3);
  CHECK(node<Range>(sweep.range).step != nullptr);
  const Animate animate = only<Animate>("animate d in 0 .. 1 frames 60 { cube() |> save \"x.glb\" }");
  CHECK(node<Number>(animate.frames).text == "60");
  CHECK(animate.body.size() == 1);
  CHECK(only<Sweep>("sweep n in 1 .. 2 { }").body.empty());
}

TEST_CASE("claims have domains and certificates") {
  const Claim claim = only<Claim>("prove c1(w) for f in (0, oo], N in 3 .. 8, delta in [0, 1], k in [1, 2, 3] -> \"c.json\"");
  CHECK(claim.prove);
  CHECK(claim.certificate == "c.json");
  REQUIRE(claim.domains.size() == 4);
  const Interval& open = node<Interval>(claim.domains[0].set);
  CHECK(open.lower_open);
  CHECK_FALSE(open.upper_open);
  CHECK(node<Name>(open.upper).name == "oo");
  CHECK(claim.domains[1].name == "N");
  CHECK(node<Range>(claim.domains[1].set).step == nullptr);
  CHECK_FALSE(node<Interval>(claim.domains[2].set).lower_open);
  CHECK(node<List>(claim.domains[3].set).items.size() == 3);
  const Claim check = only<Claim>("check a == b");
  CHECK_FALSE(check.prove);
  CHECK(check.domains.empty());
  CHECK_FALSE(check.certificate.has_value());
}

TEST_CASE("the other statements") {
  CHECK(only<Print>("print a, b + 1").values.size() == 2);
  CHECK(node<Binary>(only<Assert>("assert a == b").condition).op == "==");
  CHECK(only<Verify>("verify \"c.json\"").path == "c.json");
  CHECK(only<Use>("use \"a.udcp\"").path == "a.udcp");
  CHECK(only<Set>("set precision = 256").name == "precision");
  CHECK(parse("").statements.empty());
  CHECK(parse("\xEF\xBB\xBFx = 1").statements.size() == 1);
}

TEST_CASE("lines continue in brackets and after operators and before indented where or pipes") {
  CHECK(parse("x = a +\n b").statements.size() == 1);
  CHECK(parse("x =\n\n # why\n b").statements.size() == 1);
  CHECK(parse("f(a,\n\n b)").statements.size() == 1);
  CHECK(parse("print a,\nb").statements.size() == 1);
  CHECK(parse("a\n  |> b\n # between\n  |> c").statements.size() == 1);
  CHECK(parse("w\n\twhere f = 1,\n  g = 2").statements.size() == 1);
  CHECK(parse("x = if a\nthen b\nelse c").statements.size() == 1);
  CHECK(parse("a\r\n  |> b\r\nc\r\n").statements.size() == 2);
  CHECK(parse("(UCP)*\n(UD)*").statements.size() == 2);
  CHECK(parse("w*\n(UD)*").statements.size() == 2);
  CHECK(parse("(UCP) *\nx").statements.size() == 2);
  CHECK(parse("x = a *\n(b)").statements.size() == 1);
  CHECK(parse("x = (a + b)*\n(b)").statements.size() == 1);
  CHECK(parse("a\n  b").statements.size() == 2);
  CHECK(parse("a; b;; c").statements.size() == 3);
  CHECK_THROWS_AS(parse("a\n|> b"), SyntaxError);
}

TEST_CASE("spans are the bytes of a node without its surroundings") {
  const std::string text = "x = a + (b)  # note\n";
  const Program program = parse(text);
  CHECK(program.statements[0].span == Span{0, 11});
  const Define& define = std::get<Define>(program.statements[0].node);
  CHECK(define.value->span == Span{4, 11});
  const Binary& sum = node<Binary>(define.value);
  CHECK(sum.left->span == Span{4, 5});
  CHECK(sum.right->span == Span{8, 11});
  const WordExpr& word_expr = node<WordExpr>(parse_expression("UC^2(UCP)*"));
  CHECK(word_expr.items[1].span == Span{1, 4});
  CHECK(word_expr.items[2].span == Span{4, 10});
}

TEST_CASE("a text is incomplete exactly when it ended too early") {
  for (const char* source : {"(",
                             "f(a,",
                             "[1",
                             "x =",
                             "a +",
                             "print",
                             "print a,",
                             "a |>",
                             "w where",
                             "w where f =",
                             "w where {f = 1",
                             "sweep n in 1 .. 2 {",
                             "sweep n in 1 .. 2 { print n\n",
                             "if a",
                             "if a then b",
                             "x = 3*",
                             "prove c1(w) for",
                             "prove c1(w) ->",
                             "(a # comment\n\n",
                             "C[f = ",
                             "assert",
                             "w on"}) {
    CAPTURE(source);
    try {
      static_cast<void>(parse(source));
      FAIL("no error");
    } catch (const SyntaxError& error) {
      CHECK(error.incomplete);
    }
  }
  for (const char* source : {"(UC $", "f(a]", "\"abc", "x = 08", "UCP*", "a b = 3", "x = )", "2x", "f(a, $", "save", "x = 1e"}) {
    CAPTURE(source);
    try {
      static_cast<void>(parse(source));
      FAIL("no error");
    } catch (const SyntaxError& error) {
      CHECK_FALSE(error.incomplete);
    }
  }
}

TEST_SUITE_END();
