# SPDX-License-Identifier: GPL-3.0-or-later
# The C library: libsurefoot1, and libsurefoot-dev for compiling programs that use it.
set(libraries ${CMAKE_INSTALL_LIBDIR})
if(libraries STREQUAL lib AND CMAKE_LIBRARY_ARCHITECTURE)
  string(APPEND libraries /${CMAKE_LIBRARY_ARCHITECTURE})  # where Debian has them, whatever the prefix
endif()
get_target_property(api surefoot_library SOVERSION)
set(SUREFOOT_LIBRARY_PACKAGE libsurefoot${api})

set_target_properties(surefoot_library PROPERTIES EXPORT_NAME surefoot)
install(TARGETS surefoot_library EXPORT surefoot
        LIBRARY DESTINATION ${libraries} COMPONENT library NAMELINK_COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/app/library/surefoot.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development)

# For pkg-config (`surefoot`) and CMake (`find_package(surefoot)`, surefoot::surefoot), wherever it is installed.
file(RELATIVE_PATH up /${libraries}/pkgconfig /)
configure_file(${here}/surefoot.pc.in ${made}/surefoot.pc @ONLY)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${made}/surefoot-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${made}/surefoot.pc DESTINATION ${libraries}/pkgconfig COMPONENT development)
install(EXPORT surefoot NAMESPACE surefoot:: FILE surefoot-config.cmake DESTINATION ${libraries}/cmake/surefoot
        COMPONENT development)
install(FILES ${made}/surefoot-config-version.cmake DESTINATION ${libraries}/cmake/surefoot COMPONENT development)
surefoot_package_papers(library ${SUREFOOT_LIBRARY_PACKAGE})
surefoot_package_papers(development libsurefoot-dev)

list(APPEND CPACK_COMPONENTS_ALL library development)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)  # what programs that are linked against it will depend on
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${SUREFOOT_LIBRARY_PACKAGE})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "surefoot (>= ${PROJECT_VERSION})")  # robots and plans by name
# ldconfig is called by a trigger. CPack adds scripts that call it, too, unless some are named here: these are no files,
# so there are none.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${here}/library/triggers ${made}/none/postinst ${made}/none/postrm)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
"Surefoot is a workbench for reinforcement learning that avoids falling.
This library is its code behind one C header: robots that fall as worlds for
one's own learner, its learners, experiments and their statistics. A life
has the same bits as in the program.
.
Robots and plans that are asked for by name are in the package surefoot.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsurefoot-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS library)  # of the same version
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"Surefoot is a workbench for reinforcement learning that avoids falling.
This is what programs in C, and in languages that call C, are compiled with:
the header surefoot.h, which is its manual, and files for pkg-config and
CMake.")
