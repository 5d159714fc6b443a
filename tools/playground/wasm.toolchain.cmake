# For WebAssembly: Debian's clang with the C library of WASI. No exceptions: there are none below
# src/command, and what a library would throw ends the instance.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-22)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR ar)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_FLAGS_INIT "-fno-exceptions -fno-stack-protector -Wno-deprecated")
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
# Headers and libraries of this machine are for another one.
set(CMAKE_FIND_ROOT_PATH /usr/lib/wasm32-wasi)
