// SPDX-License-Identifier: BSD-3-Clause
#include "nonzero.h"

#include <pcl_attention/core/skeleton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <queue>

namespace pcl_attention
{

namespace
{

/** \brief The 8 neighbours in the order of Zhang and Suen: north first, then clockwise. */
constexpr std::array<std::array<int, 2>, 8> clockwise{
  {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

/** \brief Which neighbours are foreground, the bits in the order of \ref clockwise. */
using Neighborhood = unsigned;

Neighborhood
neighborhood (const Image<std::uint8_t>& image, int column, int row)
{
  Neighborhood neighbors = 0;
  for (int i = 0; i < 8; ++i)
  {
    const int c = column + clockwise[i][0], r = row + clockwise[i][1];
    neighbors |= static_cast<Neighborhood> (image.contains (c, r) && image (c, r)) << i;
  }
  return (neighbors);
}

constexpr bool
has (Neighborhood neighbors, int i)
{
  return ((neighbors >> (i % 8) & 1) != 0);
}

constexpr int
countOf (Neighborhood neighbors)
{
  int count = 0;
  for (int i = 0; i < 8; ++i)
    count += has (neighbors, i);
  return (count);
}

constexpr int
countTransitions (Neighborhood neighbors)
{
  int transitions = 0;
  for (int i = 0; i < 8; ++i)
    transitions += !has (neighbors, i) && has (neighbors, i + 1);
  return (transitions);
}

/** \brief What the half-iterations of Zhang and Suen do with a pixel. */
enum Peeling : std::uint8_t
{
  first_half_peels = 1,
  second_half_peels = 2
};

constexpr std::uint8_t
peelingOf (Neighborhood n)
{
  const int count = countOf (n);
  if (count < 2 || count > 6 || countTransitions (n) != 1)
    return (0);
  const bool north = has (n, 0), east = has (n, 2), south = has (n, 4), west = has (n, 6);
  const bool first_keeps = (north && east && south) || (east && south && west);
  const bool second_keeps = (north && east && west) || (north && south && west);
  return (static_cast<std::uint8_t> ((first_keeps ? 0 : first_half_peels) | (second_keeps ? 0 : second_half_peels)));
}

constexpr std::array<std::uint8_t, 256>
peelingTable ()
{
  std::array<std::uint8_t, 256> table{};
  for (Neighborhood n = 0; n < table.size (); ++n)
    table[n] = peelingOf (n);
  return (table);
}

/** \brief The iterations of Zhang and Suen 1984. Only pixels are looked at that a half-iteration would peel as things are, or
  * whose neighbourhood has changed. */
class Peeler
{
public:
  /** \param[in] frame the image with a background pixel around it, foreground 1 */
  explicit Peeler (Image<std::uint8_t>& frame) : frame_ (frame)
  {
    for (int i = 0; i < 8; ++i)
      offsets_[i] = clockwise[i][1] * frame.width + clockwise[i][0];
    forEachNonZero (frame_.data.data (), frame_.data.data () + frame_.size (), [this] (std::size_t pixel) {
      if (table[neighborhoodOf (pixel)])
      {
        frame_[pixel] |= listed;
        list_.push_back (pixel);
      }
    });
  }

  /** \brief One half-iteration.
    * \return whether a pixel went */
  bool
  peel (Peeling half)
  {
    going_.clear ();
    perhaps_last_.clear ();
    std::size_t left = 0;
    for (const std::size_t pixel : list_)
    {
      const Neighborhood neighbors = frame_[pixel] ? neighborhoodOf (pixel) : 0;
      if (!table[neighbors])
        frame_[pixel] &= static_cast<std::uint8_t> (~listed);
      else if (table[neighbors] & half)
      {
        frame_[pixel] |= goes;
        going_.push_back (pixel);
        if (!(neighbors & behind))
          perhaps_last_.push_back (pixel);
      }
      else
        list_[left++] = pixel;
    }
    list_.resize (left);
    // A square of 2x2 pixels would vanish at once; its last pixel stays.
    for (const std::size_t pixel : perhaps_last_)
      if (std::all_of (offsets_.begin (), offsets_.end (), [&] (int offset) {
            return (!frame_[pixel + offset] || (frame_[pixel + offset] & goes));
          }))
        frame_[pixel] = foreground;
    bool any = false;
    for (const std::size_t pixel : going_)
    {
      if (!(frame_[pixel] & goes))
        continue;
      any = true;
      frame_[pixel] = 0;
      for (const int offset : offsets_)
        if (frame_[pixel + offset] == foreground)
        {
          frame_[pixel + offset] |= listed;
          list_.push_back (pixel + offset);
        }
    }
    return (any);
  }

private:
  static constexpr std::array<std::uint8_t, 256> table = peelingTable ();
  static constexpr std::uint8_t foreground = 1, listed = 2, goes = 4;
  static constexpr Neighborhood behind = 0x3c; // east to south-west: later in the order of rows

  Neighborhood
  neighborhoodOf (std::size_t pixel) const
  {
    Neighborhood neighbors = 0;
    for (int i = 0; i < 8; ++i)
      neighbors |= (frame_[pixel + offsets_[i]] & foreground) << i;
    return (neighbors);
  }

  Image<std::uint8_t>& frame_;
  std::array<int, 8> offsets_;
  std::vector<std::size_t> list_, going_, perhaps_last_;
};

/** \brief Whether the foreground neighbours stay 8-connected to each other without the centre. */
constexpr bool
neighborsStayConnected (Neighborhood n)
{
  // Number of 8-connected foreground runs around the pixel (Yokoi et al. 1975, 8-connectivity number).
  int number = 0;
  for (int i = 0; i < 8; i += 2)
    number += !has (n, i) && (has (n, i + 1) || has (n, i + 2));
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
    forEachRun (pixels, pixels + mask.width, [&] (std::ptrdiff_t first, std::ptrdiff_t behind) {
      const int begin = static_cast<int> (first), end = static_cast<int> (behind), run = static_cast<int> (runs.size ());
      runs.push_back ({row, begin, end, run});
      while (above < above_end && runs[above].end < begin)
        ++above;
      for (int other = above; other < above_end && runs[other].begin <= end; ++other)
      {
        const int a = rootOf (run), b = rootOf (other);
        runs[std::max (a, b)].parent = std::min (a, b);
      }
    });
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
  Image<std::uint8_t> frame (mask.width + 2, mask.height + 2, 0);
  for (int row = 0; row < mask.height; ++row)
    std::transform (&mask[row * mask.width], &mask[row * mask.width] + mask.width, &frame (1, row + 1),
                    [] (std::uint8_t value) { return (static_cast<std::uint8_t> (value != 0)); });
  Peeler peeler (frame);
  bool changed = true;
  while (changed)
  {
    const bool first = peeler.peel (first_half_peels);
    const bool second = peeler.peel (second_half_peels);
    changed = first || second;
  }
  Image<std::uint8_t> skeleton (mask.width, mask.height, 0);
  std::vector<Pixel> candidates;
  for (int row = 0; row < mask.height; ++row)
    forEachNonZero (&frame (1, row + 1), &frame (1, row + 1) + mask.width, [&] (std::ptrdiff_t column) {
      skeleton (static_cast<int> (column), row) = 1;
      candidates.push_back ({static_cast<int> (column), row});
    });
  // What is left may be two pixels wide at corners; each goes that the 8-connected line does not need. On ragged shapes one that goes
  // makes another one needless.
  do
  {
    changed = false;
    for (const Pixel& pixel : candidates)
    {
      const Neighborhood n = neighborhood (skeleton, pixel.column, pixel.row);
      if (skeleton (pixel.column, pixel.row) && countOf (n) >= 2 && neighborsStayConnected (n) &&
          has (n, 0) + has (n, 2) + has (n, 4) + has (n, 6) >= 2)
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
