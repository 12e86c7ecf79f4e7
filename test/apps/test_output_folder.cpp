// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"
#include "output_folder.h"
#include "whole_file.h"

#include <csignal>
#include <fcntl.h>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

using namespace pcl_attention;
using Names = std::set<std::string>;

namespace
{

std::string
errorOf (const std::function<void ()>& action)
{
  try
  {
    action ();
  }
  catch (const std::exception& error)
  {
    return (error.what ());
  }
  return ("");
}

TEST (OutputFolder, appearsOnlyWhenItIsCommitted)
{
  const test::TemporaryFolder folder;
  OutputFolder::prepareParent (folder / "a/b");
  {
    OutputFolder output (folder / "a/b", "scene");
    output.write ("file", "content");
    EXPECT_FALSE (std::filesystem::exists (folder / "a/b/scene"));
    output.commit ();
    EXPECT_EQ (test::readText (folder / "a/b/scene/file"), "content");
  }
  EXPECT_EQ (test::namesIn (folder / "a/b"), Names{"scene"});
}

TEST (OutputFolder, replacesTheOlderOneAsAWhole)
{
  const test::TemporaryFolder folder;
  test::writeText (folder / "scene/old/deep", "old");
  test::writeText (folder / "scene/file", "old");
  {
    OutputFolder output (folder / "", "scene");
    output.write ("file", "new");
    EXPECT_EQ (test::readText (folder / "scene/file"), "old");
    output.commit ();
  }
  EXPECT_EQ (test::namesIn (folder / ""), Names{"scene"});
  EXPECT_EQ (test::namesIn (folder / "scene"), Names{"file"});
  EXPECT_EQ (test::readText (folder / "scene/file"), "new");
}

TEST (OutputFolder, leavesTheOlderOneAndNothingElseWhenItIsNotCommitted)
{
  const test::TemporaryFolder folder;
  test::writeText (folder / "scene/file", "old");
  {
    OutputFolder output (folder / "", "scene");
    output.write ("file", "new");
    EXPECT_NE (errorOf ([&] { output.write ("no/such/folder", ""); }), "");
  }
  EXPECT_EQ (test::namesIn (folder / ""), Names{"scene"});
  EXPECT_EQ (test::readText (folder / "scene/file"), "old");
}

TEST (OutputFolder, hasTheModeOfAnyOtherFolder)
{
  const test::TemporaryFolder folder;
  OutputFolder output (folder / "", "scene");
  output.commit ();
  std::filesystem::create_directory (folder / "other");
  EXPECT_EQ (std::filesystem::status (folder / "scene").permissions (),
             std::filesystem::status (folder / "other").permissions ());
}

TEST (OutputFolder, refusesWhatIsNoFolder)
{
  const test::TemporaryFolder folder;
  test::writeText (folder / "file", "text");
  std::filesystem::create_directory_symlink ("/tmp", folder / "link");
  EXPECT_EQ (errorOf ([&] { OutputFolder (folder / "", "file"); }),
             folder / "file: a file or link is in the way of the results folder");
  EXPECT_NE (errorOf ([&] { OutputFolder (folder / "", "link"); }), "");
  for (const std::string name : {"", ".", "..", "a/b"})
    EXPECT_NE (errorOf ([&] { OutputFolder (folder / "", name); }), "") << name;
  EXPECT_EQ (errorOf ([&] { OutputFolder::prepareParent (folder / "file"); }).find (folder / "file: cannot be"), 0u);
  EXPECT_EQ (
      errorOf ([&] { OutputFolder::prepareParent (folder / "file/below"); }).find (folder / "file/below: cannot be"),
      0u);
  EXPECT_NE (errorOf ([&] { OutputFolder::prepareParent ("/proc/nothing"); }), "");
  EXPECT_EQ (test::readText (folder / "file"), "text");
}

TEST (OutputFolder, removesWhatKilledRunsHaveLeft)
{
  const test::TemporaryFolder folder;
  test::writeText (folder / ".pcl_attention-new-1-0/file", "half");
  test::writeText (folder / ".pcl_attention-old-restored/file", "old");
  test::writeText (folder / ".pcl_attention-old-replaced/file", "old");
  test::writeText (folder / "replaced/file", "new");
  test::writeText (folder / ".hidden", "the user's");
  OutputFolder running (folder / "", "scene");
  OutputFolder::prepareParent (folder / "");
  running.write ("file", "still there");
  running.commit ();
  EXPECT_EQ (test::namesIn (folder / ""), (Names{".hidden", "replaced", "restored", "scene"}));
  EXPECT_EQ (test::readText (folder / "restored/file"), "old");
  EXPECT_EQ (test::readText (folder / "replaced/file"), "new");
}

TEST (OutputFolder, isOldOrNewWhenTheProcessIsKilled)
{
  const test::TemporaryFolder folder;
  const auto writeGeneration = [&] (int generation) {
    OutputFolder output (folder / "", "scene");
    for (const char* name : {"first", "second", "third"})
      output.write (name, std::to_string (generation));
    output.commit ();
  };
  writeGeneration (0);
  for (int trial = 0; trial < 40; ++trial)
  {
    const pid_t child = fork ();
    ASSERT_GE (child, 0);
    if (child == 0)
    {
      for (int generation = 1;; ++generation)
        writeGeneration (generation);
    }
    usleep (1000 + 137 * trial);
    kill (child, SIGKILL);
    waitpid (child, nullptr, 0);
    ASSERT_EQ (test::namesIn (folder / "scene"), (Names{"first", "second", "third"}));
    const std::string generation = test::readText (folder / "scene/first");
    EXPECT_EQ (test::readText (folder / "scene/second"), generation);
    EXPECT_EQ (test::readText (folder / "scene/third"), generation);
    OutputFolder::prepareParent (folder / "");
    EXPECT_EQ (test::namesIn (folder / ""), Names{"scene"});
  }
}

TEST (WholeFile, isReplacedAsAWholeOrLeft)
{
  const test::TemporaryFolder folder;
  writeWholeFile (folder / "a.csv", "old");
  writeWholeFile (folder / "a.csv", "new");
  EXPECT_EQ (test::readText (folder / "a.csv"), "new");
  EXPECT_EQ (errorOf ([&] { writeWholeFile (folder / "none/a.csv", ""); }),
             (folder / "none/a.csv") + ": cannot be written: No such file or directory");
  std::filesystem::create_directories (folder / "folder/full");
  EXPECT_EQ (errorOf ([&] { writeWholeFile (folder / "folder", ""); }).find ((folder / "folder") + ": cannot be written"),
             0u);
  EXPECT_EQ (test::namesIn (folder / ""), (Names{"a.csv", "folder"})) << "nothing temporary is left";
  EXPECT_EQ (errorOf ([&] { writeWholeFile ("/dev/full", "text"); }), "/dev/full: cannot be written: No space left on device");
}

} // namespace
