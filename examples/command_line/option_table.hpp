// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of a program in one table: each with the members of the library that it sets, so that
// errors can name the option, and with its value as text, so that a run can be repeated.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "number.hpp"
#include "option_names.hpp"

namespace command_line {

// A member that an option sets.
template <class Value>
struct Member {
  Value* value;
  std::string name;     // as errors of the library have it, such as "Rock.young"
  std::string of = {};  // the choice that it belongs to, such as "hobbs"; or to all
};

class OptionTable {
 public:
  explicit OptionTable(CLI::App& app);
  OptionTable(const OptionTable&) = delete;
  OptionTable& operator=(const OptionTable&) = delete;

  // Options from here on stand under this title. Those of a group that is not written decide how
  // the program runs, and not what comes out.
  void begin_group(const std::string& title, bool written = true);

  // One of several values. It may itself belong to one value of another choice.
  CLI::Option* add_choice(const std::string& option, std::string& value,
                          const std::vector<std::string>& values, const std::string& description,
                          const std::string& choice = {}, const std::string& of = {});
  // Text that `read` takes, or refuses with CLI::ValidationError, and `write` gives back.
  CLI::Option* add_text(const std::string& option, const std::string& description,
                        std::function<void(const std::string&)> read,
                        std::function<std::string()> write, std::vector<std::string> members = {});
  CLI::Option* add_text(const std::string& option, std::string& value,
                        const std::string& description);
  // Off unless given. It may belong to one value of a choice.
  CLI::Option* add_flag(const std::string& option, bool& value, const std::string& description,
                        const std::string& choice = {}, const std::string& of = {});
  // A number. It may set a member for each of some values of a choice, and has no meaning with the
  // others.
  template <class Number>
  CLI::Option* add_number(const std::string& option, const std::vector<Member<Number>>& members,
                          const std::string& description, const std::string& choice = {});
  template <class Number>
  CLI::Option* add_number(const std::string& option, Number& value, const std::string& member,
                          const std::string& description) {
    return add_number(option, std::vector<Member<Number>>{{&value, member}}, description);
  }

  [[nodiscard]] bool is_given(const std::string& option) const;
  // Throws CLI::ValidationError for an option that was given and has no meaning with what was
  // chosen.
  void check_choices() const;
  // Throws CLI::ValidationError if one of `options` was given, which the value of option `by` sets;
  // leaves them out of the file of parameters.
  void exclude(const std::vector<std::string>& options, const std::string& by);
  // Which option sets which member.
  [[nodiscard]] OptionNames names() const;
  // Every option that has a meaning with what was chosen, with its value, as a file in TOML.
  [[nodiscard]] std::string toml() const;

 private:
  struct Entry {
    CLI::Option* option = nullptr;
    std::string name{};  // of the option
    std::string group{};
    bool written = true;
    std::vector<std::string> members{};
    std::string choice{};           // the option that decides whether this one has a meaning
    std::vector<std::string> of{};  // with which of its values
    std::vector<std::function<std::string()>> texts{};  // the value, for each of these
    bool quoted = false;
  };

  CLI::Option* add(Entry entry, const std::string& description, const std::string& type,
                   std::function<void(const std::string&)> read);
  [[nodiscard]] const Entry& entry(const std::string& option) const;
  // Which of the values of its choice is chosen; `of.size()` if it has no meaning.
  [[nodiscard]] std::size_t chosen(const Entry& entry) const;

  CLI::App& app_;
  std::string group_;
  bool written_ = true;
  std::vector<Entry> entries_;
};

template <class Number>
CLI::Option* OptionTable::add_number(const std::string& option,
                                     const std::vector<Member<Number>>& members,
                                     const std::string& description, const std::string& choice) {
  Entry entry{.name = option, .choice = choice, .quoted = false};
  for (const Member<Number>& m : members) {
    entry.members.push_back(m.name);
    entry.of.push_back(m.of);
    entry.texts.push_back([value = m.value] { return text_of(*value); });
  }
  return add(std::move(entry), description, std::floating_point<Number> ? "FLOAT" : "UINT",
             [option, members](const std::string& text) {
               const auto number = number_from<Number>(text);
               if (!number)
                 throw CLI::ValidationError(option,
                                            "'" + text + "' is not " + rule_of_number<Number>());
               for (const Member<Number>& m : members) *m.value = *number;
             });
}

}  // namespace command_line
