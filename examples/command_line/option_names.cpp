// SPDX-License-Identifier: BSL-1.0
// Errors of the library in the words of a command line.

#include "option_names.hpp"

#include <cctype>

namespace command_line {

namespace {

bool is_part_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void replace_word(std::string& text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || (!is_part_of_name(text[at - 1]) && text[at - 1] != '.');
    const bool ends = end == text.size() || !is_part_of_name(text[end]);
    if (begins && ends) text.replace(at, word.size(), by);
    at += begins && ends ? by.size() : word.size();
  }
}

}  // namespace

std::string in_options(std::string message, const OptionNames& names) {
  for (const auto& [member, option] : names) replace_word(message, member, option);
  for (const auto& [member, option] : names) {
    const std::string bare = member.substr(member.find('.') + 1);
    // A single word could be one of the sentence.
    if (bare.find('_') != std::string::npos) replace_word(message, bare, option);
  }
  return message;
}

}  // namespace command_line
