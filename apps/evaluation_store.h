// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluation/scene_result.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace pcl_attention
{

/** \brief Results of an evaluation in a folder, a whole file for each system and scene, so that a killed run goes on
 * where it was, and several runs can share the work: each adds files, none changes one. */
class EvaluationStore
{
public:
  /** \brief Make the folder if need be, or go on with what is in it.
   * \param[in] description of everything that all results depend on but for the data's content
   * \throws std::runtime_error that names the folder: not writable, or of an evaluation with another description */
  EvaluationStore (const std::filesystem::path& folder, const nlohmann::ordered_json& description);

  /** \brief Read only.
   * \throws std::runtime_error if the folder is not that of an evaluation */
  explicit EvaluationStore (const std::filesystem::path& folder);

  const nlohmann::ordered_json&
  description () const
  {
    return (description_);
  }

  /** \brief \throws std::runtime_error that names both folders and what differs */
  void checkSameAs (const nlohmann::ordered_json& description) const;

  /** \brief What was written before, if it was.
   * \throws std::runtime_error that names the damaged file */
  std::optional<SceneResult> read (const std::string& system, const std::string& scene) const;

  void write (const std::string& system, const std::string& scene, const SceneResult& result) const;

  /** \brief The PNG file of a scene, empty if there is none; of the ground truth for an empty system. */
  std::string readPicture (const std::string& system, const std::string& scene) const;

  void writePicture (const std::string& system, const std::string& scene, const std::string& png) const;

private:
  std::filesystem::path fileOf (const std::string& system, const std::string& scene, const char* extension) const;

  std::filesystem::path folder_;
  nlohmann::ordered_json description_;
};

} // namespace pcl_attention
