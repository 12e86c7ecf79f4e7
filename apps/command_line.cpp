// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace po = boost::program_options;

namespace pcl_attention
{

CommandLine::CommandLine (std::string usage, std::string description)
: usage_ (std::move (usage)), description_ (std::move (description))
{
  program_ = usage_.substr (0, usage_.find (' '));
  addOptions () ("help,h", "print this help and exit");
}

po::options_description_easy_init
CommandLine::addOptions (const std::string& heading)
{
  if (groups_.empty () || groups_.back ().first != heading)
    groups_.emplace_back (heading, std::make_shared<po::options_description> (heading, 120, 70));
  return (groups_.back ().second->add_options ());
}

void
CommandLine::printHelp () const
{
  po::options_description flags ("", 120, 70);
  for (const auto& group : groups_)
    flags.add (*group.second);
  std::ostringstream stream;
  stream << flags;
  std::string text = stream.str ();
  // Boost writes two dashes whatever the style; with the same number of characters the columns stay as they are.
  for (std::size_t at = 0; (at = text.find ("\n  --", at)) != std::string::npos;)
    text.replace (at, 5, "\n   -");
  const std::string help = "  -h [ --help ]";
  text.replace (text.find (help), help.size (), "   -h or -help ");
  std::cout << "Usage: " << usage_ << "\n\n" << description_ << "\n" << text;
}

void
CommandLine::parse (int argc, char** argv)
{
  namespace style = po::command_line_style;
  po::options_description all;
  for (const auto& group : groups_)
    all.add (*group.second);
  all.add_options () ("positional-arguments", po::value<std::vector<std::string>> (&positional_), "");
  po::positional_options_description positional;
  positional.add ("positional-arguments", -1);
  try
  {
    po::command_line_parser parser (argc, argv);
    parser.options (all).positional (positional);
    // Without allow_guessing a prefix of a flag is an unknown flag, so that a later flag never changes a script's meaning.
    parser.style (style::allow_long | style::allow_long_disguise | style::allow_short | style::allow_dash_for_short |
                  style::long_allow_next | style::short_allow_next);
    po::store (parser.run (), values_);
    if (values_.count ("help"))
    {
      printHelp ();
      std::exit (exitCode (program_, EXIT_SUCCESS));
    }
    po::notify (values_);
  }
  catch (const po::error& error)
  {
    fail (error.what ());
  }
}

void
CommandLine::fail (const std::string& message) const
{
  std::cerr << program_ << ": " << message << " (" << program_ << " -h lists the flags)" << std::endl;
  std::exit (2);
}

void
addThreadsFlag (CommandLine& command_line)
{
  command_line.addOptions () ("threads", po::value<int> ()->default_value (0),
                              "number of threads, 0 for all processors; does not change the results");
}

unsigned int
threadsFromFlag (const CommandLine& command_line)
{
  const int threads = command_line.get<int> ("threads");
  if (threads < 0)
    command_line.fail ("-threads is " + std::to_string (threads) + ", but must be 0 or more");
  return (static_cast<unsigned int> (threads));
}

int
exitCode (const std::string& program, int code)
{
  if (std::cout.flush ())
    return (code);
  std::cerr << program << ": the standard output cannot be written, is the disk full?" << std::endl;
  return (EXIT_FAILURE);
}

} // namespace pcl_attention
