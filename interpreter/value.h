// Values of the language: what a name can stand for and what a line prints.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "grammar/ast.h"
#include "operators/limit.h"
#include "operators/matrix.h"
#include "operators/polyline.h"
#include "operators/quantity.h"
#include "operators/surface.h"
#include "operators/word.h"
#include "proofs/verdict.h"

namespace udcp {

struct PatchSurface;
struct Value;

/// The text that spans point into, kept as long as something made from it lives. `internal`: the prelude, which no diagnostic
/// shows.
struct SourceText {
  std::string name, text;
  bool internal = false;
};
using SourcePtr = std::shared_ptr<const SourceText>;

/// A number: exact where it can be (rational, multiple of pi, algebraic), an enclosure where exactness ends, a double where it
/// was measured on double geometry (never printed as if exact), or a function of the parameters that a claim runs over.
struct NumberValue {
  std::variant<Quantity<Algebraic>, Interval, double, Parametric> value;
};

struct Boolean {
  bool value = false;
};
struct TextValue {
  std::string value;
};
struct ListValue {
  std::vector<Value> items;
};

/// A word with the expression it came from, for printing and for the extras of files.
struct WordValue {
  Word word;
  std::string source;                 // canonical text
  std::vector<std::string> defaults;  // "omega = 1", what the user left open and the word uses
  std::optional<int> rounds = {};     // w^n of a scheme: its head and n rounds
};

/// A shape is exact or double; operations keep the kind, and say not_exact rather than round silently.
struct CurveValue {
  std::variant<Polyline<double>, Polyline<Algebraic>> shape;
  std::shared_ptr<const Polyline<double>> control = nullptr;  // what the first word was applied to, for pictures
};
struct MeshValue {
  std::variant<Surface<double>, Surface<Algebraic>> shape;
  std::string word;                               // what made it, for the extras of files
  std::shared_ptr<const Points<double>> normals;  // limit normals where a limit made it
  std::shared_ptr<const WordValue> scheme{};      // the scheme^n that made it; a GLB gets the limit normals after those rounds
  std::string colour{};                           // an attribute that pictures show unless told otherwise
  bool zero_matters{};                            // of that attribute: values that are not positive are shown in red
  bool control{};                                 // a control mesh of a Loop surface: GLB files show the surface
  std::string isolated{};                         // what load said of vertices without faces, which it dropped
  std::string file{};                             // where the points were read; their decimals are in there
};

struct MatrixValue {
  std::variant<Points<Algebraic>, Points<Interval>, Points<double>> entries;
};

/// User function: parameters and body, closed over the bindings that were in force.
struct Environment;
struct FunctionValue {
  std::string name;
  std::vector<std::string> parameters;
  grammar::ExprPtr body;
  std::shared_ptr<const Environment> scope;
  SourcePtr source = {};
};

/// Masks, stencils, counts, tables, claims: text for people, JSON for programs, and parts that compare exactly.
struct ReportValue {
  std::string text;
  Json json;
  std::vector<Value> parts;                       // what == compares, and what [i] picks
  std::shared_ptr<const Result> claim{};          // of a claim: its verdict and certificate
  std::function<std::string()> picture{};         // SVG, for plot and save; empty: no picture
  std::function<std::string()> latex{};           // a LaTeX document, for save "x.tex"; empty: none
  std::shared_ptr<const PatchSurface> surface{};  // of fill_g2: the patches
};

struct Nothing {};

struct Value {
  std::variant<Nothing, NumberValue, Boolean, TextValue, ListValue, WordValue, CurveValue, MeshValue, MatrixValue, FunctionValue,
               ReportValue>
      data;

  template <class T>
  [[nodiscard]] const T* as() const {
    return std::get_if<T>(&data);
  }
};

/// "number", "word", "curve", "mesh", "matrix", "list", "text", "boolean", "function", "report", "claim", "surface",
/// "nothing".
std::string type_name(const Value&);

/// Names bound to values, with an outer scope. A definition makes a new scope on top of the old one, so whatever closed over the
/// old one (functions, formulas, undo) keeps it at no cost.
struct Environment {
  std::map<std::string, Value> names;
  std::shared_ptr<const Environment> outer;
  bool frame = false;  // parameters of a call: they go before alpha, N and h, other bindings after them

  struct Found {
    const Value* value = nullptr;
    bool in_frame = false;
  };
  [[nodiscard]] Found lookup(const std::string& name) const;
  [[nodiscard]] const Value* find(const std::string& name) const { return lookup(name).value; }
  /// Takes the chain apart in a loop: a program of a million definitions must not overflow the stack at its end.
  ~Environment();
};

}  // namespace udcp
