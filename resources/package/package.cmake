# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed, and the Debian packages: `cmake --build build/release --target package`. A component is a package;
# here is `program`. Others (library, development, python) have their files beside this one.
include(GNUInstallDirs)
set(SUREFOOT_HOMEPAGE "" CACHE STRING "Where the project is published, with screenshots/ below it; empty: nowhere yet")
set(SUREFOOT_APP_ID "org.surefoot.surefoot" CACHE STRING "The program's name in software centres")
# Debian asks for an address; .invalid is no one's (RFC 2606).
set(SUREFOOT_MAINTAINER "The Surefoot maintainers <maintainers@surefoot.invalid>" CACHE STRING "Who makes packages")

# The date of the release, from the newest heading of the CHANGELOG; before it is released, that of the last commit.
file(STRINGS ${PROJECT_SOURCE_DIR}/CHANGELOG.md headings REGEX "^## ")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
list(GET headings 0 newest)
set(SUREFOOT_DATE 2026-01-01)
if(newest MATCHES "(20[0-9][0-9]-[01][0-9]-[0-3][0-9])")
  set(SUREFOOT_DATE ${CMAKE_MATCH_1})
else()
  execute_process(COMMAND git log -1 --format=%cs WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE committed
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(committed MATCHES "^20[0-9-]+$")
    set(SUREFOOT_DATE ${committed})
  endif()
endif()

# Made by the program and beside it; program and manual have the version from here.
set(here ${CMAKE_CURRENT_LIST_DIR})
set(resources ${PROJECT_SOURCE_DIR}/resources)
set(made ${PROJECT_BINARY_DIR}/package)
# Lines and pictures that need a homepage are left out where there is none: nothing points to what is not there.
function(surefoot_configure from to)
  file(READ ${from} content)
  if(NOT SUREFOOT_HOMEPAGE)
    string(REGEX REPLACE "\n *<screenshots>.*</screenshots>" "" content "${content}")
    string(REGEX REPLACE "\n[^\n]*@SUREFOOT_HOMEPAGE@[^\n]*" "" content "${content}")
  endif()
  file(CONFIGURE OUTPUT ${to} CONTENT "${content}" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${from})
endfunction()
surefoot_configure(${resources}/desktop/surefoot.metainfo.xml.in ${made}/${SUREFOOT_APP_ID}.metainfo.xml)
surefoot_configure(${here}/copyright.in ${made}/copyright)
add_custom_command(OUTPUT ${made}/changelog.gz VERBATIM
  COMMAND sh ${here}/debian_changelog.sh ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${made}/changelog.gz ${PROJECT_VERSION}
          ${SUREFOOT_DATE} ${SUREFOOT_MAINTAINER}
  DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${here}/debian_changelog.sh)
add_custom_command(OUTPUT ${made}/manual VERBATIM
  COMMAND sh ${here}/manual.sh $<TARGET_FILE:surefoot> ${made}/manual ${SUREFOOT_DATE}
  DEPENDS surefoot ${here}/manual.sh)
set(for_packages ${made}/changelog.gz ${made}/manual)
if(SUREFOOT_UI)
  add_custom_command(OUTPUT ${made}/icons VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${made}/icons
    COMMAND surefoot_icons ${resources}/desktop/surefoot.svg ${made}/icons
    DEPENDS surefoot_icons ${resources}/desktop/surefoot.svg)
  list(APPEND for_packages ${made}/icons)
endif()
add_custom_target(surefoot_package_files ALL DEPENDS ${for_packages})

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
set(share ${CMAKE_INSTALL_DATADIR})

# What every package has to say of itself.
function(surefoot_package_papers component package)
  install(FILES ${made}/copyright ${made}/changelog.gz DESTINATION ${share}/doc/${package}
          COMPONENT ${component} ${ARGN})
endfunction()

surefoot_package_papers(program surefoot)
install(TARGETS surefoot COMPONENT program)
install(DIRECTORY ${resources}/lessons ${resources}/plans ${resources}/recipes ${resources}/robots ${resources}/about
                  ${resources}/handbook ${resources}/screenshots
        DESTINATION ${share}/surefoot)
install(PROGRAMS ${resources}/slurm/experiment.sh DESTINATION ${share}/surefoot/slurm)
install(DIRECTORY ${made}/manual/ DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${resources}/completions/surefoot.bash DESTINATION ${share}/bash-completion/completions RENAME surefoot)
install(FILES ${resources}/completions/_surefoot DESTINATION ${share}/zsh/vendor-completions)
install(FILES ${resources}/completions/surefoot.fish DESTINATION ${share}/fish/vendor_completions.d)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${share}/doc/surefoot)
if(SUREFOOT_UI)
  install(FILES ${resources}/desktop/surefoot.svg DESTINATION ${share}/surefoot/desktop)
  install(FILES ${resources}/desktop/surefoot.svg DESTINATION ${share}/icons/hicolor/scalable/apps)
  foreach(size 16 22 24 32 48 64 128 256 512)
    install(FILES ${made}/icons/${size}.png DESTINATION ${share}/icons/hicolor/${size}x${size}/apps RENAME surefoot.png)
  endforeach()
  install(FILES ${resources}/desktop/surefoot.desktop DESTINATION ${share}/applications)
  install(FILES ${resources}/desktop/surefoot-mime.xml DESTINATION ${share}/mime/packages RENAME surefoot.xml)
  install(FILES ${made}/${SUREFOOT_APP_ID}.metainfo.xml DESTINATION ${share}/metainfo)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
if(SUREFOOT_HOMEPAGE)
  set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${SUREFOOT_HOMEPAGE})
endif()
set(CPACK_PACKAGE_CONTACT "${SUREFOOT_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "reinforcement learning that avoids falling")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME surefoot)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-roboto-unhinted, bubblewrap")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, python3, qt6-wayland")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"A robot that learns by trial and error falls, and breaks. Surefoot is a
workbench in which an inverted pendulum, a walking robot or a robot from
a text file learns before one's eyes, while one turns the knobs that decide
how often it falls. It has lessons for a class, a laboratory of many lives
with intervals and tests, and does the same without a window, bit for bit.")

# Each installs its components, appends them to CPACK_COMPONENTS_ALL and sets their CPACK_DEBIAN_<COMPONENT>_….
include(${here}/library.cmake)
include(${here}/python.cmake)
include(CPack)
