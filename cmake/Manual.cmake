# Manual pages and the completion for bash, written from the options of the program.
add_executable(prosup_manual src/manual_main.cc)
target_link_libraries(prosup_manual PRIVATE prosup_pipeline prosup_options)
target_include_directories(prosup_manual PRIVATE ${PROJECT_SOURCE_DIR}/src)
set(manual ${PROJECT_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual}/completions/prosup
  COMMAND prosup_manual ${manual} DEPENDS prosup_manual VERBATIM)
add_custom_target(manual ALL DEPENDS ${manual}/completions/prosup)

install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES ${manual}/completions/prosup
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
