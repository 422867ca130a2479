# SPDX-License-Identifier: MIT
# cmake -DSOURCE=<this folder> -DWORK=<folder in the build tree> -DTOOL=<fixrad> -DSCENE=<scene.obj> -P check_page.cmake
# Installs the driver of the browser into WORK where package-lock.json has changed since, writes a page and a table,
# opens the page.
find_program(NODE node REQUIRED)
find_program(NPM npm REQUIRED)
find_program(CHROMIUM chromium REQUIRED)
foreach(file package.json package-lock.json .npmrc check_page.mjs)
  file(COPY "${SOURCE}/${file}" DESTINATION "${WORK}")
endforeach()
file(SHA256 "${WORK}/package-lock.json" wanted)
set(installed "")
if(EXISTS "${WORK}/installed.txt")
  file(READ "${WORK}/installed.txt" installed)
endif()
if(NOT installed STREQUAL wanted)
  execute_process(COMMAND "${NPM}" ci --loglevel=error WORKING_DIRECTORY "${WORK}" COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE "${WORK}/installed.txt" "${wanted}")
endif()
execute_process(
  COMMAND "${TOOL}" --quiet sweep "${SCENE}" --profile tiny,small,medium --engine lunes,pixels --resolution 8,16
          -o "${WORK}/page.html" -o "${WORK}/table.csv"
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${NODE}" check_page.mjs page.html table.csv "${CHROMIUM}"
  WORKING_DIRECTORY "${WORK}" COMMAND_ERROR_IS_FATAL ANY)
