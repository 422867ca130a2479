# SPDX-License-Identifier: MIT
# cmake -DSOURCE=<this folder> -DWORK=<folder in the build tree> -DFILES=<a.glb;b.glb> -P validate_glb.cmake
# Installs the validator into WORK where package-lock.json has changed since, then validates FILES.
find_program(NODE node)
find_program(NPM npm)
if(NOT NODE OR NOT NPM)
  message(FATAL_ERROR "node and npm are needed to validate .glb files; install the packages nodejs and npm")
endif()

foreach(file package.json package-lock.json .npmrc validate_glb.mjs)
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
execute_process(COMMAND "${NODE}" validate_glb.mjs ${FILES} WORKING_DIRECTORY "${WORK}" COMMAND_ERROR_IS_FATAL ANY)
