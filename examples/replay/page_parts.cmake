# SPDX-License-Identifier: BSL-1.0
# Puts the files of the page into a source, as text: the program needs no file when it runs. Sets
# `page_parts` to that source.
set(page_folder ${CMAKE_CURRENT_LIST_DIR})
# In this order, as one program.
set(page_scripts data.js colours.js view.js charts.js details.js player.js)

# The text of FILES one after the other, as a literal in C++.
function(riprap_page_text out)
  set(text "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_folder}/${file})
    file(READ ${page_folder}/${file} part)
    string(APPEND text "${part}")
  endforeach()
  set(${out} "R\"page_text(${text})page_text\"" PARENT_SCOPE)
endfunction()

riprap_page_text(html page.html)
riprap_page_text(style page.css)
riprap_page_text(program ${page_scripts})
set(page_parts ${CMAKE_CURRENT_BINARY_DIR}/replay/page_parts.cpp)
set(source "// SPDX-License-Identifier: BSL-1.0
#include <replay/page_parts.hpp>

namespace replay {

const std::string_view page_html = ${html};
const std::string_view page_style = ${style};
const std::string_view page_program = ${program};

}  // namespace replay
")
file(CONFIGURE OUTPUT ${page_parts} CONTENT "${source}" @ONLY)
