// SPDX-License-Identifier: BSL-1.0
#include <paper/report/report.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <riprap/output/file.hpp>
#include <support/message_of.hpp>

#include <paper/made_up_study.hpp>

using report::Json;
using report::Mode;
using riprap::test::contains;
using riprap::test::made_up_study;
using riprap::test::World;

namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A study in a folder that is gone with it.
class Folder {
 public:
  Folder(const World& world, bool pinned)
      : path_(std::filesystem::temp_directory_path() / "riprap_report_test") {
    std::filesystem::remove_all(path_);
    for (const report::Run& run : made_up_study(world, pinned).runs) {
      const auto place = path_ / "runs" / run.name();
      std::filesystem::create_directories(place);
      riprap::write_file((place / "run.json").string(), riprap::test::run_json(run).dump());
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string text(const std::string& name) const { return text_of(path_ / name); }
  void add(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    riprap::write_file((path_ / name).string(), text);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("a report answers every figure and every claim, in all its files") {
  const Folder folder({}, true);
  write_report(folder.path());
  const std::string html = folder.text("report.html");
  const std::string page = folder.text("paper.md");
  for (int figure = 3; figure <= 21; ++figure) {
    CAPTURE(figure);
    CHECK(contains(html, "id=\"fig-" + std::to_string(figure) + "\""));
    CHECK(contains(page, "### Fig. " + std::to_string(figure) + ": "));
  }
  const Json claims = Json::parse(folder.text("claims.json"));
  CHECK(claims.size() >= 20);
  for (const Json& c : claims) {
    CHECK(c.at("verdict") == "holds");
    CHECK(c.at("pinned").at("verdict") == "holds");
    CHECK(contains(page, c.at("statement").get<std::string>()));
  }
  CHECK(contains(page, "Of 34 statements of result, 34 **hold**, 0 **hold in part** and 0 **do not "
                       "hold**."));
  CHECK(contains(page, "| friction coefficient | 0.5 | Table 1 |"));
  CHECK(contains(page, "made up (NB 0.5 MPa, sample 1; "));
  // Every picture that the page shows is there.
  for (auto at = page.find("](images/"); at != std::string::npos;
       at = page.find("](images/", at + 1)) {
    const std::string name = page.substr(at + 2, page.find(')', at) - at - 2);
    CHECK_MESSAGE(std::filesystem::exists(folder.path() / name), name);
  }
}

TEST_CASE("pictures of the runs and the unconfined tests are taken in") {
  const Folder folder({.samples = 1}, false);
  const std::string svg = "<svg>\n<rect/>\n</svg>\n";
  folder.add("runs/WB 2 MPa, sample 1/movement_06.svg", svg);
  folder.add("unconfined/fig4_poisson.svg", svg);
  const Json claim = {{"name", "Rat falls (Fig. 4)"},
                      {"rule", "as it says"},
                      {"number", {{"change", -0.1}}},
                      {"verdict", "holds in part"},
                      {"reason", "so"}};
  folder.add("unconfined/unconfined.json", Json{{"claims", Json::array({claim})}}.dump());
  write_report(folder.path());
  const std::string page = folder.text("paper.md");
  CHECK(contains(page, "![WB, 6 %](images/paper/fig_10_wb_2MPa_movement_06.svg)"));
  CHECK(contains(page, "Not drawn in these runs: NB, 6 %; "));
  CHECK(contains(page, "One sample has no scatter to judge by"));
  CHECK(contains(page, "![fig_04](images/paper/fig_04.svg)"));
  CHECK(contains(
      page,
      "| [1](#claim-1) | Rat falls (Fig. 4). | 3.2 | [Fig. 4](#fig-4) | **holds in part** |"));
  CHECK(text_of(folder.path() / "images/paper/fig_04.svg") == svg);
}

TEST_CASE("causes are shown where an outcome is missing, and only there") {
  for (const bool as_claimed : {true, false}) {
    const Folder folder({.as_claimed = as_claimed}, false);
    folder.add("causes/wb_8MPa_1_slow_shear/run.json",
               folder.text("runs/WB 8 MPa, sample 1/run.json"));
    write_report(folder.path());
    CHECK(contains(folder.text("paper.md"), "| 8 MPa | haste: half") == !as_claimed);
  }
}

TEST_CASE("the same runs give the same report") {
  const Folder folder({.samples = 2}, false);
  write_report(folder.path());
  const std::string first = folder.text("report.html");
  write_report(folder.path());
  CHECK(folder.text("report.html") == first);
}
