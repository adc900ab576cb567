# SPDX-FileCopyrightText: 2026 The Burin authors
# SPDX-License-Identifier: Apache-2.0
# The few functions that declare every target of Burin. A target can only link what it names.

set(BURIN_SANITIZE "" CACHE STRING "Sanitizers for all of our code, as for -fsanitize=")
option(BURIN_FUZZ "Build the fuzzers; needs clang" OFF)

include(CheckLinkerFlag)
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    # Otherwise ccache does not handle precompiled headers, and does not find objects that were compiled in another
    # clone.
    set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}
        CCACHE_NOHASHDIR=1 ${CCACHE_PROGRAM})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
    set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
endif()

add_library(burin_warnings INTERFACE)
target_compile_options(burin_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wcast-align -Wformat=2
    -Wimplicit-fallthrough)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ 12 reports overlapping copies inside its own std::string (bug 105329).
    target_compile_options(burin_warnings INTERFACE -Werror -Wno-restrict)
endif()

# For tests: optimising a test takes half of the compiler's time, and those that compute most run as long without it.
# Not for shipped programs: the linker keeps the program's copy of an inline function instead of the core's.
add_library(burin_light_build INTERFACE)
target_compile_options(burin_light_build INTERFACE $<$<CONFIG:Release>:-O1>)
check_linker_flag(CXX -fuse-ld=gold BURIN_HAS_GOLD) # three times as fast as the default linker
if(BURIN_HAS_GOLD)
    target_link_options(burin_light_build INTERFACE -fuse-ld=gold)
endif()

add_library(burin_options INTERFACE)
target_include_directories(burin_options INTERFACE ${CMAKE_SOURCE_DIR})
# The same path on every machine: no implicit fused multiply-add. No code reads errno after a square root.
target_compile_options(burin_options INTERFACE -ffp-contract=off -fno-math-errno)
# The required benchmark figures were measured with AVX2. If it is missing, app/processor.cpp reports that.
set(instructions "")
if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    set(instructions x86-64-v3)
endif()
set(BURIN_INSTRUCTIONS "${instructions}" CACHE STRING "Instruction set to build for, as for -march=; empty: the compiler's own")
if(NOT BURIN_INSTRUCTIONS STREQUAL "")
    target_compile_options(burin_options INTERFACE -march=${BURIN_INSTRUCTIONS})
endif()
if(BURIN_SANITIZE)
    target_compile_options(burin_options INTERFACE -fsanitize=${BURIN_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(burin_options INTERFACE -fsanitize=${BURIN_SANITIZE})
    set(BURIN_SANITIZER_ENVIRONMENT
        "TSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/sanitizers/thread.txt:ignore_noninstrumented_modules=1"
        "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/sanitizers/leak.txt:print_suppressions=0")
    if(BURIN_SANITIZE MATCHES undefined)
        target_compile_options(burin_options INTERFACE -fno-sanitize-recover=undefined)
    endif()
endif()

option(BURIN_UNITY "Compile several sources of a folder at once: it spares two thirds of the time" ON)

# burin_unity(TARGET)
# Compiles its sources in batches of six, so names in the anonymous namespaces of a folder must be unique. Not for
# folders whose code runs in each tick: what is inlined there stays as it was measured.
function(burin_unity target)
    if(BURIN_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 6)
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
            # g++ 12 takes a source that another one includes for a header, whose types could not be completed
            # elsewhere; and with much inlining it reports unset members of an empty std::variant (the preset debug
            # checks that again).
            target_compile_options(${target} PRIVATE -Wno-subobject-linkage -Wno-maybe-uninitialized)
        endif()
    endif()
endfunction()

# burin_library(NAME [UNITY] [SOURCES ...] [PUBLIC ...] [PRIVATE ...] [SYSTEM_INCLUDES ...])
# One folder, one library burin::NAME. Without SOURCES it is header-only. The variable BURIN_PRECOMPILED_SET of a folder
# names the precompiled headers of its libraries.
set(BURIN_PRECOMPILED_SET standard)
function(burin_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "UNITY" "" "SOURCES;PUBLIC;PRIVATE;SYSTEM_INCLUDES")
    if(arg_SOURCES)
        add_library(burin_${name} STATIC ${arg_SOURCES})
        target_link_libraries(burin_${name} PUBLIC burin_options ${arg_PUBLIC} PRIVATE burin_warnings ${arg_PRIVATE})
        target_include_directories(burin_${name} SYSTEM PRIVATE ${arg_SYSTEM_INCLUDES})
        burin_precompile(burin_${name} ${BURIN_PRECOMPILED_SET})
        if(arg_UNITY)
            burin_unity(burin_${name})
        endif()
    else()
        add_library(burin_${name} INTERFACE)
        target_link_libraries(burin_${name} INTERFACE burin_options ${arg_PUBLIC})
    endif()
    add_library(burin::${name} ALIAS burin_${name})
endfunction()

# burin_moc(TARGET): runs moc for the classes with signals and slots.
function(burin_moc target)
    get_target_property(BURIN_MOC Qt6::moc LOCATION)
    configure_file(${CMAKE_SOURCE_DIR}/cmake/moc.in ${CMAKE_BINARY_DIR}/moc @ONLY)
    set_target_properties(${target} PROPERTIES AUTOMOC ON AUTOMOC_EXECUTABLE ${CMAKE_BINARY_DIR}/moc)
endfunction()

# burin_vectorised(SOURCES ...)
# Sources with BURIN_VECTORISED functions (core/base/vectorised.h): comparisons raise no floating-point exceptions, so
# that the lanes stay vectorised. Results are the same.
function(burin_vectorised)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-fno-trapping-math;-Wno-psabi"
        SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# burin_program(NAME SOURCES ... USES ...)
function(burin_program name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;USES")
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE burin_options burin_warnings ${arg_USES})
endfunction()

# burin_plugin(KIND NAME SOURCES ... USES ...)
# A loadable module with its metadata, plugin.json, next to it in plugins/KIND/NAME of the build tree.
function(burin_plugin kind name)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SOURCES;USES")
    set(target burin_plugin_${kind}_${name})
    add_library(${target} MODULE ${arg_SOURCES})
    target_link_libraries(${target} PRIVATE burin_options burin_warnings ${arg_USES})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} CXX_VISIBILITY_PRESET hidden
        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins/${kind}/${name} BURIN_PLUGIN_FOLDER plugins/${kind}/${name})
    add_custom_command(TARGET ${target} POST_BUILD COMMAND ${CMAKE_COMMAND} -E copy_if_different
        ${CMAKE_CURRENT_SOURCE_DIR}/plugin.json ${CMAKE_BINARY_DIR}/plugins/${kind}/${name}/plugin.json)
    set_property(GLOBAL APPEND PROPERTY BURIN_PLUGINS ${target})
endfunction()

# burin_test_entry(TEST SECONDS SLOTS ENVIRONMENT COMMAND ...): adds a test to ctest; slots: see burin_test_load.
function(burin_test_entry test seconds slots environment)
    if(BURIN_SANITIZE) # up to twenty times slower
        math(EXPR seconds "${seconds} * 10")
    endif()
    add_test(NAME ${test} COMMAND ${ARGN})
    set_tests_properties(${test} PROPERTIES TIMEOUT ${seconds} PROCESSORS ${slots}
        ENVIRONMENT "QTEST_FUNCTION_TIMEOUT=${seconds}000;${environment}")
endfunction()

# burin_test(PLACE NAME [GUI] [USES ...] [TIMEOUT SECONDS] [LONG SECONDS] [ONLY_LONG] [AFTER ...])
# tst_NAME.cpp, a class of QtTest, which ctest runs as PLACE.NAME. The tests of a PLACE share the program tst_PLACE,
# which takes NAME as its first argument: compiling and linking them together takes half of the time. AFTER names
# programs that it starts. With GUI it gets an X display of its own. Where its source names more cases than the usual run
# uses (tests/long_run.h), all of them are the test PLACE.NAME.long of `tests/run --long`, with the time limit LONG;
# ONLY_LONG: it has no others.
find_program(XVFB_RUN xvfb-run)
function(burin_test place name)
    cmake_parse_arguments(PARSE_ARGV 2 arg "GUI;ONLY_LONG" "TIMEOUT;LONG" "USES;AFTER")
    set(platform offscreen)
    set(slots 3)
    set(launcher)
    if(arg_GUI)
        set(platform xcb)
        set(slots 2)
        set(launcher ${XVFB_RUN} -a -s "-screen 0 1600x1000x24 +extension GLX")
    endif()
    burin_test_program(${place} program)
    # Calls moc directly, as AUTOMOC needs more time per test to find its inputs than moc itself takes. Without TARGET,
    # whose include folders moc would search.
    qt_generate_moc(tst_${name}.cpp ${CMAKE_CURRENT_BINARY_DIR}/tst_${name}.moc)
    target_sources(${program} PRIVATE tst_${name}.cpp ${CMAKE_CURRENT_BINARY_DIR}/tst_${name}.moc)
    target_link_libraries(${program} PRIVATE ${arg_USES})
    if(arg_AFTER)
        add_dependencies(${program} ${arg_AFTER})
    endif()
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    set(environment "QT_QPA_PLATFORM=${platform};LC_ALL=C.UTF-8;${BURIN_SANITIZER_ENVIRONMENT}")
    if(NOT arg_ONLY_LONG)
        burin_test_entry(${place}.${name} ${arg_TIMEOUT} ${slots} "${environment}" ${launcher} $<TARGET_FILE:${program}> ${name})
    endif()
    file(STRINGS tst_${name}.cpp more_cases REGEX "BURIN_ONLY_IN_LONG_RUNS|inLongRun|longRun|holdsInShare")
    if(more_cases AND NOT arg_LONG)
        set(arg_LONG 900)
    endif()
    if(arg_LONG)
        burin_test_entry(${place}.${name}.long ${arg_LONG} ${slots} "BURIN_LONG_RUN=1;${environment}"
            ${launcher} $<TARGET_FILE:${program}> ${name} -maxwarnings 0)
        set_tests_properties(${place}.${name}.long PROPERTIES LABELS long)
    endif()
endfunction()

# burin_test_program(PLACE VARIABLE): the program that the tests of PLACE share.
function(burin_test_program place variable)
    string(REPLACE "." "_" target "tst_${place}")
    set(${variable} ${target} PARENT_SCOPE)
    if(TARGET ${target})
        return()
    endif()
    add_executable(${target})
    target_link_libraries(${target} PRIVATE burin_options burin_warnings burin_light_build Qt6::Test burin::test_program)
    target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}) # tests/places.h, moc's
    set(precompiled test)
    if(BURIN_TESTS_WITH_WIDGETS)
        set(precompiled window_test)
    endif()
    burin_precompile(${target} ${precompiled})
    burin_unity(${target})
    # Not in tests: that is a folder of the build tree, and its "plugins" would be taken for Burin's.
    set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test-programs)
endfunction()

# burin_test_load(WAITING|DISTURBED TEST ...)
# tests/run distributes six slots, for two cores. A test keeps a core busy and has three slots; one with a window, which
# waits for a third of its time, has two. WAITING tests, which mostly wait, have one; DISTURBED tests, which measure time
# or run the haptic loop in real time for long, have five, so that they only run together with a waiting one. Both kinds
# start first, as they are run together.
function(burin_test_load load)
    foreach(test IN LISTS ARGN)
        if(TEST ${test}.long)
            list(APPEND ARGN ${test}.long)
        endif()
    endforeach()
    if(load STREQUAL WAITING)
        set_tests_properties(${ARGN} PROPERTIES PROCESSORS 1 COST 1000)
    elseif(load STREQUAL DISTURBED)
        set_tests_properties(${ARGN} PROPERTIES PROCESSORS 5 COST 2000)
    else()
        message(FATAL_ERROR "burin_test_load: ${load} is no load")
    endif()
endfunction()
