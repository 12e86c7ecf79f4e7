// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

// Runs a fuzz target without libFuzzer: over the files of its corpus, and if asked to over random changes of them.

extern "C" int LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size);

namespace
{

using Bytes = std::vector<std::uint8_t>;

Bytes
readFile (const std::filesystem::path& path)
{
  std::ifstream stream (path, std::ios::binary);
  return (Bytes (std::istreambuf_iterator<char> (stream), {}));
}

/** \brief Change some bytes, cut, repeat, or go on with another input. */
void
mutate (Bytes& bytes, const std::vector<Bytes>& corpus, std::mt19937_64& random)
{
  const auto below = [&] (std::size_t count) { return (static_cast<std::size_t> (random () % count)); };
  constexpr std::size_t longest = 4096;
  for (std::size_t change = 1 + below (8); change > 0; --change)
  {
    const std::size_t at = below (bytes.size () + 1);
    switch (below (5))
    {
      case 0:
        bytes.insert (bytes.begin () + static_cast<std::ptrdiff_t> (at), static_cast<std::uint8_t> (random ()));
        break;
      case 1:
        bytes.erase (bytes.begin () + static_cast<std::ptrdiff_t> (at),
                     bytes.begin () + static_cast<std::ptrdiff_t> (at + below (bytes.size () - at + 1)));
        break;
      case 2:
      {
        const Bytes& other = corpus[below (corpus.size ())];
        const std::size_t begin = below (other.size () + 1);
        bytes.resize (at);
        bytes.insert (bytes.end (), other.begin () + static_cast<std::ptrdiff_t> (begin), other.end ());
        break;
      }
      default:
        if (at < bytes.size ())
          bytes[at] = below (2) == 0 ? static_cast<std::uint8_t> (random ())
                                     : static_cast<std::uint8_t> (bytes[at] ^ (1u << below (8)));
    }
  }
  if (bytes.size () > longest)
    bytes.resize (longest);
}

} // namespace

int
main (int argc, char** argv)
{
  namespace fs = std::filesystem;
  if (argc != 2 && argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " CORPUS_FOLDER [SECONDS LAST_INPUT]\n"
              << "Runs all inputs of the folder, and random changes of them for that long. Should one of these crash, it is in "
                 "the file LAST_INPUT.\n";
    return (2);
  }
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator (argv[1]))
    files.insert (entry.path ());
  std::vector<Bytes> corpus;
  for (const fs::path& file : files)
  {
    if (argc == 2)
      std::cout << file.filename ().string () << std::endl; // the last one is that which crashes
    corpus.push_back (readFile (file));
    LLVMFuzzerTestOneInput (corpus.back ().data (), corpus.back ().size ());
  }
  if (corpus.empty ())
  {
    std::cerr << argv[1] << ": no inputs\n";
    return (1);
  }

  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now () + std::chrono::seconds (argc == 4 ? std::atoi (argv[2]) : 0);
  std::mt19937_64 random (1);
  std::size_t changed = 0;
  for (; Clock::now () < end; ++changed)
  {
    Bytes bytes = corpus[random () % corpus.size ()];
    mutate (bytes, corpus, random);
    std::ofstream (argv[3], std::ios::binary)
        .write (reinterpret_cast<const char*> (bytes.data ()), static_cast<std::streamsize> (bytes.size ()));
    LLVMFuzzerTestOneInput (bytes.data (), bytes.size ());
  }
  std::cout << corpus.size () << " inputs";
  if (argc == 4)
    std::cout << " and " << changed << " random changes of them";
  std::cout << std::endl;
  return (0);
}
