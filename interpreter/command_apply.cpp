// udcp apply: one mesh file through one word. File names go to the library as they are and never through program text.
#include <iostream>
#include <iterator>

#include "files/geometry_file.h"
#include "interpreter/apply.h"
#include "interpreter/command_parts.h"
#include "operators/limit.h"
#include "operators/plan/refine.h"

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

std::string format_of(const CommandLine& line) {
  return line.format.empty() ? std::filesystem::path(line.output).extension().string() : "." + line.format;
}

bool is_gltf(const std::string& format) { return format == ".glb" || format == ".gltf"; }

/// The tags and attributes of vertices stay with a surface on the general path; a plan makes points and faces only.
bool keeps_marks(const Surface<double>& surface, const std::string& format) {
  if (format == ".obj") return !surface.tags.edge.empty() || !surface.tags.corner.empty();
  return format.starts_with(".ply") && !surface.attributes.empty();
}

std::int64_t faces_after(const WordValue& word, const Surface<double>& surface, int rounds) {
  return counts(word.word, counts(*surface.mesh, surface.tags), rounds).faces;
}

template <class T>
void write(const T& mesh, const CommandLine& line, const SaveOptions& options, Console& console) {
  console.erase_progress();
  if (line.output != "-") return save(mesh, line.output, options);
  console.out() << save_bytes(mesh, line.format, options);
  console.flush();
}

/// Points, and normals where there are any: words without limit normals are shown with those of their faces.
template <class R>
Refined<R> refined(const WordValue& word, const Surface<double>& surface, int rounds, PlanControl control) {
  try {
    return refine<R>(word.word, surface, rounds, control);
  } catch (const Error& error) {
    if (!control.normals || control.limit_points || error.kind == ErrorKind::interrupted || error.kind == ErrorKind::limit) throw;
    control.normals = false;
    return refine<R>(word.word, surface, rounds, control);
  }
}

/// R: the numbers that the format keeps.
template <class R>
void refine_and_write(const CommandLine& line, const WordValue& word, const Surface<double>& surface, int rounds,
                      const PlanControl& control, SaveOptions options, Console& console) {
  const Refined<R> result = refined<R>(word, surface, rounds, control);
  if (const auto* flat = std::get_if<FlatMesh<R>>(&result.mesh)) return write(*flat, line, options, console);
  if (result.normals.rows() > 0) options.normals = &result.normals;
  write(std::get<Surface<double>>(result.mesh), line, options, console);
}

/// Atom by atom, with tags and attributes.
void run_and_write(const CommandLine& line, const WordValue& word, Surface<double> surface, int rounds, RunControl control,
                   SaveOptions options, Console& console) {
  if (rounds > 0 || !line.limit) surface = run(word.word, std::move(surface), rounds, control);
  std::shared_ptr<const Points<double>> normals;
  if (line.limit) {
    control.first_item = rounds > 0 ? word.word.items(rounds) : 0;
    Limit at_limit = limit(word.word, surface, control);
    surface.points = std::move(at_limit.points);
    normals = std::make_shared<const Points<double>>(std::move(at_limit.normals));
  } else if (is_gltf(format_of(line))) {
    normals = limit_normals(word, rounds, surface, control);
  }
  options.normals = normals.get();
  write(surface, line, options, console);
}

}  // namespace

void apply_to_file(const CommandLine& line, Session& session, Console& console, std::istream& in, const std::atomic<bool>& stop) {
  check_formats(line);
  const WordValue word = word_of(line, session);
  const int rounds = rounds_of(line, word);
  Surface<double> surface = load_input(line, console, in);
  set_corners(surface, line.corners);

  const CallContext context{session.settings(), session.output(), nullptr, {}, nullptr, nullptr};
  PlanControl control;
  control.run = run_control(context, "refining");
  control.run.stop = &stop;
  SaveOptions options;
  options.word = word.source;
  options.format = line.format;
  options.stop = &stop;
  const std::string format = format_of(line);
  constexpr std::int64_t worth_it = 20'000;  // faces; fewer cost no time, and their points have the order of a program's
  if (rounds == 0 || keeps_marks(surface, format) || faces_after(word, surface, rounds) < worth_it)
    return run_and_write(line, word, std::move(surface), rounds, control.run, options, console);
  control.limit_points = line.limit;
  control.normals = line.limit || (word.word.is_scheme() && is_gltf(format));
  control.threads = thread_count(session.settings());
  if (is_gltf(format) || format == ".stl") return refine_and_write<float>(line, word, surface, rounds, control, options, console);
  refine_and_write<double>(line, word, surface, rounds, control, options, console);
}

}  // namespace udcp
