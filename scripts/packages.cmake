# CPack: one Debian package per component.
include(GNUInstallDirs)
set(packages_runtime libtcert1)
set(packages_dev libtcert-dev)
set(packages_tool tcert)
set(packages_statistics libtcert-statistics-dev)
set(components runtime dev)
if(TCERT_BUILD_TOOLS)
  list(APPEND components tool statistics)
endif()
foreach(component IN LISTS components)
  install(FILES LICENSE RENAME copyright COMPONENT ${component}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${packages_${component}})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tcert)
set(CPACK_PACKAGE_CONTACT "the authors of tcert <tcert@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libtcert1)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "traversability certificates from what a robot felt: shared C library")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libtcert-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libtcert1 (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_DEV_DESCRIPTION
  "traversability certificates from what a robot felt: headers, archive, CMake and pkg-config files")

set(CPACK_DEBIAN_TOOL_PACKAGE_NAME tcert)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION science)
set(CPACK_COMPONENT_TOOL_DESCRIPTION
  "traversability certificates from what a robot felt: log analysis, statistics, live certification")

set(CPACK_DEBIAN_STATISTICS_PACKAGE_NAME libtcert-statistics-dev)
set(CPACK_DEBIAN_STATISTICS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_STATISTICS_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_STATISTICS_PACKAGE_DEPENDS
  "libtcert-dev (= ${PROJECT_VERSION}), libeigen3-dev, libceres-dev, nlohmann-json3-dev, libfmt-dev, libtbb-dev, zlib1g-dev, libzstd-dev")
set(CPACK_COMPONENT_STATISTICS_DESCRIPTION
  "traversability certificates: the estimators alone (Cox, survival, C, AUC, mixed models, resampling)")
include(CPack)
