# Writes every GLSL file of a folder into one header as a raw string literal.
# Run as: cmake -D SHADER_DIR=DIR -D HEADER=FILE -P embed_shaders.cmake
set(text "// Made from shaders/ by embed_shaders.cmake. Do not edit.\n#pragma once\n\n")
string(APPEND text "#include \"render/gl/objects/gl_objects.hpp\"\n\nnamespace spindrift::gl::shaders {\n\n")
file(GLOB shaders LIST_DIRECTORIES false ${SHADER_DIR}/*.glsl ${SHADER_DIR}/*.vert ${SHADER_DIR}/*.frag)
foreach(shader IN LISTS shaders)
  get_filename_component(name ${shader} NAME)
  string(REPLACE "." "_" variable ${name})
  file(READ ${shader} source)
  string(APPEND text "inline constexpr ShaderFile ${variable}{\"${name}\", R\"glsl(" "${source}" ")glsl\"};\n\n")
endforeach()
string(APPEND text "}  // namespace spindrift::gl::shaders\n")
file(WRITE ${HEADER} "${text}")
