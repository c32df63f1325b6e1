# Writes a page with its style and scripts into a header, as one raw string literal.
# Run as: cmake -D PAGE=FILE.html -D STYLE=FILE.css -D SCRIPTS=FILE.js,... -D HEADER=FILE -P embed_page.cmake
file(READ ${PAGE} page)
file(READ ${STYLE} style)
string(REPLACE "," ";" script_files "${SCRIPTS}")
set(scripts "")
foreach(script IN LISTS script_files)
  file(READ ${script} source)
  string(APPEND scripts "${source}\n")
endforeach()
string(REPLACE "/* STYLE */" "${style}" page "${page}")
string(REPLACE "/* SCRIPTS */" "${scripts}" page "${page}")
get_filename_component(name ${PAGE} NAME_WE)
file(WRITE ${HEADER}
  "// Made from app/pages/ by embed_page.cmake. Do not edit.\n#pragma once\n\n#include <string_view>\n\n"
  "namespace spindrift::app {\n\ninline constexpr std::string_view ${name}_page = R\"page(${page})page\";\n\n"
  "}  // namespace spindrift::app\n")
