// SPDX-License-Identifier: BSL-1.0
// The report as Markdown, with its pictures in files.

#include <riprap/output/file.hpp>

#include "document.hpp"

namespace report {

namespace {

// Outside of code a "<" would begin an element; a "|" would end a cell of a table.
std::string escaped(const std::string& text) {
  std::string out;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (c == '<' && !code)
      out += "&lt;";
    else if (c == '|')
      out += "\\|";
    else
      out += c;
  }
  return out;
}

std::string row(const std::vector<std::string>& cells) {
  std::string out = "|";
  for (const std::string& cell : cells) out += " " + escaped(cell) + " |";
  return out + "\n";
}

struct MarkdownBlock {
  std::string folder;

  std::string operator()(const Heading& h) const {
    const std::string anchor = h.anchor.empty() ? "" : "<a id=\"" + h.anchor + "\"></a>\n\n";
    return anchor + std::string(static_cast<std::size_t>(h.level), '#') + " " + escaped(h.text) +
           "\n\n";
  }
  std::string operator()(const Paragraph& p) const { return escaped(p.text) + "\n\n"; }
  std::string operator()(const Code& c) const { return "```sh\n" + c.text + "```\n\n"; }
  std::string operator()(const List& list) const {
    std::string out;
    for (const std::string& item : list.items) out += "- " + escaped(item) + "\n";
    return out + "\n";
  }
  std::string operator()(const Table& table) const {
    std::string out = row(table.head) + "|";
    for (std::size_t i = 0; i < table.head.size(); ++i) out += "---|";
    out += "\n";
    for (const auto& cells : table.rows) out += row(cells);
    return out + "\n";
  }
  std::string operator()(const Pictures& pictures) const {
    if (pictures.pictures.size() == 1) {
      const Picture& p = pictures.pictures.front();
      return image(p) + "\n\n" + (p.caption.empty() ? "" : p.caption + "\n\n");
    }
    Table beside;
    beside.rows.emplace_back();
    std::string out;
    for (const Picture& p : pictures.pictures) {
      beside.head.push_back(p.caption);
      beside.rows.back().push_back(image(p));
    }
    return (*this)(beside);
  }

  [[nodiscard]] std::string image(const Picture& p) const {
    return "![" + (p.caption.empty() ? p.name : p.caption) + "](" + folder + "/" + p.name + ".svg)";
  }
};

}  // namespace

std::string to_markdown(const Document& document, const std::string& folder) {
  std::string out;
  for (const Block& block : document) out += std::visit(MarkdownBlock{folder}, block);
  while (out.ends_with("\n\n")) out.pop_back();
  return out;
}

void save_pictures(const Document& document, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Block& block : document)
    if (const auto* row = std::get_if<Pictures>(&block))
      for (const Picture& p : row->pictures)
        riprap::write_file((folder / (p.name + ".svg")).string(), p.svg);
}

}  // namespace report
