// SPDX-License-Identifier: BSL-1.0
// The report as one HTML page.

#include <cctype>
#include <string>

#include "document.hpp"

namespace report {

namespace {

constexpr auto style = R"(
body { font: 15px/1.5 Georgia, serif; color: #222; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3, th { font-family: Helvetica, Arial, sans-serif; line-height: 1.25; }
h2 { border-bottom: 1px solid #bbb; margin-top: 2.5rem; }
table { border-collapse: collapse; margin: .8rem 0; font-size: 13px; }
th, td { border: 1px solid #ccc; padding: .2rem .45rem; text-align: left; vertical-align: top; }
th { background: #f0f0f0; }
code, pre { font-size: 13px; background: #f4f4f4; }
pre { padding: .6rem; overflow-x: auto; }
.scroll { overflow-x: auto; }
.pictures { display: flex; flex-wrap: wrap; gap: .6rem; }
figure { flex: 1 1 18rem; margin: 0; break-inside: avoid; }
figcaption { font-size: 13px; text-align: center; }
svg { max-width: 100%; height: auto; display: block; margin: 0 auto; }
.holds { color: #14692b; } .in-part { color: #8a5a00; } .open { color: #555; } .fails { color: #a11d1d; }
@media print { body { max-width: none; margin: 0; font-size: 10pt; } table { font-size: 8pt; }
  h2, h3 { break-after: avoid; } tr { break-inside: avoid; } a { color: inherit; } }
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string inline_html(const std::string& text);

// Between a mark and its next one.
bool take(const std::string& text, std::size_t& at, const std::string& mark, std::string& inner) {
  if (text.compare(at, mark.size(), mark) != 0) return false;
  const std::size_t from = at + mark.size();
  const std::size_t end = text.find(mark, from);
  if (end == std::string::npos) return false;
  inner = text.substr(from, end - from);
  at = end + mark.size();
  return true;
}

// *Emphasis*: an asterisk that stands alone, as between two factors, or after a word, as that of a
// footnote does, begins none.
bool take_emphasis(const std::string& text, std::size_t& at, std::string& inner) {
  const auto is = [&](std::size_t i, auto&& kind) {
    return i < text.size() && kind(static_cast<unsigned char>(text[i]));
  };
  const auto blank = [](int c) { return std::isspace(c) != 0 || c == '*'; };
  const auto word = [](int c) { return std::isalnum(c) != 0; };
  if (text[at] != '*' || at + 1 >= text.size() || is(at + 1, blank) || (at > 0 && is(at - 1, word)))
    return false;
  for (std::size_t end = text.find('*', at + 2); end != std::string::npos;
       end = text.find('*', end + 1))
    if (!is(end - 1, blank) && !is(end + 1, word)) {
      inner = text.substr(at + 1, end - at - 1);
      at = end + 1;
      return true;
    }
  return false;
}

// [text](target)
bool take_link(const std::string& text, std::size_t& at, std::string& inner, std::string& target) {
  if (text[at] != '[') return false;
  const std::size_t middle = text.find(']', at);
  if (middle == std::string::npos || text.compare(middle, 2, "](") != 0) return false;
  const std::size_t end = text.find(')', middle);
  if (end == std::string::npos) return false;
  inner = text.substr(at + 1, middle - at - 1);
  target = text.substr(middle + 2, end - middle - 2);
  at = end + 1;
  return true;
}

std::string strong(const std::string& text) {
  const std::string colour = text == "holds"           ? " class=\"holds\""
                             : text == "holds in part" ? " class=\"in-part\""
                             : text == "open"          ? " class=\"open\""
                             : text == "does not hold" ? " class=\"fails\""
                                                       : "";
  return "<strong" + colour + ">" + inline_html(text) + "</strong>";
}

std::string inline_html(const std::string& text) {
  std::string out;
  std::string inner;
  std::string target;
  for (std::size_t at = 0; at < text.size();) {
    if (take(text, at, "`", inner))
      out += "<code>" + escaped(inner) + "</code>";
    else if (take(text, at, "**", inner))
      out += strong(inner);
    else if (take_emphasis(text, at, inner))
      out += "<em>" + inline_html(inner) + "</em>";
    else if (take_link(text, at, inner, target))
      out += "<a href=\"" + escaped(target) + "\">" + inline_html(inner) + "</a>";
    else
      out += escaped(text.substr(at++, 1));
  }
  return out;
}

std::string row(const std::vector<std::string>& cells, const std::string& element) {
  std::string out = "<tr>";
  for (const std::string& cell : cells)
    out += "<" + element + ">" + inline_html(cell) + "</" + element + ">";
  return out + "</tr>\n";
}

struct HtmlBlock {
  std::string operator()(const Heading& h) const {
    const std::string element = "h" + std::to_string(h.level);
    const std::string id = h.anchor.empty() ? "" : " id=\"" + h.anchor + "\"";
    return "<" + element + id + ">" + inline_html(h.text) + "</" + element + ">\n";
  }
  std::string operator()(const Paragraph& p) const {
    return "<p>" + inline_html(p.text) + "</p>\n";
  }
  std::string operator()(const Code& c) const { return "<pre>" + escaped(c.text) + "</pre>\n"; }
  std::string operator()(const List& list) const {
    std::string out = "<ul>\n";
    for (const std::string& item : list.items) out += "<li>" + inline_html(item) + "</li>\n";
    return out + "</ul>\n";
  }
  std::string operator()(const Table& table) const {
    std::string out = "<div class=\"scroll\"><table>\n" + row(table.head, "th");
    for (const auto& cells : table.rows) out += row(cells, "td");
    return out + "</table></div>\n";
  }
  std::string operator()(const Pictures& row_of) const {
    std::string out = "<div class=\"pictures\">\n";
    for (const Picture& p : row_of.pictures)
      out += "<figure>\n" + p.svg + "<figcaption>" + inline_html(p.caption) +
             "</figcaption></figure>\n";
    return out + "</div>\n";
  }
};

}  // namespace

std::string to_html(const Document& document, const std::string& title) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n";
  for (const Block& block : document) out += std::visit(HtmlBlock{}, block);
  return out + "</body>\n</html>\n";
}

}  // namespace report
