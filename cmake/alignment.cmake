# To how many bytes the compiler's flags make Eigen align: part of the binary interface, hence in the installed version.h,
# by which include/pcl_attention/alignment_guard.h compares it with that of the user's flags.
include(CheckCXXSourceCompiles)
find_package(Eigen3 REQUIRED NO_MODULE)

set(PCL_ATTENTION_EIGEN_ALIGNMENT 0)
foreach(bytes 16 32 64)
  set(CMAKE_REQUIRED_LIBRARIES Eigen3::Eigen)
  set(CMAKE_REQUIRED_QUIET TRUE)
  check_cxx_source_compiles("
    #include <Eigen/Core>
    static_assert (EIGEN_MAX_ALIGN_BYTES == ${bytes}, \"\");
    int main () {}" PCL_ATTENTION_EIGEN_ALIGNS_TO_${bytes})
  unset(CMAKE_REQUIRED_QUIET)
  unset(CMAKE_REQUIRED_LIBRARIES)
  if(PCL_ATTENTION_EIGEN_ALIGNS_TO_${bytes})
    set(PCL_ATTENTION_EIGEN_ALIGNMENT ${bytes})
    break()
  endif()
endforeach()
if(PCL_ATTENTION_EIGEN_ALIGNMENT GREATER 16)
  message(WARNING "The compiler's flags (${CMAKE_CXX_FLAGS}) align Eigen's types to ${PCL_ATTENTION_EIGEN_ALIGNMENT} bytes. "
    "That needs a PCL built with the same flags. Debian's is not: programs would abort with 'double free'. "
    "Without -march=native, -mavx and the like the two agree; the library chooses wide instructions itself at run time.")
endif()

configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${PROJECT_BINARY_DIR}/include/pcl_attention/version.h @ONLY)
