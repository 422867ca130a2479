# SPDX-License-Identifier: MIT
# cmake -DSOURCE=<web/> -DWORK=<folder in the build tree> -DNODE=<node> -DNPM=<npm> -DOUTPUT=<file.cpp> -P make_page.cmake
# Installs the page's packages into WORK where package-lock.json has changed since, then bundles the page into OUTPUT.
file(GLOB sources "${SOURCE}/*" "${SOURCE}/.npmrc")
list(FILTER sources EXCLUDE REGEX "/node_modules$")
file(COPY ${sources} DESTINATION "${WORK}")
file(SHA256 "${WORK}/package-lock.json" wanted)
set(installed "")
if(EXISTS "${WORK}/installed.txt")
  file(READ "${WORK}/installed.txt" installed)
endif()
if(NOT installed STREQUAL wanted)
  execute_process(COMMAND "${NPM}" ci --loglevel=error WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "npm cannot install the packages of web/package-lock.json; mend its registry, or configure "
                        "with -DFIXRAD_PAGE=OFF to build fixrad without the page of `fixrad sweep`")
  endif()
  file(WRITE "${WORK}/installed.txt" "${wanted}")
endif()
execute_process(COMMAND "${NODE}" build.mjs "${OUTPUT}" WORKING_DIRECTORY "${WORK}" COMMAND_ERROR_IS_FATAL ANY)
