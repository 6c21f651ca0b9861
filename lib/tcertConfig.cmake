# find_package(tcert) -> target_link_libraries(robot_loop PRIVATE tcert::core)
include("${CMAKE_CURRENT_LIST_DIR}/tcertTargets.cmake")

# tcert::terrain, where it was built and Eigen is there.
if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/tcertTerrainTargets.cmake")
  find_package(Eigen3 3.4 QUIET NO_MODULE)
  if(TARGET Eigen3::Eigen)
    include("${CMAKE_CURRENT_LIST_DIR}/tcertTerrainTargets.cmake")
  endif()
endif()
