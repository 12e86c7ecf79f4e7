// SPDX-License-Identifier: BSD-3-Clause
#include "nonzero.h"
#include "point_at.h"
#include "region_growing.h"

#include <pcl_attention/core/bands.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <numeric>
#include <tuple>

namespace pcl_attention
{

namespace
{

Eigen::Vector3f
normalAt (const NormalImage& normals, int pixel)
{
  return {normals.x[pixel], normals.y[pixel], normals.z[pixel]};
}

/** \brief Pixels beside each other in a row. */
struct PixelRun
{
  int begin, end;

  int
  size () const { return (end - begin); }
};

/** \brief Which pixels growth may still take. Threads that grow beside each other look at what surrounds their parts, too. */
class OpenPixels
{
public:
  /** \param[in] labels of pixels that are taken already */
  OpenPixels (const OrganizedCloud& cloud, const NormalImage& normals, const Image<int>& labels)
  : memory_ (cloud.size () + 2 * static_cast<std::size_t> (cloud.width)), cells_ (memory_.data () + cloud.width),
    steps_{{{1, last_column}, {cloud.width, 0}, {-1, first_column}, {-cloud.width, 0}}}
  {
    std::vector<std::uint8_t> is_open (cloud.width);
    for (int row = 0; row < cloud.height; ++row)
    {
      const int before = row * cloud.width;
      for (int column = 0; column < cloud.width; ++column)
        is_open[column] = cloud.valid[before + column] & normals.valid[before + column] & static_cast<int> (labels[before + column] == 0);
      forEachRun (is_open.data (), is_open.data () + is_open.size (), [&] (std::ptrdiff_t begin, std::ptrdiff_t end) {
        runs_.push_back ({before + static_cast<int> (begin), before + static_cast<int> (end)});
        for (int pixel = runs_.back ().begin; pixel < runs_.back ().end; ++pixel)
          set (pixel, open);
      });
      set (before, get (before) | first_column);
      set (before + cloud.width - 1, get (before + cloud.width - 1) | last_column);
    }
  }

  /** \brief All of them before anything is grown, row by row. */
  const std::vector<PixelRun>&
  runs () const { return (runs_); }

  bool
  contains (int pixel) const { return ((get (pixel) & open) != 0); }

  void
  close (int pixel) { set (pixel, get (pixel) & ~open); }

  /** \brief Visit the open ones of a pixel's four neighbours. */
  template <typename Visit> void
  forNeighbors (int pixel, const Visit& visit) const
  {
    for (const Step& step : steps_)
      if (contains (pixel + step.offset) && !(get (pixel) & step.blocked_at))
        visit (pixel + step.offset);
  }

private:
  struct Step
  {
    int offset, blocked_at;
  };

  int
  get (int pixel) const { return (cells_[pixel].load (std::memory_order_relaxed)); }

  void
  set (int pixel, int marks) { cells_[pixel].store (static_cast<std::uint8_t> (marks), std::memory_order_relaxed); }

  // A closed row above and below the image and marks on its first and last column spare the border tests.
  static constexpr int open = 1, first_column = 2, last_column = 4;
  std::vector<std::atomic<std::uint8_t>> memory_;
  std::atomic<std::uint8_t>* cells_;
  std::array<Step, 4> steps_;
  std::vector<PixelRun> runs_;
};

int
pixelCount (const std::vector<PixelRun>& runs)
{
  return (std::accumulate (runs.begin (), runs.end (), 0, [] (int count, const PixelRun& run) { return (count + run.size ()); }));
}

/** \brief Pixels by the top 15 bits of their curvature. Growth reaches most pixels before their bucket is opened, and only those
  * it did not are sorted. */
class CurvatureBuckets
{
public:
  CurvatureBuckets (const std::vector<float>& curvature, const std::vector<PixelRun>& runs)
  : curvature_ (curvature), ends_ (bucket_count + 1, 0), pixels_ (pixelCount (runs))
  {
    for (const PixelRun& run : runs)
      for (int pixel = run.begin; pixel < run.end; ++pixel)
        ++ends_[bucketOf (pixel) + 1];
    std::partial_sum (ends_.begin (), ends_.end (), ends_.begin ());
    for (const PixelRun& run : runs)
      for (int pixel = run.begin; pixel < run.end; ++pixel)
        pixels_[ends_[bucketOf (pixel)]++] = pixel; // afterwards a bucket's begin is its end
  }

  /** \brief Visit all pixels that are still free when their turn comes, the lowest curvature first. */
  template <typename IsFree, typename Visit> void
  visit (const IsFree& is_free, const Visit& visit_pixel)
  {
    auto begin = pixels_.begin ();
    for (int bucket = 0; bucket < bucket_count; ++bucket)
    {
      const auto end = pixels_.begin () + ends_[bucket];
      const auto last = std::remove_if (begin, end, [&] (int pixel) { return (!is_free (pixel)); });
      std::stable_sort (begin, last, [this] (int a, int b) { return (curvature_[a] < curvature_[b]); });
      for (auto pixel = begin; pixel != last; ++pixel)
        if (is_free (*pixel))
          visit_pixel (*pixel);
      begin = end;
    }
  }

private:
  // Of a millionth to a third, between which nearly all are; the first and the last bucket have the others.
  static constexpr int lowest = 0x3580, bucket_count = 0x3eab - lowest + 1;

  int
  bucketOf (int pixel) const
  {
    const float curvature = std::max (0.0f, curvature_[pixel]);
    std::uint32_t bits;
    std::memcpy (&bits, &curvature, sizeof (bits));
    return (std::clamp (static_cast<int> (bits >> 16) - lowest, 0, bucket_count - 1));
  }

  const std::vector<float>& curvature_;
  std::vector<int> ends_;
  std::vector<int> pixels_;
};

/** \brief The open pixels in parts between which the surface steps wherever they touch, so that no region reaches from one into
  * another. Row by row each; at most some, as small ones are put together. */
std::vector<std::vector<PixelRun>>
independentParts (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, const OpenPixels& open)
{
  const GrowingPlane plane (parameters);
  const auto areLinked = [&] (int a, int b) {
    return (!plane.isStep (pointAt (cloud, a), normalAt (normals, a), pointAt (cloud, b)) ||
            !plane.isStep (pointAt (cloud, b), normalAt (normals, b), pointAt (cloud, a)));
  };
  std::vector<PixelRun> runs;
  for (const PixelRun& run : open.runs ())
    for (int begin = run.begin, end; begin < run.end; begin = end)
    {
      for (end = begin + 1; end < run.end && areLinked (end - 1, end);)
        ++end;
      runs.push_back ({begin, end});
    }
  boost::disjoint_sets_with_storage<> linked (runs.size ());
  for (std::size_t run = 0, above = 0; run < runs.size (); ++run)
  {
    const int begin = runs[run].begin - cloud.width, end = runs[run].end - cloud.width;
    while (runs[above].end <= begin)
      ++above;
    for (std::size_t other = above; runs[other].begin < end; ++other)
      for (int pixel = std::max (begin, runs[other].begin), last = std::min (end, runs[other].end);
           pixel < last && linked.find_set (run) != linked.find_set (other); ++pixel)
        if (areLinked (pixel, pixel + cloud.width))
          linked.union_set (run, other);
  }

  std::vector<int> sizes (runs.size (), 0); // of the set with that number
  for (std::size_t run = 0; run < runs.size (); ++run)
    sizes[linked.find_set (run)] += runs[run].size ();
  std::vector<std::size_t> sets;
  for (std::size_t set = 0; set < runs.size (); ++set)
    if (sizes[set] > 0)
      sets.push_back (set);
  std::stable_sort (sets.begin (), sets.end (), [&sizes] (std::size_t a, std::size_t b) { return (sizes[a] > sizes[b]); });
  constexpr int enough_parts = 8;
  const int enough = pixelCount (runs) / enough_parts;
  std::vector<std::size_t> part_of (runs.size ());
  std::size_t parts = 0;
  int in_part = enough;
  for (const std::size_t set : sets)
  {
    if (in_part >= enough)
    {
      ++parts;
      in_part = 0;
    }
    part_of[set] = parts - 1;
    in_part += sizes[set];
  }
  std::vector<std::vector<PixelRun>> result (parts);
  for (std::size_t run = 0; run < runs.size (); ++run)
    result[part_of[linked.find_set (run)]].push_back (runs[run]);
  return (result);
}

struct Region
{
  float curvature; /**< at the seed */
  int seed;
  std::vector<int> pixels;
};

/** \brief Regions of a part of the image, in the order they grow in. */
std::vector<Region>
growPart (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, const std::vector<PixelRun>& part,
          OpenPixels& open)
{
  std::vector<Region> regions;
  std::vector<int> members (pixelCount (part));
  GrowingPlane plane (parameters);
  CurvatureBuckets buckets (normals.curvature, part);
  buckets.visit ([&open] (int pixel) { return (open.contains (pixel)); }, [&] (int seed) {
    std::size_t size = 0;
    members[size++] = seed;
    open.close (seed);
    plane.start (pointAt (cloud, seed), normalAt (normals, seed));
    for (std::size_t front = 0; front < size; ++front)
    {
      const int member = members[front];
      const Eigen::Vector3f member_point = pointAt (cloud, member), member_normal = normalAt (normals, member);
      open.forNeighbors (member, [&] (int next) {
        const Eigen::Vector3f point = pointAt (cloud, next), normal = normalAt (normals, next);
        if (!plane.takes (point, normal, member_point, member_normal))
          return;
        plane.add (point, normal);
        open.close (next);
        members[size++] = next;
      });
    }
    if (size >= static_cast<std::size_t> (parameters.minimum_size))
      regions.push_back ({normals.curvature[seed], seed, {members.begin (), members.begin () + static_cast<std::ptrdiff_t> (size)}});
  });
  return (regions);
}

} // namespace

void
growOnGrid (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, int threads,
            Image<int>& labels, int label)
{
  OpenPixels open (cloud, normals, labels);
  const std::vector<std::vector<PixelRun>> parts =
    threads == 1 ? std::vector<std::vector<PixelRun>>{open.runs ()} : independentParts (cloud, normals, parameters, open);
  std::vector<std::vector<Region>> grown (parts.size ());
  forEachBand (static_cast<int> (parts.size ()), 1, threads, [&] (int part, int) {
    grown[part] = growPart (cloud, normals, parameters, parts[part], open);
  });
  std::vector<const Region*> regions;
  for (const std::vector<Region>& part : grown)
    for (const Region& region : part)
      regions.push_back (&region);
  std::sort (regions.begin (), regions.end (), [] (const Region* a, const Region* b) {
    return (std::tie (a->curvature, a->seed) < std::tie (b->curvature, b->seed));
  });
  for (const Region* region : regions)
  {
    ++label;
    for (const int pixel : region->pixels)
      labels[pixel] = label;
  }
}

} // namespace pcl_attention
