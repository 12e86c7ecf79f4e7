// SPDX-License-Identifier: BSD-3-Clause
// Small scenes by hand, and folders to write results into.
#pragma once

#include "evaluation/ground_truth.h"
#include "evaluation/labelled_scene.h"
#include "evaluation/prediction.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace pcl_attention
{
namespace test
{

/** \brief Organized cloud with these labels, row by row; -1 is a point without coordinates (label 20). */
inline pcl::PointCloud<pcl::PointXYZRGBL>
cloudOf (int width, const std::vector<int>& labels)
{
  pcl::PointCloud<pcl::PointXYZRGBL> cloud (width, static_cast<std::uint32_t> (labels.size ()) / width);
  for (std::size_t i = 0; i < labels.size (); ++i)
  {
    cloud[i].x = cloud[i].y = 0.0f;
    cloud[i].z = labels[i] < 0 ? std::numeric_limits<float>::quiet_NaN () : 1.0f;
    cloud[i].label = labels[i] < 0 ? 20u : static_cast<std::uint32_t> (labels[i]);
  }
  return (cloud);
}

inline GroundTruth
truthOf (int width, const std::vector<int>& labels, GroundTruthKind kind = GroundTruthKind::objects)
{
  return (makeGroundTruth (cloudOf (width, labels), kind));
}

inline PredictedSegment
segmentAt (int column, int row, pcl::Indices mask, double confidence = std::numeric_limits<double>::quiet_NaN ())
{
  PredictedSegment segment;
  segment.column = column;
  segment.row = row;
  segment.mask = std::move (mask);
  segment.confidence = confidence;
  return (segment);
}

/** \brief Prediction of these segments in this order of attention; the first that claims a pixel has it. */
inline ScenePrediction
predictionOf (int width, int height, std::vector<PredictedSegment> segments)
{
  ScenePrediction prediction;
  prediction.width = width;
  prediction.height = height;
  prediction.labels = labelsOfMasks (width, height, segments);
  prediction.segments = std::move (segments);
  return (prediction);
}

/** \brief A folder of its own for the test that runs, removed with the object. */
class TemporaryFolder
{
public:
  TemporaryFolder ()
  {
    std::string name = (std::filesystem::temp_directory_path () / "pcl_attention_XXXXXX").string ();
    path_ = mkdtemp (name.data ());
  }

  ~TemporaryFolder () { std::filesystem::remove_all (path_); }

  TemporaryFolder (const TemporaryFolder&) = delete;
  TemporaryFolder& operator= (const TemporaryFolder&) = delete;

  std::string
  operator/ (const std::string& name) const
  {
    return ((path_ / name).string ());
  }

private:
  std::filesystem::path path_;
};

inline void
writeText (const std::string& path, const std::string& text)
{
  std::ofstream (path, std::ios::binary) << text;
}

inline std::string
readText (const std::string& path)
{
  std::ifstream stream (path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf ();
  return (text.str ());
}

/** \brief What an expression throws, or "" if nothing. */
template <typename Function>
std::string
messageOf (Function&& function)
{
  try
  {
    function ();
  }
  catch (const std::exception& error)
  {
    return (error.what ());
  }
  return ("");
}

} // namespace test
} // namespace pcl_attention
