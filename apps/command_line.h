// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl_attention
{

/** \brief PCL's tool style, `program file... -flag value`, on Boost.Program_options; unlike PCL's tools an unknown flag, a
  * missing value or a value that does not parse is an error. */
class CommandLine
{
public:
  /** \param[in] usage      one line after "Usage:", e.g. "pcl_attention_segment SCENE... -output_dir DIR [flags]"
    * \param[in] description what the program does, printed by -h */
  CommandLine (std::string usage, std::string description);

  /** \brief Where the program adds its flags; `-h`/`-help` is already there.
    * \param[in] heading of a group of flags in the help; those of the same heading in a row are one group */
  boost::program_options::options_description_easy_init
  addOptions (const std::string& heading = "Flags");

  /** \brief Parse; prints the help and exits with 0 for -h, prints one line to stderr and exits with 2 on a bad command line. */
  void
  parse (int argc, char** argv);

  bool
  has (const std::string& flag) const { return (values_.count (flag) > 0 && !values_[flag].defaulted ()); }

  template <typename T> const T&
  get (const std::string& flag) const { return (values_[flag].as<T> ()); }

  /** \brief Arguments without a flag, in their order. */
  const std::vector<std::string>&
  positional () const { return (positional_); }

  /** \brief One clear line on stderr, with a hint at -h, and exit code 2. */
  [[noreturn]] void
  fail (const std::string& message) const;

private:
  void
  printHelp () const;

  std::string program_, usage_, description_;
  std::vector<std::pair<std::string, std::shared_ptr<boost::program_options::options_description>>> groups_; /**< by heading */
  boost::program_options::variables_map values_;
  std::vector<std::string> positional_;
};

/** \brief Add -threads. */
void
addThreadsFlag (CommandLine& command_line);

/** \brief Number of threads, 0 for all processors. A negative one ends the program as CommandLine::fail does. */
unsigned int
threadsFromFlag (const CommandLine& command_line);

/** \brief Exit code of a program whose work ended with this one: 1, after one line on stderr, when what it printed could not be
  * written. */
int
exitCode (const std::string& program, int code);

} // namespace pcl_attention
