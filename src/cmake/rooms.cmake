# A room is one folder with its own list of sources, and one static library. It says which other rooms
# it needs, and sees no header of any other: what is not named here cannot be included.
#
#   tribolog_room(method/gravity
#     SOURCES cog_sweep.cpp ...   of the folder
#     PUBLIC joint statistics     rooms that its headers include
#     PRIVATE base                rooms that its sources include
#     LIBRARIES Eigen3::Eigen)    others' libraries, for its sources; PUBLIC_LIBRARIES, for its headers
#
# WORDS after the name: it makes words and pages of numbers, and computes none. Such a room is compiled
# in two thirds of the time with -O1, and nobody waits for it.
#
# The library is tribolog_method_gravity. A room may need those alone that were made before it: where
# there is an order, there is no circle. Headers are included by their path: "method/gravity/cog_sweep.h".
set(TRIBOLOG_ROOM_VIEWS ${PROJECT_BINARY_DIR}/rooms)

# The library's name of each room. Fails where a room is needed before it is made.
function(tribolog_targets_of variable)
  set(targets "")
  foreach(room IN LISTS ARGN)
    string(REPLACE "/" "_" target "tribolog_${room}")
    if(NOT TARGET ${target})
      message(FATAL_ERROR "the room '${room}' is needed before it is made: see the order in src/CMakeLists.txt")
    endif()
    list(APPEND targets ${target})
  endforeach()
  set(${variable} "${targets}" PARENT_SCOPE)
endfunction()

# A folder that holds nothing but a link to the room: with it on the search path, the room's headers
# are found, and no other's.
function(tribolog_show_room target room)
  get_filename_component(above ${room} DIRECTORY)
  file(MAKE_DIRECTORY ${TRIBOLOG_ROOM_VIEWS}/${target}/${above})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${TRIBOLOG_ROOM_VIEWS}/${target}/${room} SYMBOLIC)
endfunction()

function(tribolog_room room)
  cmake_parse_arguments(R "WORDS" "" "SOURCES;PUBLIC;PRIVATE;LIBRARIES;PUBLIC_LIBRARIES" ${ARGN})
  if(R_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tribolog_room(${room}): what is '${R_UNPARSED_ARGUMENTS}'?")
  endif()
  tribolog_targets_of(public ${R_PUBLIC})
  tribolog_targets_of(private ${R_PRIVATE})
  string(REPLACE "/" "_" target "tribolog_${room}")
  tribolog_show_room(${target} ${room})
  add_library(${target} STATIC ${R_SOURCES})
  target_include_directories(${target} PUBLIC ${TRIBOLOG_ROOM_VIEWS}/${target})
  target_compile_options(${target} PRIVATE ${TRIBOLOG_CONVERSION_WARNINGS})
  if(R_WORDS)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  target_link_libraries(${target} PUBLIC tribolog_flags ${public} ${R_PUBLIC_LIBRARIES}
                        PRIVATE ${private} ${R_LIBRARIES})
endfunction()
