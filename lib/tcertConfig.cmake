# find_package(tcert) -> target_link_libraries(robot_loop PRIVATE tcert::core)
include("${CMAKE_CURRENT_LIST_DIR}/tcertTargets.cmake")
