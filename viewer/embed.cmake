# cmake -DPAGE=page.html -DOUTPUT=page.cpp -P embed.cmake
# Writes the page as a C++ source. Raw strings in chunks: what every compiler takes and takes fast.
file(READ ${PAGE} page)
string(LENGTH "${page}" length)
set(source "#include \"page_template.hpp\"\n\nnamespace symscene {\n\nstd::string_view page_template() {\n  return {\n")
set(begin 0)
while(begin LESS length)
  string(SUBSTRING "${page}" ${begin} 8000 chunk)
  string(APPEND source "R\"~page~(${chunk})~page~\"\n")
  math(EXPR begin "${begin} + 8000")
endwhile()
string(APPEND source "  , ${length}};\n}\n\n}  // namespace symscene\n")
file(WRITE ${OUTPUT} "${source}")
