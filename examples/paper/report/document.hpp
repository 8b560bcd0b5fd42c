// SPDX-License-Identifier: BSL-1.0
#pragma once
// A report as a list of blocks, written as one HTML page or as Markdown with pictures beside it.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace report {

// Texts may hold `code`, *emphasis*, **bold** and [links](#anchor), in each other where that has a
// meaning.
struct Heading {
  int level = 1;
  std::string text;
  std::string anchor;  // or nothing
};
struct Paragraph {
  std::string text;
};
struct Code {
  std::string text;
};
struct List {
  std::vector<std::string> items;
};
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};
struct Picture {
  std::string name;  // of its file, without .svg
  std::string caption;
  std::string svg;
};
// Beside each other.
struct Pictures {
  std::vector<Picture> pictures;
};

using Block = std::variant<Heading, Paragraph, Code, List, Table, Pictures>;
using Document = std::vector<Block>;

// Self-contained: pictures are part of the page, and nothing is fetched.
std::string to_html(const Document& document, const std::string& title);
// Pictures are linked as FOLDER/NAME.svg.
std::string to_markdown(const Document& document, const std::string& folder);
// Every picture of the document as NAME.svg.
void save_pictures(const Document& document, const std::filesystem::path& folder);

}  // namespace report
