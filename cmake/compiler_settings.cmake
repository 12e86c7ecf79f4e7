# One interface target carries what every target of this project is compiled with, and nothing of it reaches users.
add_library(pcl_attention_compiler_settings INTERFACE)
target_compile_features(pcl_attention_compiler_settings INTERFACE cxx_std_17)
# Without contraction the results are the same on every CPU, with and without fused multiply-add.
target_compile_options(pcl_attention_compiler_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
  $<$<BOOL:${PCL_ATTENTION_WARNINGS_AS_ERRORS}>:-Werror>)
# PCL's macros of point types have anonymous structures, GoogleTest's of typed tests no last argument.
target_compile_options(pcl_attention_compiler_settings INTERFACE
  $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-anonymous-struct -Wno-nested-anon-types -Wno-gnu-zero-variadic-macro-arguments>)

if(PCL_ATTENTION_SANITIZE)
  target_compile_options(pcl_attention_compiler_settings INTERFACE
    -fsanitize=${PCL_ATTENTION_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(pcl_attention_compiler_settings INTERFACE -fsanitize=${PCL_ATTENTION_SANITIZE})
  # With instrumentation GCC takes std::regex and std::function for uninitialized.
  target_compile_options(pcl_attention_compiler_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # Under a sanitizer Eigen would align by itself, and free what PCL, built without, has allocated, and the other way round.
  target_compile_definitions(pcl_attention_compiler_settings INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(PCL_ATTENTION_FUZZ)
  target_compile_options(pcl_attention_compiler_settings INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(PCL_ATTENTION_COVERAGE)
  target_compile_options(pcl_attention_compiler_settings INTERFACE --coverage -O1)
  target_link_options(pcl_attention_compiler_settings INTERFACE --coverage)
endif()
