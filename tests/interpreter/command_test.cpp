// The command in process: options, exit codes, streams. What needs a real process (signals, pipes) is in process_test.sh.
#include "interpreter/command.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "files/geometry_file.h"
#include "grammar/parse.h"
#include "interpreter/command_parts.h"
#include "operators/plan/correspondence.h"

using namespace udcp;

namespace {

namespace fs = std::filesystem;

struct Ran {
  int code = 0;
  std::string out, err;
};

Ran udcp_command(std::vector<std::string> arguments, const std::string& input = {}) {
  std::vector<const char*> argv{"udcp"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::istringstream in(input);
  std::ostringstream out, err;
  const int code = command(static_cast<int>(argv.size()), argv.data(), in, out, err);
  return {code, out.str(), err.str()};
}

std::string contents(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// A folder of its own, gone at the end.
struct Folder {
  Folder() {
    std::string name = (fs::temp_directory_path() / "udcp_command_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return (path / name).string();
  }
  [[nodiscard]] std::string name(const std::string& name) const { return (path / name).string(); }
  fs::path path;
};

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
constexpr const char* tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

bool has_point(const Surface<double>& surface, double x, double y) {
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    if (surface.points(i, 0) == x && surface.points(i, 1) == y) return true;
  }
  return false;
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("code from the command line prints its value on standard output") {
    const Ran ran = udcp_command({"-e", "1/3 + 1/6"});
    CHECK(ran.code == 0);
    CHECK(ran.out == "1/2\n");
    CHECK(ran.err.empty());
  }

  TEST_CASE("code that looks like an option or a list is still code") {
    CHECK(udcp_command({"-e", "-1 + 2"}).out == "1\n");
    CHECK(udcp_command({"-e", "[1, 2]"}).out == "[1, 2]\n");
    CHECK(udcp_command({"-e", "a = 2", "-e", "a + 1"}).out == "3\n");
  }

  TEST_CASE("without arguments the program is read from standard input") {
    const Ran ran = udcp_command({}, "a = 3\na^2\n");
    CHECK(ran.code == 0);
    CHECK(ran.out == "9\n");
    CHECK(udcp_command({}, "").code == 0);
  }

  TEST_CASE("a file runs with and without run and finds its neighbours") {
    const Folder folder;
    folder.file("part.udcp", "b = 5\n");
    const std::string program = folder.file("tour.udcp", "use \"part.udcp\"\nb + 1\n");
    CHECK(udcp_command({program}).out == "6\n");
    CHECK(udcp_command({"run", program}).out == "6\n");
  }

  TEST_CASE("with --json every value is one line") {
    const Ran ran = udcp_command({"--json", "-e", "1/2", "-e", "[1, 2]"});
    CHECK(ran.out == "{\"kind\":\"number\",\"value\":\"1/2\"}\n{\"kind\":\"list\",\"value\":[\"1\",\"2\"]}\n");
  }

  TEST_CASE("an error in a program has a caret and exit code 2") {
    const Folder folder;
    const std::string program = folder.file("tour.udcp", "# a tour\n\n(UDP)*\n");
    const Ran ran = udcp_command({program});
    CHECK(ran.code == 2);
    CHECK(ran.out.empty());
    CHECK(ran.err.find("error[W03]: P needs the points to correspond to the vertices before U, but here they are dual\n") == 0);
    CHECK(ran.err.find("  --> " + program + ":3:4\n") != std::string::npos);
    CHECK(ran.err.find("\n   |    ^") != std::string::npos);
    CHECK(ran.err.find("\nhelp: write (UDDP)* or (UCP)*\n") != std::string::npos);
  }

  TEST_CASE("values printed before an error stay and later statements do not run") {
    const Ran ran = udcp_command({"-e", "1\n1/0\n2"});
    CHECK(ran.code == 2);
    CHECK(ran.out == "1\n");
    CHECK(ran.err.find("error[E06]") == 0);
    CHECK(ran.err.find("<command line>:2:") != std::string::npos);
  }

  TEST_CASE("errors are JSON lines with --json") {
    const Ran ran = udcp_command({"-e", "nonsense_name", "--json"});
    const Json json = Json::parse(ran.err);
    CHECK(json["kind"] == "error");
    CHECK(json["code"] == "E01");
    CHECK(json["file"] == "<command line>");
    CHECK(json["line"] == 1);
    CHECK(json["column"] == 1);
    CHECK(ran.code == 2);
  }

  TEST_CASE("a false assertion gives 1 and the rest of the program still runs") {
    const Ran ran = udcp_command({"-e", "assert 1 == 2\n3"});
    CHECK(ran.code == 1);
    CHECK(ran.out.find("3\n") != std::string::npos);
    CHECK(udcp_command({"-e", "assert 1 == 1"}).code == 0);
  }

  TEST_CASE("a result above the limit is refused with 4") {
    const Ran ran = udcp_command({"--max-faces", "1000", "-e", "cube() |> ((UCP)*)^9"});
    CHECK(ran.code == 4);
    CHECK(ran.err.find("error[L01]") == 0);
    CHECK(udcp_command({"-e", "cube() |> ((UCP)*)^30"}).code == 4);
  }

  TEST_CASE("a file that cannot be a program is refused with 5") {
    const Folder folder;
    const Ran missing = udcp_command({folder.name("none.udcp")});
    CHECK(missing.code == 5);
    CHECK(missing.err == "error[F01]: '" + folder.name("none.udcp") + "' cannot be opened: No such file or directory\n");
    const Ran is_folder = udcp_command({folder.path.string()});
    CHECK(is_folder.code == 5);
    CHECK(is_folder.err.find("is a folder, not a program") != std::string::npos);
    const Ran binary = udcp_command({folder.file("x.udcp", std::string("a\0b", 3))});
    CHECK(binary.code == 5);
    CHECK(binary.err.find("is a binary file, not a program") != std::string::npos);
    const Ran mesh = udcp_command({folder.file("cube.obj", square)});
    CHECK(mesh.code == 5);
    CHECK(mesh.err.find("udcp apply") != std::string::npos);
    const Ran large = udcp_command({folder.file("large.udcp", std::string((std::size_t{16} << 20) + 1, '#'))});
    CHECK(large.code == 5);
    CHECK(large.err.find("16 MiB") != std::string::npos);
  }

  TEST_CASE("junk is a syntax error and not a crash") {
    const Ran ran = udcp_command({}, "\xff\xfe\x01 = (((\n");
    CHECK(ran.code == 2);
    CHECK(ran.err.find("error[S") == 0);
  }

  TEST_CASE("mistakes in the command line give 2 and the usual look") {
    const Ran ran = udcp_command({"--nonsense"});
    CHECK(ran.code == 2);
    CHECK(ran.err.find("error[S04]: ") == 0);
    CHECK(ran.err.find("\nhelp: udcp --help") != std::string::npos);
    CHECK(ran.out.empty());
    CHECK(udcp_command({"a.udcp", "b.udcp"}).code == 2);
    CHECK(udcp_command({"-e", "1", "a.udcp"}).code == 2);
    CHECK(udcp_command({"-e"}).code == 2);
    CHECK(udcp_command({"apply", "U"}).code == 2);
    CHECK(udcp_command({"fmt"}).code == 2);
    CHECK(udcp_command({"--precision", "1", "-e", "1"}).code == 2);
    CHECK(udcp_command({"--precision", "many", "-e", "1"}).code == 2);
    CHECK(udcp_command({"--max-faces", "-5", "-e", "1"}).code == 2);
    CHECK(udcp_command({"--color", "blue", "-e", "1"}).code == 2);
    CHECK(udcp_command({"run", "a.udcp", "b.udcp"}).code == 2);
    const Json json = Json::parse(udcp_command({"--json", "--nonsense"}).err);
    CHECK(json["code"] == "S04");
  }

  TEST_CASE("help fits on one page and lists every action and exit code") {
    const Ran ran = udcp_command({"--help"});
    CHECK(ran.code == 0);
    CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') < 60);
    for (const char* part : {"apply", "prove", "verify", "fmt", "--json", "--seed", "--precision", "--max-faces", "--threads",
                             "--quiet", "--color", "--explain", "--version", "130 interrupted", "70 "}) {
      CAPTURE(part);
      CHECK(ran.out.find(part) != std::string::npos);
    }
    CHECK(udcp_command({"apply", "--help"}).out == ran.out);
  }

  TEST_CASE("the version is one line") {
    const Ran ran = udcp_command({"--version"});
    CHECK(ran.code == 0);
    CHECK(ran.out.find("udcp ") == 0);
    CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') == 1);
  }

  TEST_CASE("explain tells the story of a code by number or symbol") {
    const Ran ran = udcp_command({"--explain", "W03"});
    CHECK(ran.code == 0);
    CHECK(ran.out.find("W03 (E_P_DUAL): P on a dual result\n\n") == 0);
    CHECK(udcp_command({"--explain", "E_P_DUAL"}).out == ran.out);
    CHECK(udcp_command({"--explain", "W99"}).code == 2);
    CHECK(udcp_command({"--explain", "W03", "-e", "1"}).code == 2);
  }

  TEST_CASE("colour appears only when asked for") {
    CHECK(udcp_command({"-e", "1/0"}).err.find('\033') == std::string::npos);
    CHECK(udcp_command({"--color=never", "-e", "1/0"}).err.find('\033') == std::string::npos);
    CHECK(udcp_command({"--color=always", "-e", "1/0"}).err.find("\033[1;31merror[E06]") == 0);
  }

  TEST_CASE("warnings go to the diagnostics and --quiet leaves them out") {
    const Ran ran = udcp_command({"-e", "(UC)* where omega = 1/2"});
    CHECK(ran.code == 0);
    CHECK(ran.err.find("warning: ") == 0);
    CHECK(udcp_command({"--quiet", "-e", "(UC)* where omega = 1/2"}).err.empty());
    CHECK(Json::parse(udcp_command({"--json", "-e", "(UC)* where omega = 1/2"}).err)["kind"] == "warning");
  }

  TEST_CASE("the same program gives the same bytes") {
    const std::vector<std::string> arguments{"--json", "-e", "polygon(5) |> ((UCP)*)^3", "-e", "mask((UCP)*)"};
    CHECK(udcp_command(arguments).out == udcp_command(arguments).out);
  }

  TEST_CASE("apply refines a file") {
    const Folder folder;
    const std::string input = folder.file("in.obj", tetrahedron), output = folder.name("out.obj");
    const Ran ran = udcp_command({"apply", "U", input, "-o", output});
    CHECK(ran.err == "");
    CHECK(ran.code == 0);
    CHECK(ran.out.empty());
    const Surface<double> refined = load<double>(output);
    CHECK(refined.mesh->vertices() == 4 + 6 + 4);
    CHECK(refined.mesh->all_faces_have(4));
    CHECK(has_point(refined, 0.5, 0.5));  // the middle of the edge from (1, 0, 0) to (0, 1, 0)
  }

  TEST_CASE("apply agrees with the same steps written as a program") {
    const Folder folder;
    const std::string input = folder.file("in.obj", tetrahedron);
    CHECK(udcp_command({"apply", "(UCP)* where omega = 0", input, "-n", "2", "-o", folder.name("a.obj")}).code == 0);
    CHECK(udcp_command({"-e", "load(\"" + input + "\") |> ((UCP)* where omega = 0)^2 |> save \"" + folder.name("b.obj") + "\""})
              .code == 0);
    const Surface<double> a = load<double>(folder.name("a.obj")), b = load<double>(folder.name("b.obj"));
    REQUIRE(a.points.rows() == b.points.rows());
    CHECK((a.points - b.points).cwiseAbs().maxCoeff() < 1e-15);  // one side may have been exact: a few roundings at size 1
  }

  TEST_CASE("apply makes many faces as a program does but for the order of the points") {
    const Folder folder;
    const std::string input = folder.file("in.obj", tetrahedron), word = "((UCP)* where omega = 0)^7";
    CHECK(udcp_command({"apply", word, input, "-o", folder.name("a.obj")}).code == 0);
    CHECK(udcp_command({"-e", "load(\"" + input + "\") |> " + word + " |> save \"" + folder.name("b.obj") + "\""}).code == 0);
    const Surface<double> a = load<double>(folder.name("a.obj")), b = load<double>(folder.name("b.obj"));
    REQUIRE(a.mesh->faces() == 12 * 4096);
    double least = 1;  // over the half-edges of b at vertex 0, one of which corresponds to that of a
    for (int h = 0; h < b.mesh->half_edges(); ++h) {
      if (b.mesh->vertex[Mesh::i(h)] != 0) continue;
      const std::vector<int> counterpart = correspondence(*a.mesh, a.mesh->outgoing[0], *b.mesh, h);
      REQUIRE_FALSE(counterpart.empty());
      double most = 0;
      for (int v = 0; v < a.mesh->vertices(); ++v)
        most = std::max(most, (a.points.row(v) - b.points.row(counterpart[Mesh::i(v)])).cwiseAbs().maxCoeff());
      least = std::min(least, most);
    }
    CHECK(least < 1e-13);
  }

  TEST_CASE("apply writes limit points and normals of many faces") {
    const Folder folder;
    const std::string input = folder.file("in.obj", tetrahedron);
    CHECK(udcp_command({"apply", "catmull_clark", input, "-n", "7", "--limit", "-o", folder.name("a.obj")}).code == 0);
    const Surface<double> a = load<double>(folder.name("a.obj"));
    REQUIRE(a.attributes.contains("nx"));
    for (int v = 0; v < a.mesh->vertices(); v += 97) {
      const std::size_t k = Mesh::i(v);
      CHECK(std::hypot(a.attributes.at("nx")[k], a.attributes.at("ny")[k], a.attributes.at("nz")[k]) == doctest::Approx(1));
    }
  }

  TEST_CASE("no file name can become program text") {
    const Folder folder;
    const std::string strange = "a\"{1+1}\\n') |> save \"x.obj";
    const std::string input = folder.file(strange + ".in.obj", square), output = folder.name(strange + ".out.obj");
    CHECK(udcp_command({"apply", "U", input, "-o", output}).code == 0);
    CHECK(fs::exists(output));
    CHECK_FALSE(fs::exists(folder.name("x.obj")));
  }

  TEST_CASE("apply writes to standard output and reads standard input") {
    const Folder folder;
    const std::string input = folder.file("in.obj", square);
    CHECK(udcp_command({"apply", "U", input, "-o", folder.name("out.off")}).code == 0);
    const Ran ran = udcp_command({"apply", "U", input, "-o", "-", "--format", "off"});
    CHECK(ran.code == 0);
    CHECK(ran.out == contents(folder.name("out.off")));
    const Ran piped = udcp_command({"apply", "U", "-", "-o", "-", "--format", "obj"}, square);
    CHECK(piped.code == 0);
    CHECK(load_bytes<double>(piped.out, "obj", "piped").mesh->faces() == 4);
    CHECK(udcp_command({"apply", "U", input, "-o", "-"}).code == 2);
  }

  TEST_CASE("apply keeps the corners that it is told to keep") {
    const Folder folder;
    const std::string input = folder.file("in.obj", square);
    const auto refined = [&](const std::string& corners) {
      const Ran ran = udcp_command({"apply", "UC", input, "-o", "-", "--format", "obj", "--corners", corners});
      CHECK(ran.code == 0);
      return load_bytes<double>(ran.out, "obj", "refined");
    };
    CHECK(has_point(refined("one-face"), 1, 1));
    CHECK_FALSE(has_point(refined("none"), 1, 1));
    CHECK_FALSE(has_point(refined("tagged"), 1, 1));  // the file tags nothing
    CHECK(udcp_command({"apply", "UC", input, "-o", "-", "--format", "obj", "--corners", "some"}).code == 2);
  }

  TEST_CASE("apply says what is missing") {
    const Folder folder;
    const std::string input = folder.file("in.obj", square), output = folder.name("out.obj");
    const Ran no_rounds = udcp_command({"apply", "(UCP)*", input, "-o", output});
    CHECK(no_rounds.code == 2);
    CHECK(no_rounds.err.find("-n 4") != std::string::npos);
    const Ran no_word = udcp_command({"apply", "1 + 1", input, "-o", output});
    CHECK(no_word.code == 2);
    CHECK(no_word.err.find("this is a number") != std::string::npos);
    CHECK(udcp_command({"apply", "x = U", input, "-o", output}).code == 2);
    CHECK(udcp_command({"apply", "(UDP)*", input, "-n", "1", "-o", output}).err.find("<word>:1:4") != std::string::npos);
    CHECK(udcp_command({"apply", "U", folder.name("none.obj"), "-o", output}).code == 5);
    CHECK(udcp_command({"apply", "U", input, "-o", folder.name("no/such/folder.obj")}).code == 5);
    CHECK(udcp_command({"apply", "U", input, "-n", "30", "-o", output}).code == 4);
    CHECK_FALSE(fs::exists(output));
  }

  TEST_CASE("a claim or a certificate name cannot smuggle statements in") {
    CommandLine line;
    line.claim = "converges((UCP)*)\nprint 1";
    CHECK_THROWS_AS(claim_program(line), UsageError);
    line.claim = "converges((UCP)*) for omega in (0, 1)";
    line.output = "a\"\\b\nprint 1";
    const grammar::Program program = grammar::parse(claim_program(line));
    REQUIRE(program.statements.size() == 1);
    CHECK(std::get<grammar::Claim>(program.statements[0].node).certificate == line.output);
    const grammar::Program verify = grammar::parse(verify_program(line.output));
    REQUIRE(verify.statements.size() == 1);
    CHECK(std::get<grammar::Verify>(verify.statements[0].node).path == line.output);
  }

  TEST_CASE("fmt puts a file into canonical form once") {
    const Folder folder;
    const std::string file = folder.file("a.udcp", "x   =  1+2 # sum\n");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    CHECK(udcp_command({"fmt", "--check", file}).code == 1);
    CHECK(udcp_command({"fmt", file}).code == 0);
    const std::string canonical = contents(file);
    CHECK(canonical != "x   =  1+2 # sum\n");
    CHECK(canonical.find("# sum") != std::string::npos);
    CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
    const auto written = fs::last_write_time(file);
    CHECK(udcp_command({"fmt", file}).code == 0);
    CHECK(udcp_command({"fmt", "--check", file}).code == 0);
    CHECK(contents(file) == canonical);
    CHECK(fs::last_write_time(file) == written);
    CHECK(udcp_command({"fmt", "-"}, "x   =  1+2 # sum\n").out == canonical);
  }

  TEST_CASE("fmt leaves a file with an error as it is") {
    const Folder folder;
    const std::string file = folder.file("a.udcp", "x = (1\n");
    const Ran ran = udcp_command({"fmt", file});
    CHECK(ran.code == 2);
    CHECK(ran.err.find("--> " + file + ":") != std::string::npos);
    CHECK(contents(file) == "x = (1\n");
    CHECK(udcp_command({"fmt", folder.name("none.udcp")}).code == 5);
  }

  TEST_CASE("fmt follows links") {
    const Folder folder;
    const std::string file = folder.file("a.udcp", "x   = 1\n");
    fs::create_symlink("a.udcp", folder.path / "link.udcp");
    CHECK(udcp_command({"fmt", folder.name("link.udcp")}).code == 0);
    CHECK(fs::is_symlink(folder.path / "link.udcp"));
    CHECK(contents(file) == "x = 1\n");
  }

  TEST_CASE("the progress bar waits a second and leaves nothing behind") {
    using std::chrono::milliseconds;
    std::ostringstream screen;
    ProgressBar bar(screen);
    const ProgressBar::Clock::time_point start{};
    bar.update("refining", 0.0, start);
    bar.update("refining", 0.3, start + milliseconds(900));
    CHECK(screen.str().empty());
    bar.update("refining", 0.5, start + milliseconds(1100));
    CHECK(screen.str() == "\r\033[Krefining [###############---------------] 50 %");
    bar.update("refining", 0.6, start + milliseconds(1150));  // too soon after the last drawing
    CHECK(screen.str() == "\r\033[Krefining [###############---------------] 50 %");
    bar.erase();
    CHECK(screen.str().ends_with("\r\033[K"));
    const std::string erased = screen.str();
    bar.erase();
    bar.update("refining", 0.1, start + milliseconds(1300));  // a new task begins
    CHECK(screen.str() == erased);
  }

  TEST_CASE("results that cannot be written are an error of their own") {
    std::ostringstream out, err;
    out.setstate(std::ios::badbit);
    std::istringstream in("1\n2\n");
    const char* argv[] = {"udcp"};
    CHECK(command(1, argv, in, out, err) == 5);
    CHECK(err.str().find("error[F") == 0);
    CHECK(err.str().find("standard output") != std::string::npos);
  }
}
