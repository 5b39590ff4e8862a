// What stops a run: sizes, memory, the user, parameters that have no value; and progress.
#include <doctest/doctest.h>

#include "operators/run.h"
#include "tests/oracle/inputs.h"
#include "tests/oracle/refusal.h"
#include "tests/oracle/words.h"

using namespace udcp;
using namespace udcp::oracle;

TEST_SUITE("operators") {
  TEST_CASE("a run that would pass the limit of faces stops before any work") {
    RunControl control;
    control.max_faces = 100;
    int steps = 0;
    control.progress = [&](double) { ++steps; };
    CHECK(refusal([&] { run(scheme("UCP"), cube<double>(), 3, control); }) ==
          "E_MAX_FACES: the result would have 384 faces; the limit is 100");
    CHECK(steps == 0);
    CHECK(refusal([&] { run(scheme("UCP"), cube<double>(), 2, control); }) == "accepted");
    control.max_faces = 96;
    CHECK(refusal([&] { run(scheme("UCP"), cube<double>(), 2, control); }) == "accepted");
    control.max_faces = 95;
    CHECK(refusal([&] { run(scheme("UCP"), cube<double>(), 2, control); }) ==
          "E_MAX_FACES: the result would have 96 faces; the limit is 95");
    CHECK(refusal([&] { run(scheme("UCP"), polygon<double>(5), 5, control); }) ==
          "E_MAX_FACES: the result would have 160 points; the limit is 95");
    CHECK(refusal([] { run(scheme("UCP"), cube<double>(), 25); }).starts_with("E_MAX_FACES"));
    CHECK(refusal([] { run(scheme("UCP"), cube<double>(), 100); }).starts_with("E_MAX_FACES"));
    CHECK(refusal([] { run(scheme("UCP"), polygon<double>(5), 100); }).starts_with("E_COUNT_OVERFLOW"));
  }

  TEST_CASE("the memory of the result is limited too") {
    RunControl control;
    control.max_bytes = 1 << 20;
    CHECK(refusal([&] { run(scheme("UCP"), cube<double>(), 3, control); }) == "accepted");
    const std::string text = refusal([&] { run(scheme("UCP"), cube<double>(), 8, control); });
    CHECK(text.starts_with("E_MAX_MEMORY: the result would need about "));
    CHECK(text.ends_with(" MiB; the limit is 1 MiB"));
    CHECK(refusal([&] { run(scheme("UCP"), polygon<double>(5), 20, control); }).starts_with("E_MAX_MEMORY"));
  }

  TEST_CASE("a run that continues does not count its head again") {
    Word word = scheme("UC");
    word.head = items("UUUUUUUUUU");
    RunControl control;
    control.first_item = word.items(0);
    control.max_faces = 100;
    CHECK(refusal([&] { run(word, cube<double>(), 1, control); }) == "accepted");
    CHECK(refusal([&] { run(word, polygon<double>(5), 1, control); }) == "accepted");
    control.first_item = 0;
    CHECK(refusal([&] { run(word, cube<double>(), 1, control); }).starts_with("E_MAX_FACES"));
  }

  TEST_CASE("a run stops at the next atom when asked") {
    std::atomic<bool> stop{false};
    RunControl control;
    control.stop = &stop;
    int steps = 0;
    control.progress = [&](double) { stop = ++steps == 4; };
    CHECK(refusal([&] { run(scheme("UCP"), cube<double>(), 3, control); }) == "E_INTERRUPTED: interrupted");
    CHECK(steps == 4);
  }

  TEST_CASE("progress rises with every atom and ends at 1") {
    for (const char* atoms : {"UCP", "UD", "UDUD"}) {
      RunControl control;
      std::vector<double> seen;
      control.progress = [&](double fraction) { seen.push_back(fraction); };
      run(scheme(atoms), cube<double>(), 2, control);
      CHECK(std::is_sorted(seen.begin(), seen.end()));
      CHECK(seen.size() == 2 * std::string(atoms).size());
      CHECK(seen.back() == 1.0);
      seen.clear();
      run(scheme(atoms), polygon<double>(4), 2, control);
      CHECK(seen.back() == 1.0);
    }
  }

  TEST_CASE("parameters without a value and rounds below 0 are errors") {
    const KernelPtr missing = formula([](const auto& c) { return c.attribute("w"); }, {false, true, false});
    CHECK(refusal([&] { run(scheme("UCP", nullptr, nullptr, missing), cube<double>(), 1); }) ==
          "E_ATTRIBUTE: the points have no attribute 'w'");
    CHECK(refusal([&] { run(scheme("UCP", missing), polygon<double>(4), 1); }) ==
          "E_ATTRIBUTE: the points have no attribute 'w'");
    CHECK(refusal([] { run(scheme("UCP"), cube<double>(), -1); }) ==
          "E_ROUNDS: the number of rounds is -1; it cannot be negative");
    CHECK(refusal([] { run(scheme("PU"), cube<double>(), 1); }).starts_with("item 0: E_P_NO_U"));
  }

  TEST_CASE("a round that pushes back to a U of the round before cannot start a run") {
    Word word = scheme("PUC");
    word.head = items("UC");
    RunControl control;
    control.first_item = 2;
    CHECK(refusal([&] { run(word, cube<double>(), 1, control); }) ==
          "E_P_NO_U: P pushes back to the points before U, but this round starts without one");
    CHECK(refusal([&] { run(word, cube<double>(), 2); }) == "accepted");
  }
}
