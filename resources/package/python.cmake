# SPDX-License-Identifier: GPL-3.0-or-later
# The Python package, for every Python 3 of Debian: python3-surefoot. It is compiled to bytes where it is installed. By
# `cmake --install` it is not installed (pip install ./app/python is), because each prefix has another place for it.
set(python ${PROJECT_SOURCE_DIR}/app/python)
set(packages lib/python3/dist-packages)
configure_file(${here}/python/egg-info.in ${made}/surefoot.egg-info @ONLY)
install(DIRECTORY ${python}/surefoot DESTINATION ${packages} COMPONENT python EXCLUDE_FROM_ALL
        FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
install(FILES ${made}/surefoot.egg-info DESTINATION ${packages} COMPONENT python EXCLUDE_FROM_ALL
        RENAME surefoot-${PROJECT_VERSION}.egg-info)
install(DIRECTORY ${python}/notebooks/ DESTINATION ${share}/doc/python3-surefoot/examples COMPONENT python
        EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.py")
surefoot_package_papers(python python3-surefoot EXCLUDE_FROM_ALL)

list(APPEND CPACK_COMPONENTS_ALL python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-surefoot)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.9), python3-numpy (>= 1:1.22), ${SUREFOOT_LIBRARY_PACKAGE} (>= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "surefoot (>= ${PROJECT_VERSION})")  # robots and plans by name
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${here}/python/postinst ${here}/python/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
"Surefoot is a workbench for reinforcement learning that avoids falling.
This package has its robots as worlds with the interface of Gymnasium (which
need not be there), its learners, whose lives have the same bits as in the
program, experiments on all processors, and their results as arrays.
.
Robots and plans that are asked for by name are in the package surefoot.")
