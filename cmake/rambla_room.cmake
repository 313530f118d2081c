# A room is one library target with its headers beside its sources. Each room gets an include folder of its own
# in the build tree that shows nothing but that room, so that a target reaches exactly the rooms that it links:
# an include across a forbidden wall does not compile.

find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(PkgConfig REQUIRED)

add_library(rambla_options INTERFACE)
target_compile_options(rambla_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror -march=x86-64-v2 -ffp-contract=off -fno-math-errno -Wno-psabi)
target_compile_definitions(rambla_options INTERFACE
  GLM_FORCE_XYZW_ONLY
  $<$<OR:$<BOOL:${RAMBLA_ASSERTS}>,$<CONFIG:Debug>>:RAMBLA_ASSERTS=1>)
if(RAMBLA_SANITIZE)
  target_compile_options(rambla_options INTERFACE -fsanitize=${RAMBLA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(rambla_options INTERFACE -fsanitize=${RAMBLA_SANITIZE})
endif()
find_program(rambla_mold mold)
if(rambla_mold AND NOT RAMBLA_SANITIZE)
  target_link_options(rambla_options INTERFACE -fuse-ld=mold)
endif()

# rambla_include_tree(TARGET ROOM [FILES file...]): shows ROOM (or only FILES of it) as <ROOM/...> to TARGET's users.
function(rambla_include_tree target room)
  cmake_parse_arguments(arg "" "" "FILES" ${ARGN})
  set(tree ${CMAKE_BINARY_DIR}/include/${target})
  file(MAKE_DIRECTORY ${tree})
  if(arg_FILES)
    foreach(file ${arg_FILES})
      cmake_path(GET file PARENT_PATH folder)
      file(MAKE_DIRECTORY ${tree}/${room}/${folder})
      file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${room}/${file} ${tree}/${room}/${file} SYMBOLIC)
    endforeach()
  else()
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${room} ${tree}/${room} SYMBOLIC)
  endif()
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    target_include_directories(${target} INTERFACE ${tree})
  else()
    target_include_directories(${target} PUBLIC ${tree})
  endif()
endfunction()

# rambla_room(ROOM PUBLIC target... PRIVATE target...): the library rambla_ROOM from all sources of this folder but
# example.cpp, a program that shows its use.
function(rambla_room room)
  cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/example\\.cpp$")
  add_library(rambla_${room} STATIC ${sources})
  rambla_include_tree(rambla_${room} ${room})
  target_link_libraries(rambla_${room} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} rambla_options)
endfunction()
