// SPDX-License-Identifier: BSL-1.0
#include <paper/report/document.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <support/message_of.hpp>

using namespace report;
using riprap::test::contains;

namespace {

const Document example{
    Heading{1, "Of a & b", "top"},
    Paragraph{"If `a < b` then **holds**, see [there](#top) [or not]; a < b > c."},
    List{{"one", "two"}},
    Table{{"x", "y"}, {{"1|2", "**does not hold**"}}},
    Pictures{{{"one", "first", "<svg>1</svg>\n"}, {"two", "second", "<svg>2</svg>\n"}}},
    Pictures{{{"alone", "", "<svg>3</svg>\n"}}},
    Code{"run < this\n"}};

}  // namespace

TEST_CASE("the page in HTML") {
  const std::string html = to_html(example, "A & B");
  for (const std::string part :
       {"<title>A &amp; B</title>", "<h1 id=\"top\">Of a &amp; b</h1>",
        "<p>If <code>a &lt; b</code> then <strong class=\"holds\">holds</strong>, see "
        "<a href=\"#top\">there</a> [or not]; a &lt; b &gt; c.</p>",
        "<ul>\n<li>one</li>\n<li>two</li>\n</ul>", "<tr><th>x</th><th>y</th></tr>",
        "<tr><td>1|2</td><td><strong class=\"fails\">does not hold</strong></td></tr>",
        "<svg>1</svg>\n<figcaption>first</figcaption>", "<svg>3</svg>",
        "<pre>run &lt; this\n</pre>"})
    CHECK_MESSAGE(contains(html, part), part);
  // Nothing is fetched, nothing is run.
  for (const std::string part : {"<script", "src=", "http://", "https://", "@import", "<link"})
    CHECK_MESSAGE(!contains(html, part), part);
}

TEST_CASE("no mark of Markdown is left on the page in HTML, wherever a text may stand") {
  const std::string text = "*One two*, **three *four* `f*i*ve`**, [`six` *7*](#x) and (*eight*).";
  const std::string html =
      "<em>One two</em>, <strong>three <em>four</em> <code>f*i*ve</code></strong>, "
      "<a href=\"#x\"><code>six</code> <em>7</em></a> and (<em>eight</em>).";
  for (const Document& document :
       {Document{Heading{2, text, ""}}, Document{Paragraph{text}}, Document{List{{text}}},
        Document{Table{{text}, {}}}, Document{Table{{"x"}, {{text}}}},
        Document{Pictures{{{"one", text, "<svg/>"}}}}})
    CHECK(contains(to_html(document, "title"), html));
}

TEST_CASE("what only looks like a mark is plain text, and no text is without end") {
  const auto page = [](const std::string& text) { return to_html({Paragraph{text}}, "title"); };
  for (const std::string text :
       {"29.9* and 34.9*", "2 * 3 * 4", "a*b*c", "* one", "one *two", "**", "*", "***", "[open](x",
        "[open", "[a] (b)", "open `code", "**open"})
    CHECK_MESSAGE(contains(page(text), "<p>" + text + "</p>"), text);
  CHECK(contains(page("[or not]; see [there](#top)"),
                 "<p>[or not]; see <a href=\"#top\">there</a></p>"));
}

TEST_CASE("the page in Markdown") {
  const std::string text = to_markdown(example, "images");
  for (const std::string part :
       {"<a id=\"top\"></a>\n\n# Of a & b\n",
        "If `a < b` then **holds**, see [there](#top) [or not]; a &lt; b > c.\n", "- one\n- two\n",
        "| x | y |\n|---|---|\n| 1\\|2 | **does not hold** |\n",
        "| first | second |\n|---|---|\n| ![first](images/one.svg) | ![second](images/two.svg) |\n",
        "\n![alone](images/alone.svg)\n", "```sh\nrun < this\n```\n"})
    CHECK_MESSAGE(contains(text, part), part);
  CHECK(text.ends_with("```\n"));
}

TEST_CASE("pictures are saved under their names") {
  const auto folder = std::filesystem::temp_directory_path() / "riprap_document_test";
  std::filesystem::remove_all(folder);
  save_pictures(example, folder / "a" / "b");
  std::ifstream in(folder / "a" / "b" / "two.svg");
  CHECK(std::string(std::istreambuf_iterator<char>(in), {}) == "<svg>2</svg>\n");
  CHECK(std::filesystem::exists(folder / "a" / "b" / "alone.svg"));
  std::filesystem::remove_all(folder);
}
