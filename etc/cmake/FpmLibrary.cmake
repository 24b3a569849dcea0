# fpmLibrary(name [INTERNAL] USES lib... LINKS target... FOLDERS folder...): a static library of every .cpp in
# this folder and those named, or an interface library where there is none. It is installed with its headers
# and is fpm::<name> to others; INTERNAL: it serves the programs of this project alone.

function(fpmLibrary name)
    cmake_parse_arguments(arg "INTERNAL" "" "USES;LINKS;FOLDERS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    foreach(folder ${arg_FOLDERS})
        file(GLOB inFolder CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND sources ${inFolder})
    endforeach()
    list(TRANSFORM arg_USES PREPEND fpm_)
    if(sources)
        add_library(fpm_${name} STATIC ${sources})
        target_link_libraries(fpm_${name} PUBLIC fpmFlags ${arg_USES} PRIVATE ${arg_LINKS})
    else()
        add_library(fpm_${name} INTERFACE)
        target_link_libraries(fpm_${name} INTERFACE fpmFlags ${arg_USES} ${arg_LINKS})
    endif()
    if(NOT arg_INTERNAL)
        set_property(TARGET fpm_${name} PROPERTY EXPORT_NAME ${name})
        install(TARGETS fpm_${name} EXPORT fpmTargets ARCHIVE DESTINATION lib COMPONENT libraries)
        install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} DESTINATION include/fpm COMPONENT libraries
            FILES_MATCHING PATTERN "*.h")
    endif()
endfunction()

# Of nvcc for kernels: no contraction there either, so that the bits agree.
set(fpmCudaFlags -std=c++20 --fmad=false --expt-relaxed-constexpr --Werror=all-warnings
    -Xcompiler=-march=x86-64-v3,-ffp-contract=off,-fno-math-errno,-fno-tree-slp-vectorize)

# fpmCudaObjects(target source...): kernels for the GPU. CMake 3.25.1 takes the C++ standard for CUDA too
# and cannot ask nvcc for 20: a target of its own, by flag.
function(fpmCudaObjects target)
    add_library(${target} OBJECT ${ARGN})
    set_property(TARGET ${target} PROPERTY CXX_STANDARD)
    set_target_properties(${target} PROPERTIES CXX_STANDARD_REQUIRED OFF CXX_EXTENSIONS ON)
    target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/libs)
    target_compile_options(${target} PRIVATE ${fpmCudaFlags})
endfunction()
