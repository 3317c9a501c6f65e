# cmake -DINPUT=file -DFUNCTION=name -DOUTPUT=file.cpp -P embed.cmake
# Writes a C++ source whose function symscene::NAME() returns the text of the file. Raw strings in chunks: every compiler
# accepts these, and fast.
file(READ ${INPUT} text)
string(LENGTH "${text}" length)
set(source "#include <string_view>\n\nnamespace symscene {\n\nstd::string_view ${FUNCTION}();\n")
string(APPEND source "std::string_view ${FUNCTION}() {\n  return {\n")
set(begin 0)
while(begin LESS length)
  string(SUBSTRING "${text}" ${begin} 8000 chunk)
  string(APPEND source "R\"~text~(${chunk})~text~\"\n")
  math(EXPR begin "${begin} + 8000")
endwhile()
string(APPEND source "  , ${length}};\n}\n\n}  // namespace symscene\n")
file(WRITE ${OUTPUT} "${source}")
