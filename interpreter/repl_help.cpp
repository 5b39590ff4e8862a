// What the REPL knows to say about the language: :help and the description of a word.
#include <algorithm>
#include <array>

#include "interpreter/builtins.h"
#include "interpreter/expressions.h"
#include "interpreter/repl_loop.h"

namespace udcp {
namespace {

constexpr std::array<ReplCommand, 8> commands{{
    {":help", "[TOPIC]", "this page, or functions, atoms, statements, codes, a function, an error code"},
    {":load", "FILE", "runs a program in this session"},
    {":quit", "", "leaves, as Ctrl-D does"},
    {":save", "FILE", "writes the session as a program"},
    {":set", "[NAME = VALUE]", "changes a setting: precision, max_faces, seed, threads; alone, shows them"},
    {":time", "STATEMENT", "runs it and says how long it took"},
    {":type", "EXPRESSION", "says what kind of value it has"},
    {":undo", "", "takes back the last input that changed a name"},
}};

constexpr const char* atoms_help =
    R"(Words are read from left to right; each letter is an atom.
  U         splits: every edge gets a new point in its middle, every face one at its centre. U[3] makes three sections
  D         averages neighbours: points move to the middles of edges or faces, so the result is dual. D[f = ...]
  C         convolves, the same as D D. C[f = ...], C[ngon = classic] for Catmull-Clark at faces that were no quads
  P         pushes back towards the points before the last U. P[omega = ..., delta = ...]
  (word)*   for ever: a scheme, as in (UCP)*.   word^4   four times
  where     binds parameters: (UCP)* where omega = 1/2, delta(N) = (N-4)/N. Names: f, omega, delta, alpha0, and f@lat, f@lon
  on triangles   takes the triangle version of the atoms)";

constexpr const char* statements_help =
    R"(name = value            name(p, q) = value      value |> step |> step       # comment
print a, b              assert a == b           set precision = 256         use "file.udcp"
sweep d in 0 .. 1 step 1/4 { ... }              animate d in 0 .. 1 frames 60 { ... }
check claim for x in [a, b]                     prove claim for N in 3 .. 8 -> "certificate.json"
verify "certificate.json"
The value of a line that is only an expression is printed; _ is the last one.)";

void add_line(std::string& text, const std::string& line) {
  if (!text.empty()) text += '\n';
  text += line;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

std::string commands_help() {
  std::string text = "Type a statement, or one of";
  for (const ReplCommand& command : commands) {
    text += "\n  " + padded(std::string(command.name) + " " + command.argument, 22) + command.help;
  }
  return text + "\nFor example: cube() |> catmull_clark^3 |> save \"cube.glb\"";
}

std::string functions_help() {
  std::string text;
  for (const Builtin& builtin : builtins()) {
    add_line(text, padded(std::string(builtin.signature), 48) + std::string(builtin.help));
  }
  return text;
}

std::string codes_help() {
  std::string text;
  for (const CodeEntry& entry : codes()) add_line(text, std::string(entry.code) + "  " + entry.title);
  return text;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "none" : text;
}

/// How many points one point becomes; a mask has that order of length.
double growth(const WordValue& word) {
  double product = 1;
  const auto multiply = [&](const std::vector<Item>& items) {
    for (const Item& item : items) product *= item.atom == Atom::up ? item.sections : 1;
  };
  multiply(word.word.head);
  for (int i = 0; i < std::min(word.rounds.value_or(1), 64); ++i) multiply(word.word.tail);
  return product;
}

/// "\n  mask: ..." by the function of that name; nothing for a word that does not act on curves.
std::string property(const char* function, const WordValue& word, Session& session) {
  const Builtin* builtin = find_builtin(function);
  if (builtin == nullptr) return {};
  CallContext context{.settings = session.settings(),
                      .output = session.output(),
                      .stop = std::make_shared<std::atomic<bool>>(false),
                      .folder = {},
                      .scope = std::make_shared<const Environment>(),
                      .source = {}};
  Arguments arguments;
  arguments.positional.push_back(Value{word});
  try {
    const std::string text = to_text(builtin->call(context, arguments));
    return "\n  " + padded(std::string(function) + ":", 10) + text;
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

std::span<const ReplCommand> repl_commands() { return commands; }

std::string help_topic(const std::string& topic) {
  if (topic.empty()) return commands_help();
  if (topic == "functions") return functions_help();
  if (topic == "atoms" || topic == "words") return atoms_help;
  if (topic == "statements") return statements_help;
  if (topic == "codes") return codes_help();
  if (const Builtin* builtin = find_builtin(topic)) return std::string(builtin->signature) + "\n  " + std::string(builtin->help);
  if (const CodeEntry* entry = find_code(topic)) return std::string(entry->code) + ": " + entry->title + "\n" + entry->story;
  for (const ReplCommand& command : commands) {
    if (topic == command.name || ":" + topic == command.name)
      return std::string(command.name) + " " + command.argument + "\n  " + command.help;
  }
  return {};
}

std::string describe_word(const WordValue& word, Session& session) {
  constexpr double longest_mask = 256;
  std::string text =
      word.source + "\n  " + padded("type:", 10) + "word, " + (word.word.is_scheme() ? "a scheme" : "a finite operator");
  if (word.word.triangles) text += " on triangles";
  text += "\n  " + padded("bindings:", 10) + joined(word_bindings(word));
  text += "\n  " + padded("defaults:", 10) + joined(word.defaults);
  if (growth(word) > longest_mask) return text;
  return text + property("mask", word, session) + property("support", word, session);
}

}  // namespace udcp
