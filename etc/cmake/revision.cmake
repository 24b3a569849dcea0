# cmake -DSOURCES=<folder> -DFILE=<file.cpp> -P revision.cmake: writes the git revision of the sources as a
# constant (base/Revision.h), "-dirty" behind it where files differ from it, nothing where the folder is
# no repository of its own. A file that would stay as it is keeps its date, so that nothing is built anew.
set(revision "")
find_program(GIT git)
if(GIT)
    execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCES}
        OUTPUT_VARIABLE top ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    file(REAL_PATH "${SOURCES}" here)
    if("${top}" STREQUAL "${here}")
        execute_process(COMMAND ${GIT} describe --always --dirty --exclude=*
            WORKING_DIRECTORY ${SOURCES} OUTPUT_VARIABLE revision ERROR_QUIET
            OUTPUT_STRIP_TRAILING_WHITESPACE)
    endif()
endif()
set(text "#include \"base/Revision.h\"\n
namespace fpm {\n
const char revisionRecord[revisionBytes] = \"fpm revision: ${revision}\";\n
} // namespace fpm\n")
set(before "")
if(EXISTS "${FILE}")
    file(READ "${FILE}" before)
endif()
if(NOT before STREQUAL text)
    file(WRITE "${FILE}" "${text}")
endif()
