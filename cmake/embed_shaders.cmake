# Writes OUTPUT, a C++ source with the text of every file of FOLDER whose path, relative to it, stands in FILES
# (separated by |). Run as a script: cmake -DFOLDER=… -DFILES=… -DOUTPUT=… -P embed_shaders.cmake
#
# A string literal must not exceed 65 535 characters on some compilers, and no file comes near; the delimiter keeps
# whatever a shader may hold apart from the end of the literal.

string(REPLACE "|" ";" files "${FILES}")
set(text "#include \"render/embedded_shaders.h\"\n\nnamespace rambla::render {\n\n")
string(APPEND text "const std::unordered_map<std::string_view, std::string_view>& embedded_shaders() {\n")
string(APPEND text "    static const std::unordered_map<std::string_view, std::string_view> texts{\n")
foreach(file IN LISTS files)
  file(READ ${FOLDER}/${file} content)
  string(APPEND text "        {\"${file}\", R\"rambla_glsl(${content})rambla_glsl\"},\n")
endforeach()
string(APPEND text "    };\n    return texts;\n}\n\n}  // namespace rambla::render\n")
file(WRITE ${OUTPUT} "${text}")
