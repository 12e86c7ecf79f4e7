// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/skeleton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <queue>

namespace pcl_attention
{

namespace
{

/** \brief The 8 neighbours in the order of Zhang and Suen: north first, then clockwise. */
constexpr std::array<std::array<int, 2>, 8> clockwise{
  {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

std::array<bool, 8>
neighborhood (const Image<std::uint8_t>& image, int column, int row)
{
  std::array<bool, 8> neighbors;
  for (int i = 0; i < 8; ++i)
  {
    const int c = column + clockwise[i][0], r = row + clockwise[i][1];
    neighbors[i] = image.contains (c, r) && image (c, r);
  }
  return (neighbors);
}

int
countTransitions (const std::array<bool, 8>& neighbors)
{
  int transitions = 0;
  for (int i = 0; i < 8; ++i)
    transitions += !neighbors[i] && neighbors[(i + 1) % 8];
  return (transitions);
}

/** \brief One half-iteration of Zhang and Suen. */
bool
peel (Image<std::uint8_t>& image, std::vector<Pixel>& candidates, bool first_half)
{
  std::vector<Pixel> removed;
  for (const Pixel& pixel : candidates)
  {
    const auto n = neighborhood (image, pixel.column, pixel.row);
    const int count = static_cast<int> (std::count (n.begin (), n.end (), true));
    if (count < 2 || count > 6 || countTransitions (n) != 1)
      continue;
    const bool north = n[0], east = n[2], south = n[4], west = n[6];
    const bool keep = first_half ? (north && east && south) || (east && south && west)
                                 : (north && east && west) || (north && south && west);
    if (!keep)
      removed.push_back (pixel);
  }
  bool any = false;
  for (const Pixel& pixel : removed)
  {
    // A square of 2x2 pixels would vanish at once; its last pixel stays.
    const auto n = neighborhood (image, pixel.column, pixel.row);
    if (std::none_of (n.begin (), n.end (), [] (bool neighbor) { return (neighbor); }))
      continue;
    image (pixel.column, pixel.row) = 0;
    any = true;
  }
  candidates.erase (std::remove_if (candidates.begin (), candidates.end (),
                                    [&] (const Pixel& pixel) { return (!image (pixel.column, pixel.row)); }),
                    candidates.end ());
  return (any);
}

/** \brief Whether the foreground neighbours stay 8-connected to each other without the centre. */
bool
neighborsStayConnected (const std::array<bool, 8>& n)
{
  // Number of 8-connected foreground runs around the pixel (Yokoi et al. 1975, 8-connectivity number).
  int number = 0;
  for (int i = 0; i < 8; i += 2)
    number += !n[i] && (n[(i + 1) % 8] || n[(i + 2) % 8]);
  return (number == 1);
}

/** \brief Pixels of a path between the two pixels that lie farthest apart along a connected line. */
std::vector<Pixel>
longestPath (const std::vector<Pixel>& pixels)
{
  // Only as large as the line: there may be hundreds in an image.
  Pixel first = pixels.front (), beyond = first;
  for (const Pixel& pixel : pixels)
  {
    first = {std::min (first.column, pixel.column), std::min (first.row, pixel.row)};
    beyond = {std::max (beyond.column, pixel.column + 1), std::max (beyond.row, pixel.row + 1)};
  }
  constexpr int free = -1, no_line = -2;
  Image<int> steps (beyond.column - first.column, beyond.row - first.row, no_line);
  const auto stepsAt = [&] (const Pixel& pixel) -> int& { return (steps (pixel.column - first.column, pixel.row - first.row)); };
  const auto forNeighbors = [&] (const Pixel& pixel, const auto& visit) {
    for (const auto& offset : clockwise)
    {
      const Pixel next{pixel.column + offset[0], pixel.row + offset[1]};
      if (steps.contains (next.column - first.column, next.row - first.row))
        visit (next, stepsAt (next));
    }
  };
  const auto search = [&] (const Pixel& start) {
    for (const Pixel& pixel : pixels)
      stepsAt (pixel) = free;
    std::queue<Pixel> queue;
    queue.push (start);
    stepsAt (start) = 0;
    Pixel last = start;
    while (!queue.empty ())
    {
      last = queue.front ();
      queue.pop ();
      forNeighbors (last, [&] (const Pixel& next, int& next_steps) {
        if (next_steps != free)
          return;
        next_steps = stepsAt (last) + 1;
        queue.push (next);
      });
    }
    return (last);
  };
  std::vector<Pixel> path{search (search (pixels.front ()))};
  for (int left = stepsAt (path.back ()); left > 0; --left)
  {
    std::optional<Pixel> before;
    forNeighbors (path.back (), [&] (const Pixel& next, int next_steps) {
      if (!before && next_steps == left - 1)
        before = next;
    });
    path.push_back (*before);
  }
  return (path);
}

} // namespace

int
labelConnectedComponents (const Image<std::uint8_t>& mask, Image<int>& labels)
{
  // Runs of a row that touch a run of the row before, over corners too, hang together; the first run of each component is its
  // root.
  struct Run
  {
    int row, begin, end;
    int parent;
  };
  std::vector<Run> runs;
  const auto rootOf = [&runs] (int run) {
    while (runs[run].parent != run)
      run = runs[run].parent = runs[runs[run].parent].parent;
    return (run);
  };
  int above = 0, above_end = 0; // runs of the row before
  for (int row = 0; row < mask.height; ++row)
  {
    const std::uint8_t* const pixels = &mask (0, row);
    const int row_begin = static_cast<int> (runs.size ());
    for (int column = 0; column < mask.width;)
    {
      const auto* const next = static_cast<const std::uint8_t*> (std::memchr (pixels + column, 0, mask.width - column));
      const int end = next ? static_cast<int> (next - pixels) : mask.width;
      if (end == column)
      {
        while (column < mask.width && !pixels[column])
          ++column;
        continue;
      }
      const int run = static_cast<int> (runs.size ());
      runs.push_back ({row, column, end, run});
      while (above < above_end && runs[above].end < column)
        ++above;
      for (int other = above; other < above_end && runs[other].begin <= end; ++other)
      {
        const int a = rootOf (run), b = rootOf (other);
        runs[std::max (a, b)].parent = std::min (a, b);
      }
      column = end;
    }
    above = row_begin;
    above_end = static_cast<int> (runs.size ());
  }
  labels.assign (mask.width, mask.height, 0);
  int count = 0;
  std::vector<int> names (runs.size ());
  for (int run = 0; run < static_cast<int> (runs.size ()); ++run)
  {
    const int root = rootOf (run);
    names[run] = root == run ? ++count : names[root];
    std::fill (&labels (0, runs[run].row) + runs[run].begin, &labels (0, runs[run].row) + runs[run].end, names[run]);
  }
  return (count);
}

Image<std::uint8_t>
thin (const Image<std::uint8_t>& mask)
{
  Image<std::uint8_t> skeleton (mask.width, mask.height, 0);
  std::vector<Pixel> candidates;
  for (int row = 0; row < mask.height; ++row)
    for (int column = 0; column < mask.width; ++column)
      if (mask (column, row))
      {
        skeleton (column, row) = 1;
        candidates.push_back ({column, row});
      }
  bool changed = true;
  while (changed)
  {
    const bool first = peel (skeleton, candidates, true);
    const bool second = peel (skeleton, candidates, false);
    changed = first || second;
  }
  // What is left may be two pixels wide at corners; each goes that the 8-connected line does not need. On ragged shapes one that goes
  // makes another one needless.
  do
  {
    changed = false;
    for (const Pixel& pixel : candidates)
    {
      const auto n = neighborhood (skeleton, pixel.column, pixel.row);
      const int count = static_cast<int> (std::count (n.begin (), n.end (), true));
      if (skeleton (pixel.column, pixel.row) && count >= 2 && neighborsStayConnected (n) &&
          (n[0] + n[2] + n[4] + n[6]) >= 2)
      {
        skeleton (pixel.column, pixel.row) = 0;
        changed = true;
      }
    }
  } while (changed);
  return (skeleton);
}

int
crossingNumber (const Image<std::uint8_t>& skeleton, int column, int row)
{
  return (countTransitions (neighborhood (skeleton, column, row)));
}

std::vector<Pixel>
findJunctions (const Image<std::uint8_t>& skeleton, const std::vector<Pixel>& pixels, float merge_radius)
{
  std::vector<Pixel> junctions;
  for (const Pixel& pixel : pixels)
    if (crossingNumber (skeleton, pixel.column, pixel.row) >= 3)
      junctions.push_back (pixel);

  const auto squaredDistance = [] (const Pixel& a, const Pixel& b) {
    return (static_cast<float> ((a.column - b.column) * (a.column - b.column) + (a.row - b.row) * (a.row - b.row)));
  };
  std::vector<Pixel> merged;
  std::vector<bool> used (junctions.size (), false);
  for (std::size_t first = 0; first < junctions.size (); ++first)
  {
    if (used[first])
      continue;
    std::vector<Pixel> group{junctions[first]};
    used[first] = true;
    for (std::size_t member = 0; member < group.size (); ++member)
      for (std::size_t other = first + 1; other < junctions.size (); ++other)
        if (!used[other] && squaredDistance (group[member], junctions[other]) <= merge_radius * merge_radius)
        {
          used[other] = true;
          group.push_back (junctions[other]);
        }
    float mean_column = 0.0f, mean_row = 0.0f;
    for (const Pixel& pixel : group)
    {
      mean_column += static_cast<float> (pixel.column) / group.size ();
      mean_row += static_cast<float> (pixel.row) / group.size ();
    }
    const auto toMean = [&] (const Pixel& pixel) {
      return (std::hypot (pixel.column - mean_column, pixel.row - mean_row));
    };
    merged.push_back (*std::min_element (group.begin (), group.end (), [&] (const Pixel& a, const Pixel& b) {
      return (toMean (a) < toMean (b));
    }));
  }
  return (merged);
}

Pixel
findMidpoint (const Image<std::uint8_t>& skeleton, const std::vector<Pixel>& pixels)
{
  const bool has_end = std::any_of (pixels.begin (), pixels.end (), [&] (const Pixel& pixel) {
    return (crossingNumber (skeleton, pixel.column, pixel.row) <= 1);
  });
  if (!has_end)
    return (*std::min_element (pixels.begin (), pixels.end (), [] (const Pixel& a, const Pixel& b) {
      return (a.row != b.row ? a.row < b.row : a.column < b.column);
    }));
  const std::vector<Pixel> path = longestPath (pixels);
  return (path[path.size () / 2]);
}

} // namespace pcl_attention
