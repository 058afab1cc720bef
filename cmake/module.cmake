# What every target of this project is compiled with.
add_library(palpate_flags INTERFACE)
target_compile_options(palpate_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports false positives from inside Eigen and the standard library at -O2 and above.
  target_compile_options(palpate_flags INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized -Wno-array-bounds
                         -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
endif()
if(CMAKE_UNITY_BUILD)
  # In a unit of several files, the file that a class's parts stand in is not the unit's main one.
  target_compile_options(palpate_flags INTERFACE -Wno-subobject-linkage)
endif()
if(PALPATE_NATIVE AND NOT PALPATE_SANITIZE)
  target_compile_options(palpate_flags INTERFACE -march=native)
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

# With CMAKE_UNITY_BUILD, files of one folder are compiled together, up to 16 at a time: most of the time goes into
# the headers of libraries, which are then read once a group. Names of unnamed namespaces are unique in their folder.
function(palpate_group_by_folder target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  set(place 0)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    math(EXPR part "${place} / 16")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${part})
    math(EXPR place "${place} + 1")
  endforeach()
endfunction()

# A module is one library in one folder. Its headers are included as "module/folder/header.hpp" through a link
# that only this module's target knows, so that a module which does not link another cannot include it.
function(palpate_module name)
  cmake_parse_arguments(MODULE "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(palpate_${name} ${sources})
  palpate_group_by_folder(palpate_${name} ${sources})
  set(include_root ${CMAKE_BINARY_DIR}/include_${name})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${name} SYMBOLIC)
  target_include_directories(palpate_${name} PUBLIC ${include_root})
  target_link_libraries(palpate_${name} PUBLIC ${MODULE_PUBLIC} PRIVATE ${MODULE_PRIVATE} palpate_flags)
endfunction()
