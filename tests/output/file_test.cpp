// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <riprap/output/file.hpp>
#include <support/temporary_file.hpp>

#if __has_include(<sys/resource.h>)
#include <csignal>
#include <sys/resource.h>
#endif

using namespace riprap;

namespace {

namespace fs = std::filesystem;

template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const SimulationError& error) {
    return error.what();
  }
  return {};
}
std::string refusal_to_write(const std::string& path) {
  return refusal([&] { write_file(path, "some text\n"); });
}

#if __has_include(<sys/resource.h>)
/// Files cannot become longer than this while it lives: a disk that is full from there on.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};
#endif

}  // namespace

TEST_CASE("a written file holds the text byte by byte") {
  const test::TemporaryFile file;
  const std::string text("one\ntwo\r\n\0three", 16);
  write_file(file.path(), text);
  CHECK(file.text() == text);
  CHECK(!fs::exists(file.path() + ".part"));
}

TEST_CASE("a shorter text replaces all of a longer one") {
  const test::TemporaryFile file;
  write_file(file.path(), std::string(100'000, 'x'));
  write_file(file.path(), "short");
  CHECK(file.text() == "short");
  write_file(file.path(), "");
  CHECK(file.text().empty());
  CHECK(fs::exists(file.path()));
}

TEST_CASE("a file that cannot be written is an error that names the path and the reason") {
  const test::TemporaryFile missing_folder;
  const std::string path = missing_folder.path() + "/curve.csv";
  const std::string message = "cannot write " + path + ": No such file or directory";
  CHECK(refusal_to_write(path) == message);
  CHECK(refusal([&] { AppendedFile{path}; }) == message);
  const std::string folder = fs::temp_directory_path().string();
  CHECK(refusal_to_write(folder) == "cannot write " + folder + ": Is a directory");
  CHECK(refusal([&] { AppendedFile{folder}; }) == "cannot write " + folder + ": Is a directory");
}

TEST_CASE("a disk that is full is an error even where a short text was only buffered") {
  // The device on which every write fails; not every system has it.
  if (!fs::exists("/dev/full")) return;
  const std::string message = "cannot write /dev/full: No space left on device";
  CHECK(refusal_to_write("/dev/full") == message);
  CHECK(fs::is_character_file("/dev/full"));
  AppendedFile file("/dev/full");
  for (int i = 0; i < 2; ++i) CHECK(refusal([&] { file.append("row\n"); }) == message);
}

TEST_CASE("a link stays a link, and its target is replaced") {
  const test::TemporaryFile target;
  const test::TemporaryFile link;
  write_file(target.path(), "old");
  fs::create_symlink(target.path(), link.path());
  write_file(link.path(), "new");
  CHECK(fs::is_symlink(link.path()));
  CHECK(target.text() == "new");
}

TEST_CASE("appended text is in the file at once, and replaces what was there") {
  const test::TemporaryFile file;
  write_file(file.path(), "a longer text of an earlier run\n");
  AppendedFile table(file.path());
  CHECK(file.text().empty());
  table.append("a,b\n");
  CHECK(file.text() == "a,b\n");
  table.append("1,2\n");
  CHECK(file.text() == "a,b\n1,2\n");
}

TEST_CASE("a file that is opened again keeps as much as it is told to") {
  const test::TemporaryFile file;
  write_file(file.path(), "a,b\n1,2\n3,");
  {
    AppendedFile table(file.path(), 8);
    CHECK(file.text() == "a,b\n1,2\n");
    table.append("5,6\n");
  }
  CHECK(file.text() == "a,b\n1,2\n5,6\n");
  CHECK(refusal([&] { AppendedFile(file.path(), 13); }) ==
        file.path() + " has 12 bytes: 13 had been written");
  CHECK(file.text().size() == 12);
  CHECK(refusal([&] { AppendedFile(file.path() + "x", 0); }) ==
        "cannot write " + file.path() + "x: No such file or directory");
}

#if __has_include(<sys/resource.h>)

TEST_CASE("a disk that becomes full leaves the old file, and no part of the new one") {
  const test::TemporaryFile file;
  write_file(file.path(), "old\n");
  {
    const FileSizeLimit limit(1000);
    CHECK(refusal([&] { write_file(file.path(), std::string(2000, 'x')); }) ==
          "cannot write " + file.path() + ": File too large");
  }
  CHECK(file.text() == "old\n");
  CHECK(!fs::exists(file.path() + ".part"));
}

TEST_CASE("a disk that becomes full leaves what was appended before, without a part of a row") {
  const test::TemporaryFile file;
  AppendedFile table(file.path());
  table.append("1,2\n");
  {
    const FileSizeLimit limit(10);
    CHECK(refusal([&] { table.append("3,4,5,6,7,8\n"); }) ==
          "cannot write " + file.path() + ": File too large");
    CHECK(file.text() == "1,2\n");
  }
  table.append("9\n");
  CHECK(file.text() == "1,2\n9\n");
}

#endif

TEST_CASE("a folder is made with those above it; one that cannot be made says why") {
  const fs::path folder = fs::temp_directory_path() / "riprap_file_test";
  fs::remove_all(folder);
  make_folder(folder / "a" / "b");
  CHECK(fs::is_directory(folder / "a" / "b"));
  CHECK_NOTHROW(make_folder(folder / "a" / "b"));
  const std::string file = (folder / "file").string();
  write_file(file, "text");
  CHECK(refusal([&] { make_folder(file); }) ==
        "cannot make the folder " + file + ": Not a directory");
  CHECK(refusal([&] { make_folder(file + "/b"); }) ==
        "cannot make the folder " + file + "/b: Not a directory");
  fs::remove_all(folder);
}
