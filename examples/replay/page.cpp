// SPDX-License-Identifier: BSL-1.0
#include "page.hpp"

#include <algorithm>
#include <string_view>

#include <riprap/core/errors.hpp>

#include "pack.hpp"
#include "page_parts.hpp"

namespace replay {

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t present = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t bits = 0;
    for (std::size_t n = 0; n < 3; ++n)
      bits = bits << 8U | (n < present ? static_cast<unsigned char>(bytes[k + n]) : 0U);
    for (std::size_t n = 0; n < 4; ++n)
      out += n <= present ? digits[bits >> (18 - 6 * n) & 63U] : '=';
  }
  return out;
}

namespace {

// What stands between tags must not end them.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

void put(std::string& page, std::string_view mark, std::string_view text) {
  const std::size_t place = page.find(mark);
  if (place == std::string::npos)
    throw riprap::SimulationError("the page has no place for " + std::string(mark));
  page.replace(place, mark.size(), text);
}

}  // namespace

std::string page_of(const RecordedRun& run, const std::string& title) {
  PackedRun packed = pack(run);
  packed.head["title"] = title;
  std::string head =
      packed.head.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
  // "</script>" in the title would end the data.
  for (std::size_t at = 0; (at = head.find('<', at)) != std::string::npos;)
    head.replace(at, 1, "\\u003c");
  std::string page(page_html);
  put(page, "{{title}}", escaped(title));
  put(page, "{{style}}", page_style);
  put(page, "{{program}}", page_program);
  // Last, for they are long.
  put(page, "{{head}}", head);
  put(page, "{{arrays}}", base64(packed.arrays.bytes()));
  return page;
}

}  // namespace replay
