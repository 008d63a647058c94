# Builds the pages and turns them into one C++ source. Run by the build when a source of the pages has changed:
#   cmake -DCLIENT=web-ui/client -DNODE=node -DNPM=npm -DDIST=out -DOUTPUT=pages.cpp -P web-ui/build-pages.cmake
# Only the first build (and one after a change of package-lock.json) asks the package registry.

function(step what hint)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${CLIENT} RESULT_VARIABLE result OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "The pages: ${what} failed.\n${log}\n${hint}")
  endif()
endfunction()

execute_process(COMMAND ${NODE} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX REPLACE "^v" "" version "${version}")
if(version VERSION_LESS 18.18)
  message(FATAL_ERROR "The pages need node 18.18 or newer, ${NODE} is ${version}. "
                      "Install Debian's nodejs, or configure with -DVERSTAT_WEB=OFF.")
endif()

# npm writes this file last; older than the lock file means that another set of packages is wanted.
set(installed ${CLIENT}/node_modules/.package-lock.json)
if(NOT EXISTS ${installed} OR ${CLIENT}/package-lock.json IS_NEWER_THAN ${installed})
  step("npm ci" "It needs the package registry once. Without network: -DVERSTAT_WEB=OFF builds the program without pages."
       ${NPM} ci --no-audit --no-fund)
  file(TOUCH ${installed})
endif()
step("the type check" "" ${NPM} run --silent typecheck)
step("vite build" "" ${NPM} exec --offline -- vite build --outDir ${DIST} --emptyOutDir --logLevel warn)
execute_process(COMMAND ${NODE} ${CLIENT}/embed.mjs ${DIST} ${OUTPUT} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The pages: embed.mjs failed, see above.")
endif()
