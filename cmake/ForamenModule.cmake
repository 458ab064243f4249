# foramen_add_module(NAME [INTERNAL] [DEPENDS module...] [LINK target...] [LINK_PRIVATE target...] [PACKAGES package...]
#                    [WHOLE_SUITES suite...])
#
# One library foramen_NAME (alias foramen::NAME) from src/NAME, and one test program NAME_tests from
# tests/NAME/*_test.cpp. The library and its headers for users (include/foramen/NAME) are installed as a component of
# the package, unless the module is INTERNAL: then only the program and the Python module use it. PACKAGES are what a
# consumer of the installed module must find beside Eigen, TBB and threads. Tests whose name contains RealData need the
# real shapes; all others carry the label quick, which the sanitizer legs run. WHOLE_SUITES: see foramen_discover_tests.
function(foramen_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "INTERNAL" "" "DEPENDS;LINK;LINK_PRIVATE;PACKAGES;WHOLE_SUITES")
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  set(target foramen_${name})
  add_library(${target} STATIC ${sources})
  add_library(foramen::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
           $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  list(TRANSFORM arg_DEPENDS PREPEND foramen:: OUTPUT_VARIABLE depends)
  target_link_libraries(${target}
    PUBLIC ${depends} ${arg_LINK}
    PRIVATE ${arg_LINK_PRIVATE} $<BUILD_INTERFACE:foramen_warnings>)
  foramen_precompile(${target} library)

  set_property(GLOBAL APPEND PROPERTY FORAMEN_MODULES ${name})
  if(NOT arg_INTERNAL)
    set_property(GLOBAL APPEND PROPERTY FORAMEN_INSTALLED_MODULES ${name})
    install(TARGETS ${target} EXPORT foramen-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/include/foramen/${name})
      install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/foramen/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/foramen)
    endif()
    set(depends_file ${PROJECT_BINARY_DIR}/foramen-${name}-depends.cmake)
    file(CONFIGURE OUTPUT ${depends_file}
         CONTENT "set(_foramen_depends @arg_DEPENDS@)\nset(_foramen_packages @arg_PACKAGES@)\n" @ONLY)
    install(FILES ${depends_file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/foramen)
  endif()

  # The modules whose headers take longest to compile and whose names do not clash.
  set(together parameterize evaluate apply modelfiles workflow)
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*_test.cpp)
  if(FORAMEN_BUILD_TESTS AND tests)
    add_executable(${name}_tests ${tests})
    foramen_compile_quickly(${name}_tests)
    target_link_libraries(${name}_tests PRIVATE foramen::${name} foramen_test_support GTest::gtest_main
                                                GTest::gmock foramen_warnings)
    target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/src)
    foramen_precompile(${name}_tests tests)
    if(name IN_LIST together)
      foramen_compile_together(${name}_tests)
    endif()
    foramen_discover_tests(${name}_tests PREFIX ${name} LABEL quick WITHOUT *RealData* WHOLE ${arg_WHOLE_SUITES})
    foramen_discover_tests(${name}_tests PREFIX ${name} LABEL real ONLY *RealData*)
  endif()
  file(GLOB benches CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/${name}_bench.cpp)
  if(FORAMEN_BUILD_BENCH AND benches)
    add_executable(${name}_bench ${benches})
    target_link_libraries(${name}_bench PRIVATE foramen::${name} foramen_test_support benchmark::benchmark_main
                                                foramen_warnings)
    target_include_directories(${name}_bench PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  endif()
endfunction()

# Compiling tests takes longer than running them, so they are compiled with little optimisation. The code under test is
# optimised as usual.
function(foramen_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# foramen_precompile(TARGET HEADERS): compile TARGET with cmake/precompiled/HEADERS.hpp parsed once; the first target
# that asks parses it for all, so they must be compiled with the same options.
function(foramen_precompile target headers)
  get_property(owner GLOBAL PROPERTY FORAMEN_PRECOMPILED_${headers})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/${headers}.hpp)
    set_property(GLOBAL PROPERTY FORAMEN_PRECOMPILED_${headers} ${target})
  endif()
endfunction()

# foramen_compile_together(TARGET): compiles several sources at a time, for targets whose headers take longest. Names in
# anonymous namespaces must then differ between these sources.
function(foramen_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${FORAMEN_UNITY} UNITY_BUILD_BATCH_SIZE 6)
endfunction()

# foramen_discover_tests(PROGRAM PREFIX prefix LABEL label [ONLY pattern] [WITHOUT pattern] [WHOLE suite...])
#
# Makes one ctest for each of the program's tests, and a single one for all tests of a WHOLE suite, whose set-up would
# otherwise run once per test. These carry the label suite and start first, because they take longest.
function(foramen_discover_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PREFIX;LABEL;ONLY;WITHOUT" "WHOLE")
  set(without ${arg_WITHOUT})
  foreach(suite IN LISTS arg_WHOLE)
    list(APPEND without ${suite}.* ${suite}/*)
    add_test(NAME ${arg_PREFIX}.${suite} COMMAND ${program} "--gtest_filter=${suite}.*:${suite}/*-${arg_WITHOUT}")
    set_tests_properties(${arg_PREFIX}.${suite} PROPERTIES TIMEOUT ${FORAMEN_TEST_TIMEOUT} LABELS suite COST 100
                         FAIL_REGULAR_EXPRESSION "Running 0 tests")
  endforeach()
  list(JOIN without ":" without)
  gtest_discover_tests(${program} TEST_PREFIX ${arg_PREFIX}. TEST_FILTER "${arg_ONLY}-${without}"
                       TEST_LIST ${program}_${arg_LABEL} DISCOVERY_TIMEOUT 120
                       PROPERTIES TIMEOUT ${FORAMEN_TEST_TIMEOUT} LABELS ${arg_LABEL} SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()
