# What every target of this project is compiled with.
add_library(palpate_flags INTERFACE)
target_compile_options(palpate_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports false positives from inside Eigen and the standard library at -O2 and above.
  target_compile_options(palpate_flags INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized -Wno-array-bounds
                         -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(palpate_flags INTERFACE -Wno-sign-conversion)  # as GCC's -Wconversion has it
endif()
if(PALPATE_GROUPED)
  # In a group of several files, the file that a class's parts stand in is not the group's main one.
  target_compile_options(palpate_flags INTERFACE -Wno-subobject-linkage)
endif()
if(PALPATE_NATIVE AND NOT PALPATE_SANITIZE)
  target_compile_options(palpate_flags INTERFACE -march=native)
elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT PALPATE_SANITIZE)
  # AVX2 and FMA: every Intel since Haswell (2013), every AMD since Excavator (2015). app/processor.cpp tells others.
  target_compile_options(palpate_flags INTERFACE -march=x86-64-v3)
endif()
if(PALPATE_SANITIZE MATCHES thread)
  # ThreadSanitizer knows no fences. Asio has one at the end of a handler, beside locks that order the same.
  target_compile_options(palpate_flags INTERFACE -Wno-tsan)
endif()
if(PALPATE_SANITIZE)
  target_compile_options(palpate_flags INTERFACE -fsanitize=${PALPATE_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(palpate_flags INTERFACE -fsanitize=${PALPATE_SANITIZE})
  if(PALPATE_SANITIZE MATCHES address)
    # What these look for, AddressSanitizer finds where it matters; they take a third of the compile time.
    target_compile_options(palpate_flags INTERFACE -fno-sanitize=null,alignment,object-size,vptr)
  endif()
endif()

# The one list of each kind of thing that is added as a room: law, effect, probe kind, statistic, task, procedure,
# device, command (docs/extending.md). Compiled alone, so that tests/extending can put a longer list in its place.
set(PALPATE_LISTS
  sim/contact/laws.cpp
  sim/effects/effects.cpp
  sim/probe/kinds.cpp
  analysis/statistics/statistics.cpp
  tasks/tasks.cpp
  trials/procedures/procedures.cpp
  trials/procedures/adaptive_procedures.cpp
  devices/devices.cpp
  app/commands/commands.cpp)

# With PALPATE_GROUPED, files of one folder are compiled together, up to 16 at a time, and the rooms of one kind
# (app/commands/NAME) as if they were one folder: most of the time goes into the headers of libraries, which are then
# read once a group. Names of unnamed namespaces are unique there; a source that cannot keep to that (property
# SKIP_UNITY_BUILD_INCLUSION) is compiled alone. A group includes its files by their place in the project, so that it
# is the same text in every clone and ccache serves them all.
# Sets `result` to what the target is to be compiled from.
function(palpate_grouped result target)
  if(NOT PALPATE_GROUPED)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(groups "")
  set(sources "")
  foreach(source IN LISTS ARGN)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE relative)
    get_source_file_property(apart ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(apart OR relative IN_LIST PALPATE_LISTS)
      list(APPEND sources ${source})
      continue()
    endif()
    cmake_path(GET relative PARENT_PATH folder)
    string(REGEX MATCH "^(tests/extending|tests/[^/]+/[^/]+|[^/]+/[^/]+|[^/]+)" folder ${folder})  # rooms of one kind go together
    string(REPLACE "/" "_" folder ${folder})
    if(NOT DEFINED place_${folder})
      set(place_${folder} 0)
    endif()
    math(EXPR part "${place_${folder}} / 16")
    math(EXPR place_${folder} "${place_${folder}} + 1")
    list(APPEND groups ${folder}_${part})
    string(APPEND text_${folder}_${part} "#include \"${relative}\"\n")
  endforeach()
  list(REMOVE_DUPLICATES groups)
  foreach(group IN LISTS groups)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/groups/${target}/${group}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text_${group}}" @ONLY)
    list(APPEND sources ${file})
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

# A module is one library in one folder. Its headers are included as "module/folder/header.hpp" through a link
# that only this module's target knows, so that a module which does not link another cannot include it.
function(palpate_module name)
  cmake_parse_arguments(MODULE "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  palpate_grouped(units palpate_${name} ${sources})
  add_library(palpate_${name} ${units})
  set(include_root ${CMAKE_BINARY_DIR}/include_${name})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${name} SYMBOLIC)
  target_include_directories(palpate_${name} PUBLIC ${include_root})
  target_link_libraries(palpate_${name} PUBLIC ${MODULE_PUBLIC} PRIVATE ${MODULE_PRIVATE} palpate_flags)
endfunction()
