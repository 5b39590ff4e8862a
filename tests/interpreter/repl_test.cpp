// The REPL without its editor: lines in, text out; and what Tab offers.
#include "interpreter/repl.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "interpreter/repl_editor.h"
#include "interpreter/repl_loop.h"

using namespace udcp;

namespace {

namespace fs = std::filesystem;

/// A session with the prelude, a loop, and what it wrote.
struct Desk {
  std::ostringstream out, err;
  Console console{out, err, {}};
  Session session;
  ReplLoop loop{session, console};
  Desk() { session.load_prelude(); }

  /// What one line prints on both streams.
  std::string operator()(const std::string& line) {
    out.str("");
    err.str("");
    running = loop.line(line);
    return out.str() + err.str();
  }
  bool running = true;
};

bool offers(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> complete(const Session& session, const std::string& line) {
  return completions(session, line, line.size());
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("a line prints its value and the underscore remembers it") {
    Desk desk;
    CHECK(desk("1/2 + 1/3") == "5/6\n");
    CHECK(desk("_ * 6") == "5\n");
    CHECK(desk("a = 7").empty());
    CHECK(desk("a").starts_with("7"));
    CHECK(desk("").empty());
    CHECK(desk("   # only a comment").empty());
  }

  TEST_CASE("an unfinished statement asks for more") {
    Desk desk;
    CHECK(std::string(desk.loop.prompt()) == "udcp> ");
    CHECK(desk("twice(x) = (").empty());
    CHECK(std::string(desk.loop.prompt()) == "....> ");
    CHECK(desk("2 * x").empty());
    CHECK(desk(")").empty());
    CHECK(std::string(desk.loop.prompt()) == "udcp> ");
    CHECK(desk("twice(21)") == "42\n");
  }

  TEST_CASE("an empty line ends an unfinished statement with its error") {
    Desk desk;
    CHECK(desk("x = (1 +").empty());
    CHECK(desk("").find("error[S") == 0);
    CHECK(std::string(desk.loop.prompt()) == "udcp> ");
    CHECK(desk("2") == "2\n");
  }

  TEST_CASE("Ctrl-C at the prompt forgets the unfinished statement") {
    Desk desk;
    desk("x = (1 +");
    desk.loop.abandon();
    CHECK(std::string(desk.loop.prompt()) == "udcp> ");
    CHECK(desk("3") == "3\n");
  }

  TEST_CASE("an error shows a caret and the session goes on") {
    Desk desk;
    desk("a = 2");
    const std::string text = desk("a + bb");
    CHECK(text.find("error[E01]") == 0);
    CHECK(text.find("--> <input>:1:5") != std::string::npos);
    CHECK(text.find("^^") != std::string::npos);
    CHECK(desk("a") == "2\n");
  }

  TEST_CASE("a bare word shows type and bindings and defaults and mask and support") {
    Desk desk;
    const std::string text = desk("(UCP)* where delta = 1/2");
    CHECK(text.find("(UCP)* where delta = 1/2\n") == 0);
    CHECK(text.find("type:") != std::string::npos);
    CHECK(text.find("bindings: delta = 1/2\n") != std::string::npos);
    CHECK(text.find("omega = 1") != std::string::npos);
    CHECK(text.find("mask:") != std::string::npos);
    CHECK(text.find("support:") != std::string::npos);
  }

  TEST_CASE("a word of surfaces has no mask to show") {
    Desk desk;
    const std::string text = desk("(UCP)* on triangles");
    CHECK(text.find("on triangles") != std::string::npos);
    CHECK(text.find("mask:") == std::string::npos);
  }

  TEST_CASE("commands say types and settings and help") {
    Desk desk;
    CHECK(desk(":type (UCP)*") == "word\n");
    CHECK(desk(":type 1/2") == "number\n");
    CHECK(desk(":type x = 1").find("error[S") == 0);
    CHECK(desk(":type").find("error[S05]") == 0);
    CHECK(desk(":set precision = 300").empty());
    CHECK(desk(":set").find("precision = 300\n") == 0);
    CHECK(desk(":help").find(":undo") != std::string::npos);
    CHECK(desk(":help atoms").find("pushes back") != std::string::npos);
    CHECK(desk(":help cube").find("cube(") == 0);
    CHECK(desk(":help functions").find("polygon(") != std::string::npos);
    CHECK(desk(":help W03").find("W03: ") == 0);
    CHECK(desk(":help codes").find("W03  P on a dual result") != std::string::npos);
    CHECK(desk(":help nonsense").find("error[S05]") == 0);
  }

  TEST_CASE("an unknown command names the known ones") {
    Desk desk;
    const std::string text = desk(":laod x");
    CHECK(text.find("error[S05]: there is no command :laod") == 0);
    CHECK(text.find(":help :load :quit :save :set :time :type :undo") != std::string::npos);
  }

  TEST_CASE("undo takes back a definition") {
    Desk desk;
    desk("a = 1");
    desk("a = 2");
    CHECK(desk(":undo") == "undone\n");
    CHECK(desk("a") == "1\n");
  }

  TEST_CASE("undo with nothing before it says so") {
    Desk desk;
    CHECK(desk(":undo").find("error[S05]: there is nothing to undo") == 0);
  }

  TEST_CASE("time prints the result and the seconds") {
    Desk desk;
    const std::string text = desk(":time 1 + 1");
    CHECK(text.find("2\ntime: 0.") == 0);
    CHECK(text.ends_with(" s\n"));
  }

  TEST_CASE("a saved session runs again") {
    std::string name = (fs::temp_directory_path() / "udcp_repl_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    const std::string file = name + "/session.udcp";
    {
      Desk desk;
      desk("a = 21");
      desk("twice(x) = 2 * x");
      desk("b = nothing_like_this");  // failed, so not part of the program
      CHECK(desk(":save " + file) == "saved to " + file + "\n");
    }
    Desk desk;
    CHECK(desk(":load " + file).empty());
    CHECK(desk("twice(a)") == "42\n");
    CHECK(desk(":load " + name + "/none.udcp").find("error[F01]") == 0);
    CHECK(desk(":save " + name + "/no/such/folder.udcp").find("error[F") == 0);
    fs::remove_all(name);
  }

  TEST_CASE("quit ends the loop") {
    Desk desk;
    desk("1");
    CHECK(desk.running);
    desk(":quit");
    CHECK_FALSE(desk.running);
  }

  TEST_CASE("Tab offers names and keywords and functions") {
    Desk desk;
    desk("catalogue = 3");
    const auto words = complete(desk.session, "x = cat");
    CHECK(offers(words, "catalogue"));
    CHECK(offers(words, "catmull_clark"));
    CHECK_FALSE(offers(words, "cube"));
    CHECK(offers(complete(desk.session, "(UCP)* whe"), "where"));
    CHECK(offers(complete(desk.session, "cub"), "cube"));
    CHECK(completion_begin("x = cat", 7) == 4);
    CHECK(complete(desk.session, "zzzz").empty());
  }

  TEST_CASE("Tab works in the middle of a line") {
    Desk desk;
    CHECK(offers(completions(desk.session, "cub |> U", 3), "cube"));
    CHECK(completions(desk.session, "cub", 100) == completions(desk.session, "cub", 3));
  }

  TEST_CASE("Tab offers the named arguments of the enclosing call") {
    Desk desk;
    CHECK(offers(complete(desk.session, "matrix(catmull_clark, "), "N = "));
    CHECK_FALSE(offers(complete(desk.session, "matrix(catmull_clark, N = 5) + "), "N = "));
    desk("scaled(shape, factor) = factor");
    CHECK(offers(complete(desk.session, "scaled(1, fac"), "factor = "));
  }

  TEST_CASE("Tab offers commands and their topics") {
    Desk desk;
    CHECK(complete(desk.session, ":lo") == std::vector<std::string>{":load"});
    CHECK(completion_begin(":lo", 3) == 0);
    CHECK(complete(desk.session, ":").size() == repl_commands().size());
    CHECK(offers(complete(desk.session, ":help at"), "atoms"));
    CHECK(complete(desk.session, ":set pre") == std::vector<std::string>{"precision"});
  }

  TEST_CASE("Tab offers files inside quotes and after load") {
    std::string name = (fs::temp_directory_path() / "udcp_tab_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    std::ofstream(name + "/cube.obj") << "x";
    std::ofstream(name + "/cut.obj") << "x";
    std::ofstream(name + "/.hidden") << "x";
    fs::create_directory(name + "/cubes");
    Desk desk;
    CHECK(complete(desk.session, "load(\"" + name + "/cu") ==
          std::vector<std::string>{name + "/cube.obj", name + "/cubes/", name + "/cut.obj"});
    CHECK(complete(desk.session, ":load " + name + "/cub") == std::vector<std::string>{name + "/cube.obj", name + "/cubes/"});
    CHECK_FALSE(offers(complete(desk.session, "load(\"" + name + "/"), name + "/.hidden"));
    CHECK(complete(desk.session, "load(\"" + name + "/none/").empty());
    CHECK(offers(complete(desk.session, "load(\"a.obj\") |> cub"), "cube"));
    fs::remove_all(name);
  }

  TEST_CASE("history lies in the state folder of the user") {
    setenv("XDG_STATE_HOME", "/somewhere/state", 1);
    CHECK(history_file() == fs::path("/somewhere/state/udcp/history"));
    setenv("XDG_STATE_HOME", "relative", 1);  // the standard says: ignore it
    setenv("HOME", "/home/someone", 1);
    CHECK(history_file() == fs::path("/home/someone/.local/state/udcp/history"));
    unsetenv("XDG_STATE_HOME");
    CHECK(history_file() == fs::path("/home/someone/.local/state/udcp/history"));
    unsetenv("HOME");
    CHECK(history_file().empty());
  }
}
