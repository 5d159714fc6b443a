# What Debian asks of a package beyond what `cmake --install` puts in place; CPack runs it over the files
# of each package before it packs them: manual pages and changes are compressed, completions of zsh stand
# where Debian's zsh looks, each package has its copyright file, and libraries hold no debugging symbols.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}: ${errors}")
  endif()
endfunction()

# The same bytes every time: neither names nor times.
function(compress)
  foreach(file ${ARGN})
    run(gzip -9nf ${file})
  endforeach()
endfunction()

# The changes of the package, which are those of the program, in Debian's form.
function(write_changes folder package)
  file(READ ${here}/../../CHANGELOG.md text)
  string(REGEX MATCH "## \\[${CPACK_PACKAGE_VERSION}\\] - ([0-9-]+)" found "${text}")
  set(day ${CMAKE_MATCH_1})
  execute_process(COMMAND date --utc --rfc-email "--date=${day}T00:00:00Z"
    OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
  file(WRITE ${folder}/changelog.Debian
    "${package} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}: see changelog.gz.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  compress(${folder}/changelog.Debian)
endfunction()

set(here ${CMAKE_CURRENT_LIST_DIR})
set(packages program grafwire library libgrafwire-dev)
while(packages)
  list(POP_FRONT packages component package)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(doc ${root}/share/doc/${package})
  file(MAKE_DIRECTORY ${doc})
  file(COPY ${here}/copyright DESTINATION ${doc})
  file(COPY ${here}/../../CHANGELOG.md DESTINATION ${doc})
  file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
  compress(${doc}/changelog)
  write_changes(${doc} ${package})
  file(GLOB_RECURSE pages ${root}/share/man/*.1)
  compress(${pages})
  if(EXISTS ${root}/share/zsh/site-functions)
    file(RENAME ${root}/share/zsh/site-functions ${root}/share/zsh/vendor-completions)
  endif()
  file(GLOB_RECURSE archives ${root}/lib/*.a)
  foreach(archive ${archives})
    run(strip --strip-debug --remove-section=.comment --remove-section=.note --enable-deterministic-archives ${archive})
  endforeach()
  file(GLOB_RECURSE files ${root}/share/* ${root}/include/* ${root}/lib/*)
  file(CHMOD ${files} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endwhile()
