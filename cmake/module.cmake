# What every target of this project is compiled with.
add_library(palpate_flags INTERFACE)
target_compile_options(palpate_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports false positives from inside Eigen and the standard library at -O2 and above.
  target_compile_options(palpate_flags INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized -Wno-array-bounds
                         -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
endif()
if(PALPATE_NATIVE AND NOT PALPATE_SANITIZE)
  target_compile_options(palpate_flags INTERFACE -march=native)
endif()
if(PALPATE_SANITIZE)
  target_compile_options(palpate_flags INTERFACE -fsanitize=${PALPATE_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer -g)
  target_link_options(palpate_flags INTERFACE -fsanitize=${PALPATE_SANITIZE})
endif()

# A module is one library in one folder. Its headers are included as "module/folder/header.hpp" through a link
# that only this module's target knows, so that a module which does not link another cannot include it.
function(palpate_module name)
  cmake_parse_arguments(MODULE "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(palpate_${name} ${sources})
  set(include_root ${CMAKE_BINARY_DIR}/include_${name})
  file(MAKE_DIRECTORY ${include_root})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${include_root}/${name} SYMBOLIC)
  target_include_directories(palpate_${name} PUBLIC ${include_root})
  target_link_libraries(palpate_${name} PUBLIC ${MODULE_PUBLIC} PRIVATE ${MODULE_PRIVATE} palpate_flags)
endfunction()
