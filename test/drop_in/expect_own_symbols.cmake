# Fails if the library exports a function of anyone else, which could take the place of that one's own.
# Usage: cmake -P expect_own_symbols.cmake NM LIBRARY
execute_process(COMMAND ${CMAKE_ARGV3} -D -C --defined-only ${CMAKE_ARGV4}
  OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL " T [^\n]*" functions "${symbols}")
set(own "pcl_attention::|pcl::(Attention|CompactPatch|PlanarPatch|SymmetrySaliency)")
set(others ${functions})
list(FILTER others EXCLUDE REGEX ${own})
if(NOT functions MATCHES ${own} OR others)
  message(FATAL_ERROR "${CMAKE_ARGV4} exports\n${others}")
endif()
