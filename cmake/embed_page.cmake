# cmake -D PAGE=index.html -D OUTPUT=viewer_template.cpp -P embed_page.cmake
#
# Writes a page as a C++ string.
file(READ ${PAGE} template_text)
if(template_text MATCHES "\\)foramen_page\"")
  message(FATAL_ERROR "${PAGE}: holds the text that ends the C++ string")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/viewer_template.cpp.in ${OUTPUT} @ONLY)
