// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// PCL_EXPORTS is empty on Linux, so the library marks its own symbols.
#if defined _WIN32
#  ifdef PCL_ATTENTION_BUILDING_LIBRARY
#    define PCL_ATTENTION_EXPORTS __declspec(dllexport)
#  else
#    define PCL_ATTENTION_EXPORTS __declspec(dllimport)
#  endif
#else
#  define PCL_ATTENTION_EXPORTS __attribute__ ((visibility ("default")))
#endif
