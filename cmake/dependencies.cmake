# Everything below is a Debian 12 package; packages.txt lists them.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(NLopt REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(JPEG REQUIRED)
find_package(PNG REQUIRED)
find_package(pugixml REQUIRED)
pkg_check_modules(OSMESA REQUIRED osmesa)
add_library(palpate_osmesa INTERFACE)  # headers alone: the library is loaded when something is drawn
target_include_directories(palpate_osmesa SYSTEM INTERFACE ${OSMESA_INCLUDE_DIRS})
target_link_libraries(palpate_osmesa INTERFACE ${CMAKE_DL_LIBS})
pkg_check_modules(FREETYPE REQUIRED freetype2)
add_library(palpate_freetype INTERFACE)  # likewise
target_include_directories(palpate_freetype SYSTEM INTERFACE ${FREETYPE_INCLUDE_DIRS})

# SuiteSparse in Debian 12 ships neither a CMake nor a pkg-config file.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(palpate_cholmod INTERFACE)  # headers alone: the library is loaded when a body is condensed
target_include_directories(palpate_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
target_link_libraries(palpate_cholmod INTERFACE ${CMAKE_DL_LIBS})

# libcsv ships neither.
find_path(CSV_INCLUDE_DIR csv.h REQUIRED)
find_library(CSV_LIBRARY csv REQUIRED)
add_library(palpate_csv INTERFACE)
target_include_directories(palpate_csv SYSTEM INTERFACE ${CSV_INCLUDE_DIR})
target_link_libraries(palpate_csv INTERFACE ${CSV_LIBRARY})
