// SPDX-License-Identifier: BSD-3-Clause
#include "output_folder.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

// Nothing else is called like this, so that what killed runs leave behind can be told from the user's files.
const std::string temporary_prefix = ".pcl_attention-new-";
const std::string aside_prefix = ".pcl_attention-old-";

[[noreturn]] void
fail (const fs::path& path, const std::string& message)
{
  throw std::runtime_error (path.string () + ": " + message);
}

std::string
systemError (int error)
{
  return (std::strerror (error));
}

bool
startsWith (const std::string& text, const std::string& prefix)
{
  return (text.compare (0, prefix.size (), prefix) == 0);
}

void
removeQuietly (const fs::path& path)
{
  std::error_code ignored;
  fs::remove_all (path, ignored);
}

/** \brief \return a descriptor that holds the lock on a folder; -1 and errno if there is none, EWOULDBLOCK if another
 * process holds it */
int
lockFolder (const fs::path& path)
{
  const int descriptor = open (path.c_str (), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0 && flock (descriptor, LOCK_EX | LOCK_NB) != 0)
  {
    const int error = errno;
    close (descriptor);
    errno = error;
    return (-1);
  }
  return (descriptor);
}

/** \brief Whether a descriptor is that of the folder which is at the path now. */
bool
isAt (int descriptor, const fs::path& path)
{
  struct stat opened
  {
  }, present{};
  return (fstat (descriptor, &opened) == 0 && lstat (path.c_str (), &present) == 0 && opened.st_ino == present.st_ino &&
          opened.st_dev == present.st_dev);
}

/** \brief A run that was killed between the two steps of a replacement has left the old folder aside: put it back. */
void
recoverAside (const fs::path& parent, const fs::path& aside)
{
  const fs::path original = parent / aside.filename ().string ().substr (aside_prefix.size ());
  std::error_code ignored;
  if (fs::exists (fs::symlink_status (original, ignored)))
    removeQuietly (aside);
  else
    fs::rename (aside, original, ignored);
}

} // namespace

OutputFolder::OutputFolder (const fs::path& parent, const std::string& name) : final_ (parent / name)
{
  if (name.empty () || name == "." || name == ".." || name.find ('/') != std::string::npos)
    fail (final_, "not a name for a folder");
  std::error_code error;
  const fs::file_status status = fs::symlink_status (final_, error);
  if (fs::exists (status) && !fs::is_directory (status))
    fail (final_, "a file or link is in the way of the results folder");
  makeTemporary (parent);
}

OutputFolder::~OutputFolder ()
{
  removeQuietly (temporary_);
  if (lock_ >= 0)
    close (lock_);
}

void
OutputFolder::makeTemporary (const fs::path& parent)
{
  for (int attempt = 0; attempt < 1000; ++attempt)
  {
    temporary_ = parent / (temporary_prefix + std::to_string (getpid ()) + "-" + std::to_string (attempt));
    if (mkdir (temporary_.c_str (), 0777) != 0)
    {
      if (errno == EEXIST)
        continue;
      fail (parent, "cannot be written: " + systemError (errno));
    }
    // Another run may take the folder for a stale one before it is locked. A file system without locks has no such
    // runs: they remove only what they could lock.
    lock_ = lockFolder (temporary_);
    if (lock_ < 0 && errno == EWOULDBLOCK)
      continue;
    if (lock_ < 0 || isAt (lock_, temporary_))
      return;
    close (lock_);
  }
  fail (parent, "cannot be written: too many temporary folders");
}

void
OutputFolder::write (const std::string& file_name, const std::string& content)
{
  errno = 0;
  std::ofstream stream (temporary_ / file_name, std::ios::binary);
  stream.write (content.data (), static_cast<std::streamsize> (content.size ()));
  stream.close ();
  if (!stream)
    fail (final_ / file_name, "cannot be written: " + systemError (errno == 0 ? EIO : errno));
}

void
OutputFolder::commit ()
{
  if (rename (temporary_.c_str (), final_.c_str ()) == 0) // there was none, or an empty one
  {
    temporary_.clear ();
    return;
  }
  if (errno != EEXIST && errno != ENOTEMPTY)
    fail (final_, "cannot be replaced: " + systemError (errno));
#ifdef RENAME_EXCHANGE
  // After the exchange the temporary name is that of the old folder, which the destructor removes.
  if (renameat2 (AT_FDCWD, temporary_.c_str (), AT_FDCWD, final_.c_str (), RENAME_EXCHANGE) == 0)
    return;
#endif
  replaceInTwoSteps ();
}

void
OutputFolder::replaceInTwoSteps ()
{
  const fs::path aside = final_.parent_path () / (aside_prefix + final_.filename ().string ());
  if (rename (final_.c_str (), aside.c_str ()) != 0)
    fail (final_, "cannot be replaced: " + systemError (errno));
  if (rename (temporary_.c_str (), final_.c_str ()) != 0)
  {
    const int error = errno;
    std::error_code ignored;
    fs::rename (aside, final_, ignored);
    fail (final_, "cannot be replaced: " + systemError (error));
  }
  temporary_ = aside;
}

void
OutputFolder::prepareParent (const fs::path& parent)
{
  std::error_code error;
  fs::create_directories (parent, error);
  std::error_code ignored;
  if (!fs::is_directory (parent, ignored))
    fail (parent, "cannot be made: " + (error ? error.message () : systemError (ENOTDIR)));
  if (access (parent.c_str (), W_OK | X_OK) != 0)
    fail (parent, "cannot be written: " + systemError (errno));
  for (const fs::directory_entry& entry : fs::directory_iterator (parent, error))
  {
    const std::string name = entry.path ().filename ().string ();
    if (startsWith (name, aside_prefix))
      recoverAside (parent, entry.path ());
    if (!startsWith (name, temporary_prefix))
      continue;
    const int lock = lockFolder (entry.path ());
    if (lock < 0)
      continue;
    removeQuietly (entry.path ());
    close (lock);
  }
}

} // namespace pcl_attention
