# To how many bytes the compiler's flags make Eigen align: part of the binary interface, hence in the installed version.h,
# by which include/pcl_attention/alignment_guard.h compares it with that of the user's flags.
find_package(Eigen3 REQUIRED NO_MODULE)

# As the build type compiles, and anew at every run, since the flags may have changed.
set(CMAKE_TRY_COMPILE_CONFIGURATION ${CMAKE_BUILD_TYPE})
set(PCL_ATTENTION_EIGEN_ALIGNMENT 0)
foreach(bytes 16 32 64)
  set(source ${PROJECT_BINARY_DIR}/CMakeFiles/eigen_aligns_to_${bytes}.cpp)
  file(WRITE ${source} "
    #include <Eigen/Core>
    static_assert (EIGEN_MAX_ALIGN_BYTES == ${bytes}, \"\");
    int main () {}")
  try_compile(PCL_ATTENTION_EIGEN_ALIGNS_TO_${bytes} ${PROJECT_BINARY_DIR}/CMakeFiles/eigen_alignment ${source}
    LINK_LIBRARIES Eigen3::Eigen)
  if(PCL_ATTENTION_EIGEN_ALIGNS_TO_${bytes})
    set(PCL_ATTENTION_EIGEN_ALIGNMENT ${bytes})
    break()
  endif()
endforeach()
unset(CMAKE_TRY_COMPILE_CONFIGURATION)
if(PCL_ATTENTION_EIGEN_ALIGNMENT GREATER 16)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  message(WARNING "The compiler's flags (${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}) align Eigen's types to ${PCL_ATTENTION_EIGEN_ALIGNMENT} bytes. "
    "That needs a PCL built with the same flags. Debian's is not: programs would abort with 'double free'. "
    "Without -march=native, -mavx and the like the two agree; the library chooses wide instructions itself at run time.")
endif()

configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${PROJECT_BINARY_DIR}/include/pcl_attention/version.h @ONLY)
