// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <cstdlib>
#include <iostream>

namespace po = boost::program_options;

namespace pcl_attention
{

CommandLine::CommandLine (std::string usage, std::string description)
: usage_ (std::move (usage)), description_ (std::move (description)), flags_ ("Flags", 120, 70)
{
  program_ = usage_.substr (0, usage_.find (' '));
  flags_.add_options () ("help,h", "print this help and exit");
}

void
CommandLine::parse (int argc, char** argv)
{
  namespace style = po::command_line_style;
  po::options_description all;
  all.add (flags_);
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
      std::cout << "Usage: " << usage_ << "\n\n" << description_ << "\n\n" << flags_;
      std::exit (EXIT_SUCCESS);
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

} // namespace pcl_attention
