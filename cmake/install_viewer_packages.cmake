# cmake -D NPM=npm -D STAMP=file -P install_viewer_packages.cmake, in viewer/
#
# Installs exactly the packages in viewer/package-lock.json.
execute_process(COMMAND ${NPM} ci --loglevel=error RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(code)
  message(FATAL_ERROR "npm cannot install the packages of viewer/:\n${output}\n"
                      "Without a registry, configure with -DFORAMEN_VIEWER=OFF: reports are then plain pages.")
endif()
file(TOUCH ${STAMP})
