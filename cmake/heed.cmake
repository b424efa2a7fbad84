# One room of the house is one library target that links only what docs/architecture.md allows.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(HEED_CCACHE ccache)
if(HEED_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${HEED_CCACHE})
endif()

# g++ 12 invents -Wrestrict and -Wmaybe-uninitialized findings inside std::string and std::optional.
add_library(heed_flags INTERFACE)
target_compile_options(heed_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  -Wno-sign-conversion "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-maybe-uninitialized>" $<$<BOOL:${HEED_WERROR}>:-Werror>)
# What is measured is the library: instrumenting the tests, too, doubles the time to build them.
if(HEED_SANITIZE)
  add_library(heed_sanitize INTERFACE)
  target_compile_options(heed_sanitize INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(heed_flags INTERFACE -fsanitize=address,undefined)
endif()

# heed_room(NAME [LINKS room...] [EXTERNAL target...])
#   LINKS: rooms that this one may include. EXTERNAL: libraries that its sources use.
function(heed_room name)
  cmake_parse_arguments(ROOM "" "" "LINKS;EXTERNAL" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM ROOM_LINKS PREPEND "heed::")
  if(sources)
    add_library(heed_${name} STATIC ${sources})
    set(visibility PUBLIC)
    target_link_libraries(heed_${name} PRIVATE $<BUILD_INTERFACE:heed_flags> $<TARGET_NAME_IF_EXISTS:heed_sanitize> PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_EXTERNAL})
  else()
    add_library(heed_${name} INTERFACE)
    set(visibility INTERFACE)
    target_link_libraries(heed_${name} INTERFACE ${ROOM_LINKS} ${ROOM_EXTERNAL})
  endif()
  target_include_directories(heed_${name} ${visibility}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(heed_${name} ${visibility} cxx_std_20)
  add_library(heed::${name} ALIAS heed_${name})
  set_property(TARGET heed_${name} PROPERTY EXPORT_NAME ${name})
  set_property(GLOBAL APPEND PROPERTY HEED_ROOMS ${name})
endfunction()
