# What `cmake --install` lays down below its prefix: programs, libraries for other programs, resources, and what a desktop
# and a shell want to know. Nothing of it holds a path of the build or of the prefix, so the tree may be moved.
include(CMakePackageConfigHelpers)

set(alltact_packaging ${CMAKE_SOURCE_DIR}/packaging)
set(alltact_built ${CMAKE_BINARY_DIR}/share_built)
set(alltact_data ${CMAKE_INSTALL_DATADIR}/alltact)

# --- programs and their parts
install(TARGETS alltact alltact-studio RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS alltact_commands alltact_figures LIBRARY DESTINATION ${ALLTACT_PARTS_FOLDER})

# --- what find_package(alltact) needs for the libraries, which core and calibration install
set(alltact_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/alltact)
install(EXPORT alltact NAMESPACE alltact:: FILE alltact-targets.cmake DESTINATION ${alltact_cmake_folder})
configure_package_config_file(${alltact_packaging}/cmake/alltact-config.cmake.in ${alltact_built}/alltact-config.cmake
                              INSTALL_DESTINATION ${alltact_cmake_folder})
write_basic_package_version_file(${alltact_built}/alltact-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${alltact_built}/alltact-config.cmake ${alltact_built}/alltact-config-version.cmake
        DESTINATION ${alltact_cmake_folder})
# Headers that others may include stand in include/alltact, what those need themselves in include/alltact/detail.
install(CODE "set(alltact_sources \"${CMAKE_SOURCE_DIR}\")
set(alltact_include \"${CMAKE_INSTALL_INCLUDEDIR}/alltact\")")
install(SCRIPT ${alltact_packaging}/cmake/install_headers.cmake)

# --- resources, found by find_resource()
install(DIRECTORY resources/scenes resources/bodies packaging/clients DESTINATION ${alltact_data}
        PATTERN __pycache__ EXCLUDE)
install(FILES packaging/python/README.md packaging/python/alltact_finger.py DESTINATION ${alltact_data}/python)
install(DIRECTORY resources/models DESTINATION ${alltact_data} FILES_MATCHING PATTERN "*.onnx" PATTERN "*.yaml")
install(FILES packaging/70-alltact.rules DESTINATION lib/udev/rules.d)

# --- what people read
install(DIRECTORY resources/help resources/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources
        FILES_MATCHING PATTERN "*.md" PATTERN "*.png")
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
foreach(folder IN ITEMS core/finger tests/bench) # the formats of files, and the figures
  install(FILES ${folder}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
# The manual as one HTML file and one PDF, where python3-markdown is installed.
execute_process(COMMAND /usr/bin/python3 -c "import markdown" RESULT_VARIABLE alltact_no_markdown OUTPUT_QUIET ERROR_QUIET)
if(NOT alltact_no_markdown)
  file(GLOB alltact_manual_pages CONFIGURE_DEPENDS resources/help/*.md resources/help/*.png)
  add_custom_command(
    OUTPUT ${alltact_built}/manual/manual.html ${alltact_built}/manual/manual.pdf
    COMMAND ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER} ${alltact_packaging}/manual -o ${alltact_built}/manual
    DEPENDS ${alltact_packaging}/manual ${alltact_packaging}/manual_pdf.cpp ${alltact_manual_pages}
            ${CMAKE_SOURCE_DIR}/core/finger/README.md
    VERBATIM)
  add_custom_target(alltact_manual ALL DEPENDS ${alltact_built}/manual/manual.html ${alltact_built}/manual/manual.pdf)
  install(FILES ${alltact_built}/manual/manual.html ${alltact_built}/manual/manual.pdf DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
install(DIRECTORY packaging/example DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Manual pages and completions: the programs know their commands and settings, and tell them once they are built.
set(alltact_commands_pages alltact alltact-studio)
file(STRINGS app/console/command_names.h alltact_commands_lines REGEX "CommandName{\"")
foreach(line IN LISTS alltact_commands_lines)
  string(REGEX REPLACE ".*CommandName{\"([a-z]+)\".*" "alltact-\\1" page "${line}")
  list(APPEND alltact_commands_pages ${page})
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS app/console/command_names.h)
set(alltact_told "")
# alltact_tell(FILE ARGUMENTS...): what the program prints becomes the file.
function(alltact_tell file)
  add_custom_command(
    OUTPUT ${alltact_built}/${file}
    COMMAND alltact ${ARGN} > ${alltact_built}/${file}.new
    COMMAND ${CMAKE_COMMAND} -E rename ${alltact_built}/${file}.new ${alltact_built}/${file}
    DEPENDS alltact alltact_commands
    VERBATIM)
  set(alltact_told ${alltact_told} ${alltact_built}/${file} PARENT_SCOPE)
endfunction()
foreach(folder IN ITEMS man bash zsh fish icons)
  file(MAKE_DIRECTORY ${alltact_built}/${folder})
endforeach()
foreach(page IN LISTS alltact_commands_pages)
  alltact_tell(man/${page}.1 --man ${page})
  install(FILES ${alltact_built}/man/${page}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endforeach()
foreach(program IN ITEMS alltact alltact-studio)
  alltact_tell(bash/${program} --completions bash ${program})
  alltact_tell(zsh/_${program} --completions zsh ${program})
  alltact_tell(fish/${program}.fish --completions fish ${program})
  install(FILES ${alltact_built}/bash/${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${alltact_built}/zsh/_${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${alltact_built}/fish/${program}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endforeach()

# --- what a desktop wants to know
find_program(RSVG_CONVERT rsvg-convert REQUIRED)
set(alltact_icon ${CMAKE_SOURCE_DIR}/resources/icons/alltact.svg)
foreach(size IN ITEMS 16 22 24 32 48 64 128 256 512)
  set(png ${alltact_built}/icons/alltact-studio_${size}.png)
  add_custom_command(
    OUTPUT ${png}
    COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${png} ${alltact_icon}
    DEPENDS ${alltact_icon}
    VERBATIM)
  list(APPEND alltact_told ${png})
  install(FILES ${png} DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps RENAME alltact-studio.png)
endforeach()
install(FILES ${alltact_icon} DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps RENAME alltact-studio.svg)
install(FILES packaging/desktop/alltact-studio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
# Software centres fetch screenshots from the web: whoever publishes the program says from where.
set(ALLTACT_PICTURES_URL "https://alltact.example/pictures" CACHE STRING "Where resources/pictures is published")
configure_file(packaging/desktop/alltact-studio.metainfo.xml.in ${alltact_built}/alltact-studio.metainfo.xml @ONLY)
install(FILES ${alltact_built}/alltact-studio.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES packaging/desktop/alltact.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES packaging/desktop/alltact.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)

add_custom_target(alltact_desktop ALL DEPENDS ${alltact_told})
if(TARGET alltact_manual)
  add_dependencies(alltact_desktop alltact_manual) # so that whoever waits for it can install
endif()
