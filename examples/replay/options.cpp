// SPDX-License-Identifier: BSL-1.0
// Command line of the replay.

#include "options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

#include <riprap/output/frames.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"

namespace replay {

namespace fs = std::filesystem;

std::string Options::frames_file() const {
  const fs::path inner = riprap::FrameWriter::file_in(fs::path(folder) / "frames");
  std::error_code ignored;
  return (fs::exists(inner, ignored) ? inner : riprap::FrameWriter::file_in(folder)).string();
}

std::string Options::out_file() const {
  return out.empty() ? (fs::path(folder) / "replay.html").string() : out;
}

std::string Options::title() const {
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(folder, ignored);
  const fs::path name = whole.filename() == "frames" ? whole.parent_path() : whole;
  return name.has_filename() ? name.filename().string() : name.parent_path().filename().string();
}

Options read_options(int argc, char** argv) {
  Options o;
  CLI::App app{
      "Packs the frames that a run has left (examples/run biaxial --frames) into one page for a\n"
      "browser. The page has everything in it: it may be sent, and opened without a network."};
  app.get_formatter()->column_width(42);
  app.add_option("DIR", o.folder, "folder of the run")->required();
  command_line::OptionTable table(app);
  table.begin_group("Options");
  table.add_text("--out", o.out, "file for the page; unless given, replay.html in DIR");
  table
      .add_number("--every", o.every, "every", "frame that is taken; those of stage ends are kept")
      ->check(CLI::Range(1U, 1000000U));
  command_line::parse_or_exit(app, [&] {
    app.parse(argc, argv);
    if (o.folder.empty()) throw CLI::ValidationError("DIR", "must not be empty");
  });
  o.names = table.names();
  return o;
}

}  // namespace replay
