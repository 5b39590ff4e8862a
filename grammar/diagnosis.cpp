// Errors name what stands at the place if it explains more than what was expected.
#include "grammar/diagnosis.h"

#include <algorithm>
#include <array>
#include <string>

#include "grammar/source.h"

namespace udcp::grammar {
namespace {

/// Signs of other languages and habits of type-setting: what to write instead.
struct Stray {
  std::string_view sign;
  const char* help;
};
constexpr std::array strays = {
    Stray{"&&", "write and"},
    Stray{"||", "write or"},
    Stray{"!", "write not, and != for unequal"},
    Stray{"**", "write ^ for a power"},
    Stray{"'", "a text stands in double quotes"},
    Stray{"“", "a text stands in straight double quotes"},
    Stray{"”", "a text stands in straight double quotes"},
    Stray{"→", "write ->"},
    Stray{"−", "write - for minus"},
    Stray{"–", "write - for minus"},
    Stray{"×", "write * for a product"},
    Stray{"·", "write * for a product, and P . C . U for a product of atoms"},
    Stray{"∘", "write P . C . U for a product of atoms"},
    Stray{"≤", "write <="},
    Stray{"≥", "write >="},
    Stray{"≠", "write !="},
    Stray{"∞", "write oo"},
    Stray{"√", "write sqrt(x)"},
    Stray{"|", "write |> before a step, abs(x) for an absolute value"},
    Stray{"//", "a comment begins with #"},
};

/// Tokens of the language in a wrong place.
constexpr std::array misplaced = {
    Stray{"=", "write == to compare two values; = only gives names to values"},
    Stray{".", "write a digit before a decimal point: 0.5; and x.name() without blanks"},
    Stray{"..", "a range is first .. last; put brackets around it inside an expression"},
    Stray{"on", "on triangles stands once, right after the word and before where"},
    Stray{"where", "where stands once, behind a word; put brackets around a word that has bindings"},
    Stray{"|>", "a step follows a value; put brackets around a pipe inside an expression"},
    Stray{"then", "then belongs to if: if N == 4 then 0 else 1"},
    Stray{"else", "else belongs to if: if N == 4 then 0 else 1"},
    Stray{"for", "for stands behind a claim: prove c1(w) for N in 3 .. 8"},
    Stray{"->", "-> \"file\" stands at the end of check or prove"},
    Stray{"{", "braces hold the statements of sweep and animate, and bindings after where"},
    Stray{"+", "a sign + is not written"},
};

constexpr std::array keywords = {"where", "on",     "for", "in",  "step",  "frames",  "if",     "then",
                                 "else",  "and",    "or",  "not", "sweep", "animate", "assert", "check",
                                 "prove", "verify", "use", "set", "print", "save",    "plot"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

/// Behind blanks, line ends and comments.
std::size_t skip_gaps(std::string_view text, std::size_t place) {
  while (place < text.size()) {
    const char c = text[place];
    if (c == '#') {
      place = std::min(text.find('\n', place), text.size());
    } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++place;
    } else {
      break;
    }
  }
  return place;
}

/// The end of the last thing before `place` that is no gap; comments in between do not matter for a caret.
std::size_t end_before(std::string_view text, std::size_t place) {
  const std::size_t last = text.substr(0, place).find_last_not_of(" \t\r\n");
  return last == std::string_view::npos ? 0 : last + 1;
}

/// The token at a place: a name or number, a sign of two characters, or one character. Empty at the end of a line.
std::string_view token_at(std::string_view text, std::size_t place) {
  const std::string_view rest = text.substr(place);
  if (rest.empty() || rest[0] == '\n' || rest[0] == '\r') return {};
  std::size_t size = 0;
  while (size < rest.size() && (is_letter(rest[size]) || is_digit(rest[size]))) ++size;
  if (size > 0) return rest.substr(0, size);
  for (const std::string_view sign : {"&&", "||", "**", "//", "==", "!=", "<=", ">=", "->", "|>", ".."}) {
    if (rest.starts_with(sign)) return sign;
  }
  return rest.substr(0, character_length(text, place));
}

template <std::size_t Size>
const char* find(const std::array<Stray, Size>& table, std::string_view sign) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Stray& stray) { return stray.sign == sign; });
  return found == table.end() ? nullptr : found->help;
}

SyntaxError unclosed(std::string_view text, Span open) {
  const char bracket = text[open.begin];
  const char close = bracket == '(' ? ')' : bracket == '[' ? ']' : '}';
  SyntaxError error("E_SYNTAX", std::string("this ") + bracket + " is never closed", open, std::string("close it with ") + close,
                    "opened here");
  error.incomplete = true;
  return error;
}

/// A character or bracket that explains the error better than what was expected; an empty message if there is none.
SyntaxError explained(std::string_view text, std::string_view token, Span span, const Span* open) {
  const char first = token.empty() ? ' ' : token[0];
  const std::string sign(token);
  if (first == ')' || first == ']' || first == '}') {
    if (!open)
      return {"E_SYNTAX", "this " + sign + " closes no bracket", span, "leave it out, or open the bracket before",
              "nothing is open"};
    const char bracket = text[open->begin];
    const char close = bracket == '(' ? ')' : bracket == '[' ? ']' : '}';
    if (first != close) {
      return {"E_SYNTAX", "this " + sign + " does not close the " + bracket + " it meets", span, std::string("write ") + close,
              "the other kind of bracket"};
    }
  }
  if (const char* help = find(strays, token))
    return {"E_SYNTAX", sign + " has no meaning in the language", span, help, "not a sign of the language"};
  if (is_capital(first)) {
    return {"E_SYNTAX",
            std::string(1, first) + " is no atom; the atoms are U, D, C, P",
            {span.begin, span.begin + 1},
            "write names in small letters",
            "neither an atom nor the valence N"};
  }
  const bool ascii = static_cast<unsigned char>(first) < 0x80;
  const bool no_sign = token.size() == 1 && (first < ' ' || std::string_view("$%&?\\`~").find(first) != std::string_view::npos);
  if (!token.empty() && (!ascii || no_sign)) {
    const std::string shown = first < ' ' && ascii ? "a control character" : sign;
    return {"E_SYNTAX", shown + " has no meaning in the language", span,
            "outside texts and comments use ASCII and the names ω δ α α0 π", "not a sign of the language"};
  }
  return {"", "", span};
}

}  // namespace

SyntaxError diagnose(const Message& message, std::string_view text, std::size_t place, const Span* open) {
  const bool malformed = message.kind == Message::Kind::letters || message.kind == Message::Kind::number;
  const char* const code = message.kind == Message::Kind::number ? "E_NUMBER" : "E_SYNTAX";
  if (!malformed && skip_gaps(text, place) == text.size()) {
    if (message.kind == Message::Kind::bracket && open) return unclosed(text, *open);
    const std::size_t end = end_before(text, place);
    SyntaxError error(code, message.text, {end, end}, message.help, message.label);
    error.incomplete = true;
    return error;
  }
  const std::string_view token = token_at(text, place);
  const Span span{place, place + token.size()};
  if (malformed) return {code, message.text, span, message.help, message.label};
  if (SyntaxError error = explained(text, token, span, open); !error.code.empty()) return error;
  const char* help = message.help;
  if (const char* better = find(misplaced, token)) {
    help = better;
  } else if (message.kind == Message::Kind::value && std::find(keywords.begin(), keywords.end(), token) != keywords.end()) {
    return {code, message.text, span, std::string(token) + " is a word of the language and cannot be a name", message.label};
  }
  return {code, message.text, span, help, message.label};
}

}  // namespace udcp::grammar
