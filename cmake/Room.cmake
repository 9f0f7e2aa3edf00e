# Flags that all our code shares. Contraction is off so that absent and present-at-zero effects give the same bits; that errno
# and floating-point traps are not looked at changes no value, but lets loops with square roots and choices be vectorised.
add_library(shmoo_flags INTERFACE)
target_compile_options(shmoo_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Werror -fno-math-errno -fno-trapping-math -ffp-contract=off
  -Wno-maybe-uninitialized -Wno-restrict)  # false alarms of g++ 12 in aggregates and strings
if(SHMOO_ARCH)
  target_compile_options(shmoo_flags INTERFACE -march=${SHMOO_ARCH})
  set(CMAKE_REQUIRED_FLAGS -march=${SHMOO_ARCH})
endif()
include(CheckCXXSourceCompiles)
string(MAKE_C_IDENTIFIER "SHMOO_WIDE_REGISTERS_${SHMOO_ARCH}" wide)
check_cxx_source_compiles("#ifndef __AVX512F__\n#error narrow\n#endif\nint main() {}" ${wide})
unset(CMAKE_REQUIRED_FLAGS)
if(NOT ${wide})  # our vectors are wider than the processor's registers; none crosses the border of a library
  target_compile_options(shmoo_flags INTERFACE -Wno-psabi)
endif()
if(SHMOO_SANITIZE)
  target_compile_options(shmoo_flags INTERFACE -fsanitize=${SHMOO_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(shmoo_flags INTERFACE -fsanitize=${SHMOO_SANITIZE})
endif()

# shmoo_room(NAME USES TARGET... [HIDES TARGET...]): one static library for src/NAME; headers alone make an interface library.
# What it hides no header of another room needs.
function(shmoo_room name)
  cmake_parse_arguments(ROOM "" "" "USES;HIDES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  if(NOT sources)
    add_library(shmoo_${name} INTERFACE)
    target_include_directories(shmoo_${name} INTERFACE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(shmoo_${name} INTERFACE ${ROOM_USES})
    add_library(shmoo::${name} ALIAS shmoo_${name})
    return()
  endif()
  if(NOT sources)
    add_library(shmoo_${name} INTERFACE)
    add_library(shmoo::${name} ALIAS shmoo_${name})
    target_include_directories(shmoo_${name} INTERFACE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(shmoo_${name} INTERFACE ${ROOM_USES})
    return()
  endif()
  add_library(shmoo_${name} STATIC ${sources})
  add_library(shmoo::${name} ALIAS shmoo_${name})
  target_include_directories(shmoo_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(shmoo_${name} PUBLIC ${ROOM_USES} PRIVATE shmoo_flags ${ROOM_HIDES})
endfunction()
