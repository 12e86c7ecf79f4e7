// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_attention/core/pipeline.h>

#include <functional>
#include <string>

namespace pcl_attention
{

/** \brief One row of the table that the flags, the help, the JSON and the documentation are made from. */
struct ParameterDescription
{
  std::string name;   /**< of the flag and the JSON key */
  std::string stage;  /**< "normals", "saliency", "attention_points", "image_symmetry", "patches", "patch_graph", "support",
                        "clustering", "segmentation" */
  std::string unit;   /**< "m", "pixels", "1/m", "radians", "share", "m^2", "cells" or "" */
  std::string source; /**< section or equation of the paper, or "" where it is this module's own */
  std::string help;
  double minimum{0.0}, maximum{0.0};
  bool integer{false};
  std::vector<std::string> choices; /**< for switches ("off", "on") and enumerations: the value is the index */

  std::function<double (const AttentionParameters&)> get;
  std::function<void (AttentionParameters&, double)> set; /**< does not check the range */

  /** \brief The value as text: a number, or one of the choices. */
  PCL_ATTENTION_EXPORTS std::string
  toString (const AttentionParameters& parameters) const;

  /** \brief Set from text.
    * \return empty, or what is wrong and what would be right */
  PCL_ATTENTION_EXPORTS std::string
  parse (const std::string& text, AttentionParameters& parameters) const;
};

/** \brief Every parameter of every stage. */
PCL_ATTENTION_EXPORTS const std::vector<ParameterDescription>&
parameterTable ();

/** \brief Check every parameter's range.
  * \return empty, or the first thing that is wrong and what would be right */
PCL_ATTENTION_EXPORTS std::string
validate (const AttentionParameters& parameters);

} // namespace pcl_attention
