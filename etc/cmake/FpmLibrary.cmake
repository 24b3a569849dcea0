# fpmLibrary(name USES lib... LINKS target...): a static library of every .cpp in this folder, or an
# interface library where there is none.
function(fpmLibrary name)
    cmake_parse_arguments(arg "" "" "USES;LINKS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    list(TRANSFORM arg_USES PREPEND fpm_)
    if(sources)
        add_library(fpm_${name} STATIC ${sources})
        target_link_libraries(fpm_${name} PUBLIC fpmFlags ${arg_USES} PRIVATE ${arg_LINKS})
    else()
        add_library(fpm_${name} INTERFACE)
        target_link_libraries(fpm_${name} INTERFACE fpmFlags ${arg_USES} ${arg_LINKS})
    endif()
endfunction()
