# The interactive page of reports: viewer/ is built by npm into one html file, which is compiled into foramen_report.
# Without npm an empty page is compiled in, and reports are plain pages. Packages are built without a network, so they
# take a page that npm has built before.
option(FORAMEN_VIEWER "Build the interactive page of reports, where npm is found" ON)
set(FORAMEN_VIEWER_PAGE "" CACHE FILEPATH "A built interactive page; npm is then not used")
find_program(NPM_PROGRAM npm)

set(viewer ${PROJECT_SOURCE_DIR}/viewer)
set(viewer_page ${PROJECT_BINARY_DIR}/viewer/index.html)
set(viewer_template ${PROJECT_BINARY_DIR}/viewer/viewer_template.cpp)
set(viewer_packages ${viewer}/node_modules/.package-lock.json)

function(foramen_embed_page page)
  add_custom_command(
    OUTPUT ${viewer_template}
    COMMAND ${CMAKE_COMMAND} -D PAGE=${page} -D OUTPUT=${viewer_template} -P
            ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_page.cmake
    DEPENDS ${page} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_page.cmake
            ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/viewer_template.cpp.in
    COMMENT "viewer: compiling the page in")
endfunction()

if(FORAMEN_VIEWER_PAGE)
  set(FORAMEN_HAS_VIEWER ON PARENT_SCOPE) # for the tests
  message(STATUS "Reports: interactive pages (${FORAMEN_VIEWER_PAGE})")
  foramen_embed_page(${FORAMEN_VIEWER_PAGE})
elseif(FORAMEN_VIEWER AND NPM_PROGRAM)
  set(FORAMEN_HAS_VIEWER ON PARENT_SCOPE) # for the tests
  message(STATUS "Reports: interactive pages (npm: ${NPM_PROGRAM})")
  add_custom_command(
    OUTPUT ${viewer_packages}
    COMMAND ${CMAKE_COMMAND} -D NPM=${NPM_PROGRAM} -D STAMP=${viewer_packages} -P
            ${CMAKE_CURRENT_LIST_DIR}/install_viewer_packages.cmake
    DEPENDS ${viewer}/package.json ${viewer}/package-lock.json ${viewer}/.npmrc
    WORKING_DIRECTORY ${viewer}
    COMMENT "viewer: installing its packages")
  file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS ${viewer}/src/*)
  add_custom_command(
    OUTPUT ${viewer_page}
    COMMAND ${NPM_PROGRAM} run build --silent -- --outDir ${PROJECT_BINARY_DIR}/viewer --logLevel warn
    DEPENDS ${viewer_packages} ${viewer_sources} ${viewer}/index.html ${viewer}/vite.config.ts
    WORKING_DIRECTORY ${viewer}
    COMMENT "viewer: building the page")
  foramen_embed_page(${viewer_page})
else()
  message(STATUS "Reports: plain pages (no npm, or FORAMEN_VIEWER is off)")
  set(template_text "")
  configure_file(${CMAKE_CURRENT_LIST_DIR}/viewer_template.cpp.in ${viewer_template} @ONLY)
endif()
