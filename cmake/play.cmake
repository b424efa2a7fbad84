# The page of `heed play` is built from web/ into the program where Node and the packages of its lockfile are: `scripts/setup
# test` installs both, so that a build itself needs no network. Elsewhere the program has everything but the page, and says so.
function(heed_play_template target)
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(embedded ${CMAKE_CURRENT_BINARY_DIR}/play_template.cpp)
  find_program(HEED_NODE node)
  if(HEED_NODE AND EXISTS ${web}/node_modules/vite/package.json)
    set_property(GLOBAL PROPERTY HEED_PLAY_PAGE TRUE)
    file(GLOB sources CONFIGURE_DEPENDS ${web}/src/*.ts ${web}/src/*.css)
    add_custom_command(OUTPUT ${embedded} BYPRODUCTS ${CMAKE_CURRENT_BINARY_DIR}/play_template.html
      COMMAND ${HEED_NODE} ${web}/build.mjs ${CMAKE_CURRENT_BINARY_DIR}/play_template.html ${embedded}
      DEPENDS ${sources} ${web}/index.html ${web}/build.mjs ${web}/package-lock.json
      COMMENT "Building the page of heed play" VERBATIM)
  else()
    message(STATUS "heed play: no Node or no packages in web/ (scripts/setup test): built without the page")
    file(CONFIGURE OUTPUT ${embedded} CONTENT [[
#include "play_template.h"

namespace heed::report {
std::string play_template() { return {}; }
}  // namespace heed::report
]] @ONLY)
  endif()
  target_sources(${target} PRIVATE ${embedded})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src/report)
endfunction()
