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
  explicit Folder(const World& world)
      : path_(std::filesystem::temp_directory_path() / "riprap_report_test") {
    std::filesystem::remove_all(path_);
    for (const report::Run& run : made_up_study(world).runs) {
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
  const Folder folder({});
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
    CHECK(contains(page, c.at("statement").get<std::string>()));
  }
  CHECK(contains(page, "Of 34 statements of result, 34 **hold**, 0 **hold in part**, 0 are "
                       "**open** and 0 **do not hold**."));
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
  const Folder folder({.samples = 1});
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

TEST_CASE("rows of the study are shown where there are some") {
  const Folder folder({});
  write_report(folder.path());
  CHECK_FALSE(contains(folder.text("paper.md"), "id=\"rows\""));
  Json row = Json::parse(folder.text("runs/WB 14 MPa, sample 1/run.json"));
  row["variation"] = "weak_rock";
  folder.add("rows/wb_14MPa_1_weak_rock/run.json", row.dump());
  write_report(folder.path());
  const std::string page = folder.text("paper.md");
  CHECK(contains(page, "id=\"rows\""));
  CHECK(contains(page, "| WB, 14 MPa | rock of a quarter of the strength | 1 |"));
  CHECK(contains(page, "| WB, 14 MPa | rock of a quarter of the strength | +0.000 |"));
}

TEST_CASE("the same runs give the same report") {
  const Folder folder({.samples = 2});
  write_report(folder.path());
  const std::string first = folder.text("report.html");
  write_report(folder.path());
  CHECK(folder.text("report.html") == first);
}
