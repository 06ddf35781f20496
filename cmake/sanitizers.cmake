# FALKO_SLAM_SANITIZE and FALKO_SLAM_FUZZ watch every target: a library that is watched in a program
# that is not does not even start.
set(undefined_behaviour -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=all)
if(FALKO_SLAM_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "FALKO_SLAM_FUZZ needs clang: -DCMAKE_CXX_COMPILER=clang++")
  endif()
  # What looks at every pointer doubles the time to compile, and AddressSanitizer finds it, too.
  set(numbers signed-integer-overflow,integer-divide-by-zero,shift,float-cast-overflow,bounds)
  set(sanitizers -fsanitize=address,fuzzer-no-link
    -fsanitize=${numbers},enum,bool,return,unreachable,vla-bound -fno-sanitize-recover=all)
elseif(FALKO_SLAM_SANITIZE STREQUAL "address")
  set(sanitizers -fsanitize=address ${undefined_behaviour})
elseif(FALKO_SLAM_SANITIZE STREQUAL "thread")
  set(sanitizers -fsanitize=thread)
elseif(FALKO_SLAM_SANITIZE)
  message(FATAL_ERROR "FALKO_SLAM_SANITIZE=${FALKO_SLAM_SANITIZE} is neither address nor thread")
endif()
if(DEFINED sanitizers)
  add_compile_options(${sanitizers} -fno-omit-frame-pointer)
  add_link_options(${sanitizers})
endif()
