// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include <riprap/output/progress.hpp>
#include <support/still_sample.hpp>

#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)
#include <fcntl.h>
#include <unistd.h>
#endif

using namespace riprap;

namespace {

/// A sample in shear that breaks no rule, and what Progress says about it.
struct Talk {
  test::StillSample sample;
  BiaxialView<test::StillSample> view = test::view_of(sample);
  std::FILE* out = std::tmpfile();
  Progress progress{out, {.porosity = -1}};  // squares larger than the polygon around them

  Talk() = default;
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;
  ~Talk() { std::fclose(out); }

  /// All that has been printed so far.
  [[nodiscard]] std::string text() const {
    std::fflush(out);
    std::rewind(out);
    std::string all;
    for (int c = std::fgetc(out); c != EOF; c = std::fgetc(out)) all += static_cast<char>(c);
    return all;
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("each stage has a line at its beginning and one at its end, with the share done") {
  for (const Stage stage :
       {Stage::compaction, Stage::relaxation, Stage::hydrostatic, Stage::shear}) {
    Talk talk;
    talk.view.stage = stage;
    talk.progress.begin_stage(talk.view);
    talk.view.done = 1;
    talk.view.reached_target = true;
    talk.progress.end_stage(talk.view);
    const std::string text = talk.text();
    CAPTURE(text);
    CHECK(count(text, "\n") == 2);
    CHECK(count(text, to_text(stage)) == 2);
    CHECK(text.find("  0.0 %") < text.find("100.0 %"));
    CHECK(count(text, "100.0 %") == 1);
    // Nothing rewrites a line in a file.
    CHECK(count(text, "\r") == 0);
    CHECK(count(text, "warning") == 0);
  }
}

TEST_CASE("the time left is printed once it can be estimated, and not at the end") {
  Talk talk;
  talk.view.done = 0.005;
  talk.progress.begin_stage(talk.view);
  CHECK(count(talk.text(), " left") == 0);
  talk.view.done = 0.5;
  talk.progress.begin_stage(talk.view);
  CHECK(count(talk.text(), " s left") == 1);
  talk.view.done = 1;
  talk.progress.end_stage(talk.view);
  CHECK(count(talk.text(), " left") == 1);
}

TEST_CASE("the stage of shear prints its strain and the breakages") {
  Talk talk;
  talk.sample.breaks().resize(3);
  talk.view.stretch = {1.02, 0.877};
  talk.view.done = 1;
  talk.view.reached_target = true;
  talk.progress.end_stage(talk.view);
  CHECK(count(talk.text(), "strain  12.3 %") == 1);
  CHECK(count(talk.text(), "breakages 3\n") == 1);
}

TEST_CASE("breakages are those of shear, as in the summary, without those under pressure") {
  Talk talk;
  talk.sample.breaks().resize(4);
  talk.progress.begin_stage(talk.view);
  CHECK(count(talk.text(), "breakages 0\n") == 1);
  talk.sample.breaks().resize(7);
  talk.view.done = 1;
  talk.view.reached_target = true;
  talk.progress.end_stage(talk.view);
  CHECK(count(talk.text(), "breakages 3\n") == 1);
}

TEST_CASE("stages before shear print neither") {
  Talk talk;
  talk.view.stage = Stage::hydrostatic;
  talk.progress.begin_stage(talk.view);
  CHECK(count(talk.text(), "strain") == 0);
  CHECK(count(talk.text(), "breakages") == 0);
}

TEST_CASE("a file is not flooded: steps soon after the last line print nothing") {
  Talk talk;
  talk.progress.begin_stage(talk.view);
  for (int i = 0; i < 1000; ++i) talk.progress.progress(talk.view);
  CHECK(count(talk.text(), "\n") == 1);
}

TEST_CASE("a number out of range is a warning, once") {
  Talk talk;
  talk.progress.record(talk.view);
  CHECK(talk.text().empty());
  talk.view.rate = {0, 1e3};
  talk.progress.record(talk.view);
  talk.progress.record(talk.view);
  const std::string text = talk.text();
  CHECK(text.starts_with("warning: inertial number = "));
  CHECK(text.ends_with(" of shear: not quasi-static\n"));
  CHECK(count(text, "warning") == 1);
}

TEST_CASE("warnings are kept, and printed before the line of a stage") {
  Talk talk;
  CHECK(talk.progress.warnings().empty());
  talk.view.stage = Stage::hydrostatic;
  talk.view.confining_pressure = 1e9;
  talk.progress.begin_stage(talk.view);
  const std::string text = talk.text();
  CHECK(text.starts_with("warning: stiffness level kappa = "));
  CHECK(text.find("warning") < text.find("hydrostatic  "));
  REQUIRE(talk.progress.warnings().size() == 1);
  CHECK(text.starts_with("warning: " + talk.progress.warnings()[0] + "\n"));
}

TEST_CASE("a stage that ended at its cap of steps is a warning") {
  Talk talk;
  talk.view.stage = Stage::relaxation;
  talk.view.reached_target = false;
  talk.progress.end_stage(talk.view);
  CHECK(count(talk.text(),
              "warning: missed targets of stages = 1 above 0 at strain 0 of relaxation") == 1);
}

#if __has_include(<unistd.h>) && __has_include(<fcntl.h>)

TEST_CASE("on a terminal one line is rewritten and ends with its stage") {
  const int controller = posix_openpt(O_RDWR | O_NOCTTY);
  // Not every place where tests run has terminals to give.
  if (controller < 0 || grantpt(controller) != 0 || unlockpt(controller) != 0) return;
  std::FILE* terminal = std::fopen(ptsname(controller), "w");
  REQUIRE(terminal != nullptr);
  Talk talk;
  Progress progress(terminal);
  const auto begun = std::chrono::steady_clock::now();
  progress.begin_stage(talk.view);
  progress.progress(talk.view);
  // Too soon for another line, unless this very test was held up.
  const bool too_soon = std::chrono::steady_clock::now() - begun < std::chrono::milliseconds(250);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  talk.view.done = 0.5;
  progress.progress(talk.view);
  talk.view.done = 1;
  talk.view.reached_target = true;
  progress.end_stage(talk.view);
  std::fclose(terminal);
  // Once the other end is closed, reads go on until nothing is left and then fail.
  std::string text;
  char buffer[1024];
  for (auto n = read(controller, buffer, sizeof buffer); n > 0;
       n = read(controller, buffer, sizeof buffer))
    text.append(buffer, static_cast<std::size_t>(n));
  close(controller);
  CAPTURE(text);
  // The terminal itself turns the end of a line into "\r\n".
  CHECK(count(text, "\rshear ") == (too_soon ? 3 : 4));
  CHECK(count(text, "\n") == 1);
  CHECK(text.ends_with("\n"));
  CHECK(count(text, " 50.0 %") == 1);
}

#endif
