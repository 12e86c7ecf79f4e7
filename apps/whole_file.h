// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_attention
{

/** \brief Write a file beside its place and rename it, so that nobody ever finds half of it.
 * \throws std::runtime_error that names the path */
void writeWholeFile (const std::string& path, const std::string& content);

} // namespace pcl_attention
