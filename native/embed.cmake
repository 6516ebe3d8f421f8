# Writes files as text into a header, one constant each in NAMESPACE:
# cmake -DHEADER=... -DNAMESPACE=... -DFILES=a;b -P embed.cmake
set(text "#pragma once\n\nnamespace ${NAMESPACE} {\n\n")
foreach(file ${FILES})
  get_filename_component(name ${file} NAME)
  string(MAKE_C_IDENTIFIER ${name} name)
  file(READ ${file} content)
  string(APPEND text "inline constexpr char ${name}[] = R\"--text--(${content})--text--\";\n\n")
endforeach()
string(APPEND text "}  // namespace ${NAMESPACE}\n")
file(WRITE ${HEADER} "${text}")
