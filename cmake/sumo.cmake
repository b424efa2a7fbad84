# SUMO for `heed drive`, as a module that is loaded only there: its library brings some 200 others, which take longer to load than
# most commands do. Elsewhere the program has everything but that command, which says what is missing.
find_package(SUMO QUIET HINTS /usr/share/sumo/cmake)
if(TARGET SUMO::libsumocpp AND NOT HEED_SANITIZE)  # sanitizers look at this program, not at SUMO
  set(sumo_found ON)
endif()
option(HEED_SUMO "heed drive: closed loop in SUMO, a module that is loaded only there" ${sumo_found})

function(heed_sumo_module room)
  target_link_libraries(${room} PRIVATE ${CMAKE_DL_LIBS})
  if(NOT HEED_SUMO)
    message(STATUS "heed drive: no SUMO (scripts/setup extras): built without it")
    return()
  endif()
  find_package(SUMO REQUIRED HINTS /usr/share/sumo/cmake)
  add_library(heed_sumo MODULE ${PROJECT_SOURCE_DIR}/src/sim/sumo/sumo.cpp)
  target_link_libraries(heed_sumo PRIVATE SUMO::libsumocpp heed_flags)
  target_include_directories(heed_sumo PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_features(heed_sumo PRIVATE cxx_std_20)
  # Without the windows that libsumo could open, which need further headers.
  set_property(TARGET SUMO::libsumocpp PROPERTY INTERFACE_COMPILE_DEFINITIONS)
  set_target_properties(heed_sumo PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/heed)
  target_compile_definitions(${room} PRIVATE HEED_SUMO_MODULE="libheed_sumo.so" HEED_MODULE_FOLDER="${CMAKE_INSTALL_LIBDIR}/heed")
  add_dependencies(${room} heed_sumo)
  install(TARGETS heed_sumo DESTINATION ${CMAKE_INSTALL_LIBDIR}/heed)
endfunction()
