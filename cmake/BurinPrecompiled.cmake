# SPDX-FileCopyrightText: 2026 The Burin authors
# SPDX-License-Identifier: Apache-2.0
# Third-party headers that nearly every source includes, compiled once, which saves one to five seconds per source. Each
# source still includes what it uses; the presets debug and asan build without precompiled headers and reveal missing
# includes.

option(BURIN_PRECOMPILED_HEADERS "Compile the headers of the standard library, GLM and QtCore once" ON)

# burin_precompiled_set(NAME HEADERS ... USES ...): defines a set for burin_precompile(TARGET NAME).
function(burin_precompiled_set name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;USES")
    if(NOT BURIN_PRECOMPILED_HEADERS)
        return()
    endif()
    set(source ${CMAKE_BINARY_DIR}/precompiled/${name}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "")
    add_library(burin_precompiled_${name} STATIC ${source})
    target_link_libraries(burin_precompiled_${name} PRIVATE burin_options burin_warnings ${arg_USES})
    target_precompile_headers(burin_precompiled_${name} PRIVATE ${arg_HEADERS})
endfunction()

# burin_precompile(TARGET SET): for TARGET's sources, except those that it compiles with flags of their own.
function(burin_precompile target set)
    if(BURIN_PRECOMPILED_HEADERS)
        target_precompile_headers(${target} REUSE_FROM burin_precompiled_${set})
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
            # g++ 12 does not treat a precompiled std::string as system code, and warns inside it (bug 105329).
            target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
        endif()
        # The output of moc is too small to benefit.
        set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/mocs_compilation.cpp
            PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
endfunction()

set(BURIN_STANDARD_HEADERS <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem> <functional> <limits>
    <map> <memory> <mutex> <optional> <random> <span> <string> <string_view> <thread> <unordered_map> <utility>
    <variant> <vector> <glm/glm.hpp>)
burin_precompiled_set(standard HEADERS ${BURIN_STANDARD_HEADERS} USES glm::glm)
burin_precompiled_set(qt HEADERS ${BURIN_STANDARD_HEADERS} <QtCore> USES glm::glm Qt6::Core)
burin_precompiled_set(command HEADERS ${BURIN_STANDARD_HEADERS} <nlohmann/json.hpp>
    USES glm::glm nlohmann_json::nlohmann_json)
