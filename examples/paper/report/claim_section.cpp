// SPDX-License-Identifier: BSL-1.0
#include "claim_section.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

namespace report {

namespace {

std::string figure_link(int figure) {
  return "[Fig. " + std::to_string(figure) + "](#fig-" + std::to_string(figure) + ")";
}

std::string mark(const Finding& f) {
  if (!f.counts) return "";
  return f.outcome == Outcome::agrees ? " ✓" : f.outcome == Outcome::against ? " ✗" : " ~";
}

// A row a series of a part, a column a place.
Table numbers_table(const Evidence& evidence) {
  std::vector<std::string> columns;
  std::vector<std::string> series;
  std::map<std::pair<std::string, std::string>, std::string> cells;
  const auto note = [](std::vector<std::string>& all, const std::string& one) {
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  };
  const auto add = [&](const std::string& label, const Finding& f) {
    const std::string row = f.series + (label.empty() ? "" : ", " + label);
    note(columns, f.place);
    note(series, row);
    cells[{row, f.place}] = number_text(f.value) + mark(f);
  };
  for (const Part& part : evidence.parts)
    for (const Finding& f : part.findings) add(part.label, f);
  for (const Finding& f : evidence.shown_only) add("", f);
  Table table{{""}, {}};
  table.head.insert(table.head.end(), columns.begin(), columns.end());
  for (const std::string& s : series) {
    table.rows.push_back({s});
    for (const std::string& c : columns) table.rows.back().push_back(cells[{s, c}]);
  }
  return table;
}

ShownClaim shown(const Claim& claim) {
  const Statement& s = claim.statement;
  return {.json = to_json(claim),
          .section = s.section,
          .text = s.text,
          .rule = s.rule,
          .quantity = s.quantity,
          .verdict = to_text(claim.verdict),
          .reason = claim.reason + (claim.remark.empty() ? "" : " ") + claim.remark,
          .figures = s.figures,
          .numbers = numbers_table(claim.evidence)};
}

// The figure that a text names, or 5.
int named_figure(const std::string& text) {
  const auto at = text.find("Fig. ");
  return at == std::string::npos ? 5 : std::stoi(text.substr(at + 5));
}

// Numbers of another study, by their names there.
std::string plain(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string value_text(const Json& value) {
  if (!value.is_number()) return value.is_string() ? value.get<std::string>() : value.dump();
  const double v = value.get<double>();
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", std::abs(v) < 1e-9 ? 0 : v);
  return buffer;
}

Table flat_table(const Json& numbers) {
  Table table{{"number", "value"}, {}};
  for (const auto& [name, value] : numbers.items()) {
    if (value.is_object()) {
      for (const auto& [inner, v] : value.items())
        table.rows.push_back({plain(name) + ", " + inner, value_text(v)});
    } else {
      table.rows.push_back({plain(name), value_text(value)});
    }
  }
  return table;
}

std::vector<ShownClaim> unconfined_claims(const std::filesystem::path& file) {
  std::vector<ShownClaim> all;
  if (!std::filesystem::exists(file)) return all;
  const Json study = read_json(file);
  for (const Json& c : study.at("claims")) {
    const std::string id = "unconfined_" + std::to_string(all.size() + 1);
    const std::string text = c.at("name");
    const Json json = {{"id", id},
                       {"section", "3.2"},
                       {"figures", {named_figure(text)}},
                       {"statement", text},
                       {"rule", c.at("rule")},
                       {"numbers", c.at("number")},
                       {"verdict", c.at("verdict")},
                       {"reason", c.at("reason")}};
    all.push_back({.json = json,
                   .section = "3.2",
                   .text = text,
                   .rule = c.at("rule"),
                   .quantity = "in the study of unconfined tests",
                   .verdict = c.at("verdict"),
                   .reason = c.at("reason"),
                   .figures = {named_figure(text)},
                   .numbers = flat_table(c.at("number"))});
  }
  return all;
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

void add_claim(Document& document, const ShownClaim& c) {
  document.push_back(Heading{4, "Claim " + std::to_string(c.number) + ": **" + c.verdict + "**",
                             "claim-" + std::to_string(c.number)});
  document.push_back(Paragraph{sentence(c.text) + " (Section " + c.section + " of the paper.)"});
  List lines;
  lines.items.push_back("Reason: " + sentence(c.reason));
  lines.items.push_back("Rule: " + sentence(c.rule));
  document.push_back(lines);
  if (c.numbers.rows.empty()) return;
  document.push_back(Paragraph{"Measured, " + c.quantity + ":"});
  document.push_back(c.numbers);
}

}  // namespace

std::vector<ShownClaim> shown_claims(const Results& results, const std::filesystem::path& folder) {
  std::vector<ShownClaim> all = unconfined_claims(folder / "unconfined" / "unconfined.json");
  for (const Claim& claim : judge_claims(results)) all.push_back(shown(claim));
  std::stable_sort(all.begin(), all.end(), [](const ShownClaim& a, const ShownClaim& b) {
    return a.figures.front() < b.figures.front();
  });
  for (std::size_t i = 0; i < all.size(); ++i) all[i].number = static_cast<int>(i) + 1;
  return all;
}

std::string count_text(const std::vector<ShownClaim>& claims) {
  const auto count = [&](const std::string& verdict) {
    return std::to_string(std::count_if(claims.begin(), claims.end(),
                                        [&](const ShownClaim& c) { return c.verdict == verdict; }));
  };
  std::string out = "Of " + std::to_string(claims.size()) + " statements of result, " +
                    count("holds") + " **hold**, " + count("holds in part") +
                    " **hold in part**, " + count("open") + " are **open** and " +
                    count("does not hold") + " **do not hold**";
  const std::string left = count("not judged");
  return out + (left == "0" ? "." : "; " + left + " could not be judged from these runs.");
}

Table summary_table(const std::vector<ShownClaim>& claims) {
  Table table{{"", "the paper's statement, in our words", "section", "shown with", "verdict"}, {}};
  for (const ShownClaim& c : claims) {
    std::string links;
    for (const int figure : c.figures) links += (links.empty() ? "" : ", ") + figure_link(figure);
    const std::string number = std::to_string(c.number);
    table.rows.push_back({"[" + number + "](#claim-" + number + ")", sentence(c.text), c.section,
                          links, "**" + c.verdict + "**"});
  }
  return table;
}

void add_claims(Document& document, const std::vector<ShownClaim>& claims, int figure) {
  std::string elsewhere;
  for (const ShownClaim& c : claims) {
    if (c.figures.front() == figure) continue;
    if (std::find(c.figures.begin(), c.figures.end(), figure) == c.figures.end()) continue;
    const std::string number = std::to_string(c.number);
    elsewhere += (elsewhere.empty() ? "" : ", ") + ("[" + number + "](#claim-" + number + ")") +
                 " (" + c.verdict + ")";
  }
  for (const ShownClaim& c : claims)
    if (c.figures.front() == figure) add_claim(document, c);
  if (!elsewhere.empty())
    document.push_back(
        Paragraph{"Judged under another figure, and of this one too: claim " + elsewhere + "."});
}

}  // namespace report
