# Fails if one of the programs or libraries given after it is linked with VTK, directly or by what it is linked with.
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE 3 ${last})
  execute_process(COMMAND ldd ${CMAKE_ARGV${i}} OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
  if(NOT libraries MATCHES "libpcl_common" OR libraries MATCHES "not found|libvtk")
    message(FATAL_ERROR "${CMAKE_ARGV${i}} is linked with\n${libraries}")
  endif()
endforeach()
