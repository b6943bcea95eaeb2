# add_component(<name> [SOURCES ...] [USES ...])
#
# One folder, one library: the target, the namespace and the folder share a name.
# USES lists what its headers or sources include; scripts/layers.txt says what it may list.
# A folder with headers only has no SOURCES and becomes an interface library.
#
# add_program(<name> SOURCES ... USES ...)
#
# A program; all of them land in one folder, bin/, so that `matchday` finds the teams beside it. The target `programs` builds
# all of them without the tests.

set(SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")

add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
target_compile_options(project_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual
  -ffp-contract=off                                   # fused multiply-add would make results depend on the machine
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.           # a binary must not depend on where it was built
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>          # lets ccache look into precompiled headers
  "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")  # as does this

# Sanitizers concern every target, the generated message code too: instrumented and plain containers must not mix.
add_library(sanitizers INTERFACE)
if(SANITIZE)
  target_compile_options(sanitizers INTERFACE -fsanitize=${SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(sanitizers INTERFACE -fsanitize=${SANITIZE})
endif()
target_link_libraries(project_options INTERFACE sanitizers)

# Eigen and the standard library cost more to read than most files to compile: read once for all components and once
# for all tests. Nobody may rely on it: the presets dev and tsan build without (their build is the check).
option(PRECOMPILE "Use precompiled headers" ON)
set(standard_headers <Eigen/Core> <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <fstream> <map> <memory>
    <optional> <span> <sstream> <stdexcept> <string> <string_view> <variant> <vector>)

# precompile(<target> <set>): <set> is components or tests
function(precompile target set)
  if(PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM precompiled_${set})
  endif()
endfunction()

function(add_precompiled set)
  if(PRECOMPILE)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled/${set}.cpp CONTENT "")  # written only when missing
    add_library(precompiled_${set} OBJECT ${PROJECT_BINARY_DIR}/precompiled/${set}.cpp)
    target_link_libraries(precompiled_${set} PRIVATE project_options Eigen3::Eigen ${ARGN})
    set_target_properties(precompiled_${set} PROPERTIES CXX_EXTENSIONS OFF)
    target_precompile_headers(precompiled_${set} PRIVATE ${standard_headers})
  endif()
endfunction()

function(add_component name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES")
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC ${ARG_USES} PRIVATE project_options)
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_features(${name} PUBLIC cxx_std_20)
    precompile(${name} components)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${ARG_USES})
  endif()
endfunction()

add_custom_target(programs)

function(add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES")
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_USES} project_options)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_dependencies(programs ${name})
  precompile(${name} components)
endfunction()
