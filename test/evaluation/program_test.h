// SPDX-License-Identifier: BSD-3-Clause
// pcl_attention_evaluate, run in a folder of its own.
#pragma once

#include "cases.h"
#include "scene_renderer.h"

#include <pcl/io/pcd_io.h>

#include <sys/wait.h>

namespace pcl_attention
{
namespace test
{

struct Outcome
{
  int exit_code;
  std::string output, errors;
};

class ProgramTest : public testing::Test
{
protected:
  TemporaryFolder folder_;

  std::string
  command (const std::string& arguments) const
  {
    return (std::string ("cd '") + (folder_ / "") + "' && exec '" PCL_ATTENTION_EVALUATE "' " + arguments +
            " > output.txt 2> errors.txt");
  }

  Outcome
  run (const std::string& arguments) const
  {
    const int status = std::system (command (arguments).c_str ());
    return {WEXITSTATUS (status), readText (folder_ / "output.txt"), readText (folder_ / "errors.txt")};
  }

  void
  expectSuccess (const std::string& arguments) const
  {
    const Outcome result = run (arguments);
    ASSERT_EQ (result.exit_code, 0) << result.errors;
  }

  std::string
  content (const std::string& name) const
  {
    return (readText (folder_ / name));
  }
};

/** \brief A rendered scene of boxes and bowls. */
inline pcl::PointCloud<pcl::PointXYZRGBL>::Ptr
renderedScene (unsigned int seed, int width = 160, int height = 120)
{
  SceneDescription scene = makeScene (SceneKind::clutter, seed, 4);
  scene.camera = scene.camera.resized (width, height);
  return (renderScene (scene, seed));
}

} // namespace test
} // namespace pcl_attention
