// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace pcl_attention
{

/** \brief A folder of results that appears whole or not at all: it is filled under a temporary name beside the final
 * one, and takes the place of an older folder in one step. A process that is killed leaves the old folder or the new
 * one; its temporary is removed by the next run. */
class OutputFolder
{
public:
  /** \brief Make the temporary folder.
   * \param[in] parent an existing folder
   * \param[in] name of the final folder in it
   * \throws std::runtime_error that names the path */
  OutputFolder (const std::filesystem::path& parent, const std::string& name);

  /** \brief Removes the temporary folder, or after \ref commit the older results. */
  ~OutputFolder ();

  OutputFolder (const OutputFolder&) = delete;
  OutputFolder& operator= (const OutputFolder&) = delete;

  /** \brief Write one file.
   * \throws std::runtime_error that names the final path, e.g. when the disk is full */
  void write (const std::string& file_name, const std::string& content);

  /** \brief Put the folder in its final place. Nothing may be written after it.
   * \throws std::runtime_error; the older folder, if there was one, is still in place */
  void commit ();

  /** \brief Where the folder will be. */
  const std::filesystem::path&
  path () const
  {
    return (final_);
  }

  /** \brief Make the parent folder if need be, and remove what killed runs have left in it.
   * \throws std::runtime_error that names the path */
  static void prepareParent (const std::filesystem::path& parent);

private:
  void makeTemporary (const std::filesystem::path& parent);
  void replaceInTwoSteps ();

  std::filesystem::path final_, temporary_;
  int lock_{-1}; /**< held on the temporary folder as long as this process lives: what is not locked is stale */
};

} // namespace pcl_attention
