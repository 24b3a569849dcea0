# Contraction is off: the same source gives the same bits on every backend and vector width.
# Kernels ask for fma by name. The CPU baseline is x86-64-v3 (AVX2, FMA). Neighbouring scalars are not
# joined in vectors: g++ 12 then drops roundings to float (tests/unit/parallel/RoundingTest.cpp).
# Programs of others that use the installed libraries take of these only what the text of our headers needs.
add_library(fpmFlags INTERFACE)
target_include_directories(fpmFlags INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/libs>
    $<INSTALL_INTERFACE:include/fpm>)
target_compile_features(fpmFlags INTERFACE cxx_std_20)
target_compile_options(fpmFlags INTERFACE
    "$<BUILD_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wshadow;-Werror;-ffp-contract=off;\
-fno-math-errno;-fno-tree-slp-vectorize;-march=x86-64-v3>>"
    "$<INSTALL_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off;-fno-tree-slp-vectorize>>")
# A mask of one number is bool, and & stands between masks of any width.
target_compile_options(fpmFlags INTERFACE
    $<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wno-bitwise-instead-of-logical>)

# Programs look for libraries beside them too, and so do those libraries (RPATH, not RUNPATH): a folder
# with bin/ and lib/ runs where it is put (etc/gpuBundle).
set(CMAKE_BUILD_RPATH "$ORIGIN/../lib")
add_link_options(-Wl,--disable-new-dtags)

# No checksum of the build in a program: builds that differ in their git revision alone stay equal but
# for that (withoutRevision in base/Version.h).
add_link_options(-Wl,--build-id=none)
