# foramen_add_module(NAME [DEPENDS module...] [LINK target...] [LINK_PRIVATE target...])
#
# One library foramen_NAME (alias foramen::NAME) from src/NAME/*.cpp and include/foramen/NAME/*.hpp, installed as a
# component of the package, and one test program NAME_tests from tests/NAME/*_test.cpp.
function(foramen_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;LINK;LINK_PRIVATE")
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  set(target foramen_${name})
  if(NOT sources)  # scaffold: module not written yet
    add_library(${target} INTERFACE)
    add_library(foramen::${name} ALIAS ${target})
    list(TRANSFORM arg_DEPENDS PREPEND foramen::)
    target_link_libraries(${target} INTERFACE ${arg_DEPENDS})
    return()
  endif()
  add_library(${target} STATIC ${sources})
  add_library(foramen::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_features(${target} PUBLIC cxx_std_20)
  list(TRANSFORM arg_DEPENDS PREPEND foramen::)
  target_link_libraries(${target}
    PUBLIC ${arg_DEPENDS} ${arg_LINK}
    PRIVATE ${arg_LINK_PRIVATE} $<BUILD_INTERFACE:foramen_warnings>)
  install(TARGETS ${target} EXPORT foramen-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/foramen/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/foramen)
  set_property(GLOBAL APPEND PROPERTY FORAMEN_MODULES ${name})

  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  if(FORAMEN_BUILD_TESTS AND tests)
    add_executable(${name}_tests ${tests})
    target_link_libraries(${name}_tests PRIVATE foramen::${name} foramen_test_support GTest::gtest_main
                                                GTest::gmock foramen_warnings)
    target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src)
    gtest_discover_tests(${name}_tests TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60
                         PROPERTIES TIMEOUT 600 SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  endif()
  file(GLOB benches CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/${name}_bench.cpp)
  if(FORAMEN_BUILD_BENCH AND benches)
    add_executable(${name}_bench ${benches})
    target_link_libraries(${name}_bench PRIVATE foramen::${name} foramen_test_support benchmark::benchmark_main
                                                foramen_warnings)
    target_include_directories(${name}_bench PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  endif()
endfunction()
