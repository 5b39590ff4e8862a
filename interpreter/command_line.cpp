// The options of the command (CLI11), and the one page of help.
#include "interpreter/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <map>

namespace udcp {
namespace {

void add_common_options(CLI::App& app, CommandLine& line) {
  app.add_flag("--json", line.json);
  app.add_flag("--quiet,-q", line.settings.quiet);
  app.add_option("--seed", line.settings.seed)->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  app.add_option("--precision", line.settings.precision)->check(CLI::Range(2, 1'000'000));
  app.add_option("--max-faces", line.settings.max_faces)->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 62));
  app.add_option("--threads", line.settings.threads)->check(CLI::Range(0, 4096));
  app.add_option("--color,--colour", line.colour)->check(CLI::IsMember({"auto", "always", "never"}));
}

CLI::App* add_action(CLI::App& app, const char* name, Action action, CommandLine& line) {
  CLI::App* sub = app.add_subcommand(name);
  sub->fallthrough();  // so that --json and the like may stand after the action too
  sub->callback([action, &line] { line.action = action; });
  return sub;
}

/// One file. Not by way of a vector, which CLI11 would fill from a name such as "[a,b]" piece by piece.
CLI::Option* add_file(CLI::App& app, const char* name, CommandLine& line) {
  return app.add_option_function<std::string>(name, [&line](const std::string& file) { line.files = {file}; });
}

void add_apply(CLI::App& app, CommandLine& line) {
  static const std::map<std::string, Corners> corners{
      {"none", Corners::none}, {"one-face", Corners::one_face}, {"tagged", Corners::tagged}};
  CLI::App* apply = add_action(app, "apply", Action::apply, line);
  apply->add_option("WORD", line.word)->required();
  apply->add_option("INPUT", line.input)->required();
  apply->add_option_function<int>("-n,--rounds", [&line](int rounds) { line.rounds = rounds; })->check(CLI::Range(0, 1000));
  apply->add_option("-o,--output", line.output)->required();
  apply->add_option("--format", line.format)->check(CLI::IsMember({"obj", "off", "ply", "stl", "glb", "gltf"}));
  apply->add_option_function<std::string>("--corners", [&line](const std::string& name) { line.corners = corners.at(name); })
      ->check(CLI::IsMember({"none", "one-face", "tagged"}));
  apply->add_flag("--limit", line.limit);
}

void add_actions(CLI::App& app, CommandLine& line) {
  add_file(*add_action(app, "run", Action::program, line), "FILE", line)->required();
  add_apply(app, line);
  CLI::App* prove = add_action(app, "prove", Action::prove, line);
  prove->add_option("CLAIM", line.claim)->required();
  prove->add_option("-o,--output", line.output);
  add_file(*add_action(app, "verify", Action::verify, line), "CERTIFICATE", line)->required();
  CLI::App* format = add_action(app, "fmt", Action::format, line);
  format->add_option("FILE", line.files)->required()->expected(1, 1'000'000);
  format->add_flag("--check", line.check);
}

/// CLI11 speaks of "The following argument was not expected: x"; we write sentences in lower case without a full stop.
std::string sentence(std::string message) {
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  const bool word = message.size() > 1 && message[0] >= 'A' && message[0] <= 'Z' && message[1] >= 'a' && message[1] <= 'z';
  if (word) message[0] = static_cast<char>(message[0] - 'A' + 'a');
  return message;
}

/// Unknown options first: what follows one is often only its value.
std::string unexpected(const std::vector<std::string>& arguments) {
  const auto is_option = [](const std::string& argument) { return argument.size() > 1 && argument[0] == '-'; };
  const auto option = std::find_if(arguments.begin(), arguments.end(), is_option);
  if (option != arguments.end()) return std::string("there is no option '") + *option + "'";
  return std::string("unexpected argument '") + (arguments.empty() ? "" : arguments.front()) + "'";
}

void check_program_arguments(const CommandLine& line, const CLI::Option& file, bool has_action) {
  const bool has_file = file.count() > 0;
  if (has_file && has_action) throw UsageError(unexpected(file.results()));
  if (line.code && (has_action || has_file)) throw UsageError("-e runs the code it is given and takes no file and no action");
  if (line.explain.empty()) return;
  if (has_action || line.code || has_file) throw UsageError("--explain stands alone");
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  CLI::App app;
  app.set_help_flag("-h,--help");
  app.set_version_flag("--version", "");
  app.require_subcommand(0, 1);
  add_common_options(app, line);
  app.add_option_function<std::string>("-e", [&line](const std::string& code) { line.code = code; })->join('\n');
  app.add_option("--explain", line.explain);
  CLI::Option* bare_file = add_file(app, "FILE", line);
  add_actions(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    line.action = Action::help;
    return line;
  } catch (const CLI::CallForVersion&) {
    line.action = Action::version;
    return line;
  } catch (const CLI::ExtrasError&) {
    throw UsageError(unexpected(app.remaining(true)));
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string message = error.what();
    throw UsageError(message.substr(0, message.find(':')) + " needs one value");
  } catch (const CLI::ParseError& error) {
    throw UsageError(sentence(error.what()));
  }
  check_program_arguments(line, *bare_file, !app.get_subcommands().empty());
  if (!line.explain.empty()) line.action = Action::explain;
  return line;
}

const char* version_text() { return "udcp " UDCP_VERSION; }

const char* help_text() {
  return R"(udcp: a language for subdivision schemes

usage
  udcp                            interactive on a terminal, otherwise the program is read from standard input
  udcp FILE | udcp run FILE       run a program
  udcp -e CODE                    run code
  udcp apply WORD INPUT -o OUTPUT refine one mesh file
      -n, --rounds N              rounds of a scheme (default 1 for a finite word, 0 with --limit)
      -o, --output FILE           format by extension; '-' with --format writes to standard output
      --format FORMAT             obj off ply stl glb gltf; needed for '-' as INPUT or OUTPUT
      --corners WHICH             none, one-face, tagged (default: what the file tags)
      --limit                     put the vertices on the limit surface
  udcp prove CLAIM [-o FILE]      prove a claim, and keep the certificate
  udcp verify FILE                check a certificate again
  udcp fmt FILE...                write programs in their canonical form ('-': standard input to output; --check: only say)

options
  --json                 results and diagnostics as JSON lines
  --seed N               added to the seed of every noise
  --precision BITS       of enclosures (default 128)
  --max-faces N          refuse larger results before any work (default 50000000)
  --threads N            0: all
  -q, --quiet            no warnings, no progress
  --color WHEN           auto, always, never
  --explain CODE         the longer story of an error code, such as W03
  -h, --help  --version

exit codes
  0 done, every claim proved, every assertion true    1 an assertion or claim is false    2 usage or program error
  3 undecided within limits    4 resource limit    5 file error    130 interrupted    70 a mistake inside udcp

examples
  udcp -e 'mask((UCP)*)'
  udcp -e 'cube() |> catmull_clark^3 |> save "cube.glb"'
  udcp apply '(UCP)* where omega = 0, delta(N) = (N-4)/N' cage.obj -n 4 -o fine.obj
  udcp prove 'converges((UCP)*) for omega in (0, 1)' -o four_point.json
)";
}

}  // namespace udcp
