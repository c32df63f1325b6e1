# Writes a page with its styles and scripts into a header, as one raw string literal.
# Run as: cmake -D PAGE=FILE.html -D PARTS=FILE.css,FILE.js,... -D HEADER=FILE -P embed_page.cmake
file(READ ${PAGE} page)
string(REPLACE "," ";" parts "${PARTS}")
foreach(part IN LISTS parts)
  file(READ ${part} source)
  get_filename_component(kind ${part} LAST_EXT)
  string(APPEND all${kind} "${source}\n")
endforeach()
string(REPLACE "/* STYLE */" "${all.css}" page "${page}")
string(REPLACE "/* SCRIPTS */" "${all.js}" page "${page}")
get_filename_component(name ${PAGE} NAME_WE)
file(WRITE ${HEADER}
  "// Made from app/pages/ by embed_page.cmake. Do not edit.\n#pragma once\n\n#include <string_view>\n\n"
  "namespace spindrift::app {\n\ninline constexpr std::string_view ${name}_page = R\"page(${page})page\";\n\n"
  "}  // namespace spindrift::app\n")
