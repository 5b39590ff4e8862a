// Sessions: scopes, undo, settings, diagnostics, interruption.
#include <doctest/doctest.h>

#include <thread>

#include "interpreter/report.h"
#include "interpreter/session.h"

namespace {

using namespace udcp;

std::string run(Session& session, const std::string& text) { return to_text(session.run(text)); }

ProgramError error_of(const std::string& text) {
  Session session;
  session.load_prelude();
  try {
    session.run(text, "test.udcp");
  } catch (const ProgramError& error) {
    return error;
  }
  return ProgramError("no error");
}

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("definitions stay and undo takes the last run back") {
    Session session;
    session.run("a = 1\nb = 2");
    session.run("a = 3");
    CHECK(run(session, "a + b") == "5");
    CHECK(session.undo());
    CHECK(run(session, "a + b") == "3");
    CHECK(session.undo());
    CHECK(session.find("a") == nullptr);
    CHECK_FALSE(session.undo());
  }

  TEST_CASE("bindings made before an error stay") {
    Session session;
    CHECK_THROWS_AS(session.run("a = 1\nb = 1/0"), ProgramError);
    CHECK(run(session, "a") == "1");
  }

  TEST_CASE("functions close over what was in force") {
    Session session;
    session.run("k = 2\nf(x) = k*x\nk = 10");
    CHECK(run(session, "f(3)") == "6");
  }

  TEST_CASE("the underscore is the last value") {
    Session session;
    session.run("6*7");
    CHECK(run(session, "_ + 1") == "43");
    CHECK(run(session, "_ + 1") == "44");
  }

  TEST_CASE("the program of a session runs again") {
    Session session;
    session.load_prelude();
    session.run("a = 1/3  # a comment");
    session.run("w = (UCP)* where delta = a");
    CHECK_THROWS_AS(session.run("nonsense"), ProgramError);
    const std::string text = session.program();
    CHECK(text.find("nonsense") == std::string::npos);
    Session again;
    again.load_prelude();
    again.run(text);
    CHECK(again.program() == text);
    session.undo();
    CHECK(session.program().find("delta") == std::string::npos);
  }

  TEST_CASE("errors carry file and text and place") {
    const ProgramError error = error_of("a = 1\nb = a + unknown_thing");
    CHECK(error.code == "E_NAME");
    CHECK(error.file == "test.udcp");
    CHECK(error.source.substr(error.span.begin, error.span.end - error.span.begin) == "unknown_thing");
    CHECK(error.kind == ErrorKind::word);
    CHECK_FALSE(error.syntax);
    const ProgramError syntax = error_of("a = (1 +");
    CHECK(syntax.syntax);
    CHECK(syntax.incomplete);
  }

  TEST_CASE("an error inside a function is shown in the function and one inside the prelude at the call") {
    const ProgramError own = error_of("f(x) = 1/x\ng(x) = f(x)\ng(0)");
    CHECK(own.code == "E_DIV0");
    CHECK(own.span.begin == 7);
    const ProgramError prelude = error_of("polygon(3) |> circle(0)^2");
    CHECK(prelude.code == "E_DIV0");
    CHECK(prelude.file == "test.udcp");
    CHECK(prelude.source.substr(prelude.span.begin, prelude.span.end - prelude.span.begin) == "circle(0)");
  }

  TEST_CASE("settings are checked") {
    Session session;
    session.run("set precision = 200\nset seed = 5\nset max_faces = 100\nset threads = 2\nset quiet = yes");
    CHECK(session.settings().precision == 200);
    CHECK(session.settings().seed == 5);
    CHECK(session.settings().max_faces == 100);
    CHECK(session.settings().threads == 2);
    CHECK(session.settings().quiet);
    for (const char* wrong :
         {"set precision = 1", "set precision = 1/2", "set seed = -1", "set max_faces = 0", "set quiet = 3", "set nothing = 1"}) {
      CAPTURE(wrong);
      CHECK(error_of(wrong).code == "E_SETTING");
    }
  }

  TEST_CASE("the seed of the session changes the noise") {
    const std::string program = "points(cube(exact = yes) |> (UCP where {delta = noise(1)}))";
    const auto with_seed = [&](const std::string& seed) {
      Session session;
      session.run("set seed = " + seed);
      return run(session, program);
    };
    CHECK(with_seed("1") == with_seed("1"));
    CHECK(with_seed("1") != with_seed("2"));
  }

  TEST_CASE("a false assertion sets the outcome and the program goes on") {
    std::vector<std::string> printed;
    Session session({}, {[&](const Value& value) { printed.push_back(to_text(value)); }, {}, {}});
    session.run("assert [1, 2] == [1, 3]\nprint 5", "test.udcp");
    CHECK(session.outcome() == Outcome::refuted);
    REQUIRE(printed.size() == 2);
    CHECK(printed[0] ==
          "test.udcp:1:1: assertion is false: [1, 2] == [1, 3]\n  left:  [1, 2]\n  right: [1, 3]\n  first difference: item 1: 2 "
          "and 3");
    CHECK(printed[1] == "5");
  }

  TEST_CASE("true assertions print nothing") {
    std::vector<std::string> printed;
    Session session({}, {[&](const Value& value) { printed.push_back(to_text(value)); }, {}, {}});
    session.run("assert 1 < 2\nassert [1, [2]] == [1, [2]]\nassert \"a\" != \"b\"");
    CHECK(session.outcome() == Outcome::done);
    CHECK(printed.empty());
  }

  TEST_CASE("an interrupted session ends its run and can go on afterwards") {
    Session session;
    session.run("f(n) = if n > 60 then 1 else f(n + 1) + f(n + 1)");
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      session.interrupt();
    });
    std::string code;
    try {
      session.run("f(0)");
    } catch (const ProgramError& error) {
      code = error.code;
    }
    other.join();
    CHECK(code == "E_INTERRUPTED");
    session.clear_interrupt();
    CHECK(run(session, "1 + 1") == "2");
  }

  TEST_CASE("a chain of very many definitions does not overflow the stack at its end") {
    std::shared_ptr<const Environment> scope = std::make_shared<Environment>();
    for (int n = 0; n < 300000; ++n) {
      auto next = std::make_shared<Environment>();
      next->names.emplace("f",
                          Value{FunctionValue{"f", {}, nullptr, scope, nullptr}});  // a closure holds the scope a second time
      next->outer = scope;
      scope = next;
    }
    CHECK(scope->find("g") == nullptr);
    scope.reset();
  }

  TEST_CASE("deeply nested expressions end with an error and not with a crash") {
    Session session;
    std::string text = "f(x) = ";
    for (int i = 0; i < 150; ++i) text += "(1 + ";
    text += "f(x)" + std::string(150, ')');
    session.run(text);
    CHECK_THROWS_AS(session.run("f(1)"), ProgramError);
  }
}
