# add_component(<name> [SOURCES ...] [USES ...])
#
# One folder, one library: the target, the namespace and the folder share a name.
# USES lists what its headers or sources include; scripts/layers.txt says what it may list.
# A folder with headers only has no SOURCES and becomes an interface library.
#
# add_program(<name> SOURCES ... USES ...)
#
# A program; all of them land in one folder, bin/, so that `matchday` finds the teams beside it.

set(SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")

add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
target_compile_options(project_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual
  -ffp-contract=off                                   # fused multiply-add would make results depend on the machine
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)          # a binary must not depend on where it was built

# Sanitizers concern every target, the generated message code too: instrumented and plain containers must not mix.
add_library(sanitizers INTERFACE)
if(SANITIZE)
  target_compile_options(sanitizers INTERFACE -fsanitize=${SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(sanitizers INTERFACE -fsanitize=${SANITIZE})
endif()
target_link_libraries(project_options INTERFACE sanitizers)

function(add_component name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES")
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} PUBLIC ${ARG_USES} PRIVATE project_options)
    set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_features(${name} PUBLIC cxx_std_20)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${ARG_USES})
  endif()
endfunction()

function(add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES")
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_USES} project_options)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endfunction()
