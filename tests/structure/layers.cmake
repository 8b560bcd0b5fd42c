# SPDX-License-Identifier: BSL-1.0
# Includes run downwards only: a header may include its own layer and those before it in this list.
# Outside the layers there is riprap.hpp alone, for users: none of them includes it.
set(layers core material geometry particle contact bond dynamics stress breakage acceleration measurement
           simulation experiment output checkpoint conformance)

get_filename_component(include ${CMAKE_CURRENT_LIST_DIR}/../../include ABSOLUTE)
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/riprap/*.hpp ${include}/riprap/*.ipp)
list(REMOVE_ITEM headers riprap/riprap.hpp)

set(violations "")
foreach(header IN LISTS headers)
  string(REGEX REPLACE "^riprap/([^/]+).*" "\\1" layer ${header})
  list(FIND layers ${layer} rank)
  if(rank EQUAL -1)
    string(APPEND violations "\n  include/${header}: ${layer} is not a layer")
    continue()
  endif()

  file(READ ${include}/${header} text)
  string(REGEX MATCHALL "\n[ \t]*#[ \t]*include[ \t]*[<\"][^>\"\n]+[>\"]" lines "\n${text}")
  foreach(line IN LISTS lines)
    string(STRIP "${line}" line)
    string(REGEX REPLACE ".*[<\"](.+)[>\"]" "\\1" target "${line}")
    get_filename_component(beside ${include}/${header}/../${target} ABSOLUTE)
    if(line MATCHES "\"" AND EXISTS ${beside})
      file(RELATIVE_PATH target ${include} ${beside})
    endif()
    if(target MATCHES "^riprap/([^/]+)")
      list(FIND layers ${CMAKE_MATCH_1} target_rank)
      if(target_rank GREATER rank OR target STREQUAL riprap/riprap.hpp)
        string(APPEND violations "\n  include/${header}: ${line}")
      endif()
    endif()
  endforeach()
endforeach()

if(violations)
  list(JOIN layers ", " layers)
  message(FATAL_ERROR "A header may include only its own layer and those before it in this list:\n"
                      "  ${layers}\nand never riprap.hpp. Against this rule:${violations}\n")
endif()
