# SPDX-FileCopyrightText: 2026 The Burin authors
# SPDX-License-Identifier: Apache-2.0
# The locations of an installed Burin's files, all relative to the program (core/base/file.h looks there), and the
# Debian package: cmake --install build/release --prefix FOLDER, and cpack -G DEB --config
# build/release/CPackConfig.cmake.

set(burin_id org.burin.Burin) # of desktop entry, icon and metadata
set(desktop ${CMAKE_SOURCE_DIR}/resources/desktop)

install(TARGETS burin RUNTIME DESTINATION bin)
install(TARGETS burin-import RUNTIME DESTINATION lib/burin)
get_property(plugins GLOBAL PROPERTY BURIN_PLUGINS)
foreach(plugin IN LISTS plugins)
    get_target_property(folder ${plugin} BURIN_PLUGIN_FOLDER)
    install(TARGETS ${plugin} LIBRARY DESTINATION lib/burin/${folder})
    install(FILES ${CMAKE_BINARY_DIR}/${folder}/plugin.json DESTINATION lib/burin/${folder})
endforeach()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/ DESTINATION share/burin/resources
    PATTERN CMakeLists.txt EXCLUDE PATTERN *.cpp EXCLUDE PATTERN udev EXCLUDE PATTERN desktop EXCLUDE)
foreach(language IN LISTS BURIN_LANGUAGES)
    install(FILES ${CMAKE_BINARY_DIR}/translations/burin_${language}.qm DESTINATION share/burin/translations)
endforeach()

install(FILES ${desktop}/${burin_id}.desktop DESTINATION share/applications)
install(FILES ${desktop}/${burin_id}.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES ${desktop}/${burin_id}.xml DESTINATION share/mime/packages)
install(FILES ${desktop}/burin.bash-completion DESTINATION share/bash-completion/completions RENAME burin)
install(FILES ${CMAKE_SOURCE_DIR}/resources/udev/70-burin-devices.rules DESTINATION lib/udev/rules.d)
install(FILES ${desktop}/copyright DESTINATION share/doc/burin)

# Installed files get the date of the sources, so that the same sources give the same package.
string(TIMESTAMP burin_date "%Y-%m-%d" UTC)
string(TIMESTAMP burin_changelog_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
find_package(Git QUIET)
if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} log -1 "--format=%cs;%cD" WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
        OUTPUT_VARIABLE committed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(committed)
        list(GET committed 0 burin_date)
        list(GET committed 1 burin_changelog_date)
    endif()
endif()
configure_file(${desktop}/${burin_id}.metainfo.xml.in ${CMAKE_BINARY_DIR}/${burin_id}.metainfo.xml @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/${burin_id}.metainfo.xml DESTINATION share/metainfo)

# The man page is made from the program's own help. Both files are compressed as Debian requires, without name or time.
find_program(HELP2MAN help2man REQUIRED)
find_program(GZIP gzip REQUIRED)
configure_file(${desktop}/changelog.in ${CMAKE_BINARY_DIR}/changelog @ONLY)
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/burin.1.gz ${CMAKE_BINARY_DIR}/changelog.gz
    COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 ${HELP2MAN} --no-info --section=1 --source=Burin
        "--name=author milling tool paths by hand" "--help-option=--help-all" --version-string=${PROJECT_VERSION}
        --output=${CMAKE_BINARY_DIR}/burin.1 $<TARGET_FILE:burin>
    COMMAND ${GZIP} -9nkf ${CMAKE_BINARY_DIR}/burin.1 ${CMAKE_BINARY_DIR}/changelog
    DEPENDS burin burin_translations ${CMAKE_BINARY_DIR}/changelog COMMENT "Writing the man page")
add_custom_target(burin_documents ALL DEPENDS ${CMAKE_BINARY_DIR}/burin.1.gz)
add_dependencies(burin_program burin_documents)
install(FILES ${CMAKE_BINARY_DIR}/burin.1.gz DESTINATION share/man/man1)
install(FILES ${CMAKE_BINARY_DIR}/changelog.gz DESTINATION share/doc/burin)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME burin)
set(CPACK_PACKAGE_CONTACT "The Burin authors <burin@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Workstation for authoring milling tool paths by hand")
set(CPACK_PACKAGE_DESCRIPTION "Burin embeds a CAD part in a virtual stock, which is milled with a stylus or
the mouse. The part's boundary pushes back, so that the hand can't gouge it.
What the hand did is recorded, edited, smoothed, checked against the part and
posted as NC code that a real machine runs.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Dependencies that no library names: Qt's own translations, a font with digits of equal width, software OpenGL.
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "qt6-translations-l10n, fonts-roboto-unhinted, libgl1-mesa-dri, libegl-mesa0, shared-mime-info")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "rtkit")
include(CPack)
