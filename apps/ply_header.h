// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_attention
{

/** \brief Check that a PLY file can hold the elements that its header announces. PCL's reader allocates whatever a
 * header asks for. \throws std::runtime_error with what is wrong, without the name of the file */
void checkPlyHeader (const std::string& path);

} // namespace pcl_attention
