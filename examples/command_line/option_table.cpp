// SPDX-License-Identifier: BSL-1.0
// The options of a program in one table.

#include "option_table.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include <riprap/core/version.hpp>

namespace command_line {

namespace {

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : ", ") + part;
  return out;
}

}  // namespace

OptionTable::OptionTable(CLI::App& app) : app_(app) {}

void OptionTable::begin_group(const std::string& title, bool written) {
  group_ = title;
  written_ = written;
}

CLI::Option* OptionTable::add(Entry entry, const std::string& description, const std::string& type,
                              std::function<void(const std::string&)> read) {
  const std::string only = entry.choice.empty() || entry.of.front().empty()
                               ? ""
                               : "; with " + entry.choice + " " + joined(entry.of);
  // "0.7", or "0.7 (hobbs), 0.8 (franklin)".
  std::vector<std::string> defaults;
  for (const auto& text : entry.texts) defaults.push_back(text());
  const bool differ = std::set<std::string>(defaults.begin(), defaults.end()).size() > 1;
  for (std::size_t i = 0; i < defaults.size() && differ; ++i)
    defaults[i] += " (" + entry.of[i] + ")";
  if (!differ) defaults.resize(1);

  entry.option = app_.add_option(
      entry.name,
      [read = std::move(read)](const CLI::results_t& results) {
        read(results.at(0));
        return true;
      },
      description + only);
  entry.option->type_name(type)->default_str(joined(defaults))->group(group_);
  entry.group = group_;
  entry.written = written_;
  entries_.push_back(std::move(entry));
  return entries_.back().option;
}

CLI::Option* OptionTable::add_choice(const std::string& option, std::string& value,
                                     const std::vector<std::string>& values,
                                     const std::string& description, const std::string& choice,
                                     const std::string& of) {
  Entry entry{.name = option,
              .choice = choice,
              .of = {of},
              .texts = {[&value] { return value; }},
              .quoted = true};
  return add(std::move(entry), description, "TEXT:{" + CLI::detail::join(values, ",") + "}",
             [option, &value, values](const std::string& text) {
               if (std::find(values.begin(), values.end(), text) == values.end())
                 throw CLI::ValidationError(option, "'" + text + "' is none of " + joined(values));
               value = text;
             });
}

CLI::Option* OptionTable::add_text(const std::string& option, const std::string& description,
                                   std::function<void(const std::string&)> read,
                                   std::function<std::string()> write,
                                   std::vector<std::string> members) {
  Entry entry{.name = option,
              .members = std::move(members),
              .of = {""},
              .texts = {std::move(write)},
              .quoted = true};
  return add(std::move(entry), description, "TEXT", std::move(read));
}

CLI::Option* OptionTable::add_text(const std::string& option, std::string& value,
                                   const std::string& description) {
  return add_text(
      option, description,
      [option, &value](const std::string& text) {
        if (text.empty()) throw CLI::ValidationError(option, "must not be empty");
        value = text;
      },
      [&value] { return value; });
}

CLI::Option* OptionTable::add_flag(const std::string& option, bool& value,
                                   const std::string& description, const std::string& choice,
                                   const std::string& of) {
  Entry entry{.option = app_.add_flag(
                  option, value, description + (of.empty() ? "" : "; with " + choice + " " + of)),
              .name = option,
              .group = group_,
              .written = written_,
              .choice = choice,
              .of = {of},
              .texts = {[&value] { return std::string(value ? "true" : "false"); }},
              .quoted = false};
  entry.option->group(group_);
  entries_.push_back(std::move(entry));
  return entries_.back().option;
}

const OptionTable::Entry& OptionTable::entry(const std::string& option) const {
  for (const Entry& e : entries_)
    if (e.name == option) return e;
  throw std::logic_error("there is no option " + option);
}

bool OptionTable::is_given(const std::string& option) const {
  return entry(option).option->count() > 0;
}

std::size_t OptionTable::chosen(const Entry& e) const {
  if (e.choice.empty()) return 0;
  const std::string value = entry(e.choice).texts.front()();
  return static_cast<std::size_t>(std::find(e.of.begin(), e.of.end(), value) - e.of.begin());
}

void OptionTable::check_choices() const {
  for (const Entry& e : entries_)
    if (e.option->count() > 0 && chosen(e) == e.of.size())
      throw CLI::ValidationError(e.name, "goes with " + e.choice + " " + joined(e.of) + "; with " +
                                             e.choice + " " + entry(e.choice).texts.front()() +
                                             " it has no meaning");
}

void OptionTable::exclude(const std::vector<std::string>& options, const std::string& by) {
  for (const std::string& option : options)
    if (is_given(option))
      throw CLI::ValidationError(option, "is set by " + by + " " + entry(by).texts.front()() +
                                             " and cannot be given with it");
  for (Entry& e : entries_)
    if (std::find(options.begin(), options.end(), e.name) != options.end()) e.written = false;
}

OptionNames OptionTable::names() const {
  OptionNames out;
  for (const Entry& e : entries_)
    for (const std::string& member : e.members)
      if (!member.empty()) out.emplace_back(member, e.name);
  return out;
}

std::string OptionTable::toml() const {
  std::string out = "# The parameters of a run of riprap " + std::string(riprap::version) +
                    "; --config with the name of this file repeats it.\n";
  std::string group;
  for (const Entry& e : entries_) {
    const std::size_t k = chosen(e);
    if (!e.written || k == e.of.size()) continue;
    const std::string value = e.texts[k]();
    if (e.quoted && value.empty()) continue;  // a text that was not given
    if (e.group != group) out += "\n# " + e.group + "\n";
    group = e.group;
    // Strings of JSON are strings of TOML.
    out += e.name.substr(2) + " = " + (e.quoted ? nlohmann::json(value).dump() : value) + "\n";
  }
  return out;
}

}  // namespace command_line
