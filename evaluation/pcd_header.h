// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief What the header of a PCD file announces. */
struct PcdHeader
{
  struct Field
  {
    std::string name;
    std::uint64_t size{4}; /**< bytes of one element */
    char type{'F'};        /**< F, U or I */
    std::uint64_t count{1};
  };

  std::vector<Field> fields;
  std::uint64_t width{0}, height{0}, points{0};
  std::uint64_t point_size{0}; /**< bytes */
};

/** \brief Read the header of a PCD file and check that the file can hold what it announces. PCL's reader allocates
 * whatever a header asks for and trusts the sizes within the file, so that a damaged file would exhaust the memory or
 * crash it. \throws std::runtime_error with what is wrong, without the name of the file */
PcdHeader checkPcdHeader (const std::string& path);

} // namespace pcl_attention
