// udcp apply: one mesh file through one word. File names go to the library as they are and never through program text.
#include <iostream>
#include <iterator>

#include "files/geometry_file.h"
#include "interpreter/apply.h"
#include "interpreter/command_parts.h"
#include "operators/limit.h"
#include "operators/run.h"

namespace udcp {
namespace {

WordValue word_of(const CommandLine& line, Session& session) {
  check_expression(line.word, "<word>");
  const Output output = session.output();
  session.output().value = nullptr;  // the word is an argument here, not a result
  const Value value = session.run(line.word, "<word>");
  session.output() = output;
  const auto* word = value.as<WordValue>();
  if (word == nullptr) throw UsageError("apply takes a word such as '(UCP)*', but this is a " + type_name(value));
  return *word;
}

int rounds_of(const CommandLine& line, const WordValue& word) {
  if (line.rounds && word.rounds) throw UsageError("the rounds are given twice, by -n and by ^ in the word");
  if (line.rounds) return *line.rounds;
  if (word.rounds) return *word.rounds;
  if (line.limit) return 0;
  if (word.word.is_scheme())
    throw UsageError("a scheme needs a number of rounds: -n 4, or --limit for points on the limit surface");
  return 1;
}

void check_formats(const CommandLine& line) {
  if (line.output == "-" && line.format.empty()) throw UsageError("-o - writes to standard output and needs --format");
  if (line.input == "-" && line.format.empty()) throw UsageError("INPUT '-' reads standard input and needs --format");
}

Surface<double> load_input(const CommandLine& line, Console& console, std::istream& in) {
  Warnings warnings;
  Surface<double> surface;
  if (line.input == "-") {
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    surface = load_bytes<double>(bytes, line.format, "<stdin>", &warnings);
  } else {
    surface = load<double>(line.input, &warnings);
  }
  for (const std::string& warning : warnings) console.warning(warning);
  return surface;
}

/// one-face: the boundary vertices that lie in a single face, which is where a square has its corners.
void set_corners(Surface<double>& surface, Corners which) {
  if (which == Corners::tagged) return;
  surface.tags.corner.clear();
  if (which == Corners::none) return;
  for (int v = 0; v < surface.mesh->vertices(); ++v) {
    surface.tags.corner.push_back(surface.mesh->on_boundary(v) && surface.mesh->valence(v) == 2 ? 1 : 0);
  }
}

bool writes_gltf(const CommandLine& line) {
  const std::string format = line.format.empty() ? std::filesystem::path(line.output).extension().string() : "." + line.format;
  return format == ".glb" || format == ".gltf";
}

}  // namespace

void apply_to_file(const CommandLine& line, Session& session, Console& console, std::istream& in, const std::atomic<bool>& stop) {
  check_formats(line);
  const WordValue word = word_of(line, session);
  const int rounds = rounds_of(line, word);
  Surface<double> surface = load_input(line, console, in);
  set_corners(surface, line.corners);

  const CallContext context{session.settings(), session.output(), nullptr, {}, nullptr, nullptr};
  RunControl control = run_control(context, "refining");
  control.stop = &stop;
  if (rounds > 0 || !line.limit) surface = run(word.word, std::move(surface), rounds, control);

  SaveOptions options;
  options.word = word.source;
  options.format = line.format;
  std::shared_ptr<const Points<double>> normals;
  if (line.limit) {
    control.first_item = rounds > 0 ? word.word.items(rounds) : 0;
    Limit at_limit = limit(word.word, surface, control);
    surface.points = std::move(at_limit.points);
    normals = std::make_shared<const Points<double>>(std::move(at_limit.normals));
  } else if (writes_gltf(line)) {
    normals = limit_normals(word, rounds, surface, control);
  }
  options.normals = normals.get();
  console.erase_progress();
  if (line.output == "-") {
    console.out() << save_bytes(surface, line.format, options);
    console.flush();
  } else {
    save(surface, line.output, options);
  }
}

}  // namespace udcp
