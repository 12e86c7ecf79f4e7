// SPDX-License-Identifier: BSD-3-Clause
#include "files.h"
#include "whole_file.h"

using namespace pcl_attention;

namespace
{

std::string
errorOfWriting (const std::string& path)
{
  try
  {
    writeWholeFile (path, "text");
  }
  catch (const std::exception& error)
  {
    return (error.what ());
  }
  return ("");
}

TEST (WholeFile, replacesTheWholeFileOrLeavesIt)
{
  const test::TemporaryFolder folder;
  writeWholeFile (folder / "a.csv", "old");
  writeWholeFile (folder / "a.csv", "new");
  EXPECT_EQ (test::readText (folder / "a.csv"), "new");
  EXPECT_EQ (errorOfWriting (folder / "none/a.csv"),
             (folder / "none/a.csv") + ": cannot be written: No such file or directory");
  std::filesystem::create_directories (folder / "folder/full");
  EXPECT_EQ (errorOfWriting (folder / "folder"), (folder / "folder") + ": cannot be written: Is a directory");
  EXPECT_EQ (test::namesIn (folder / ""), (std::set<std::string>{"a.csv", "folder"})); // nothing temporary is left
}

} // namespace
