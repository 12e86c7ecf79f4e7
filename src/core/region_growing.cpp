// SPDX-License-Identifier: BSD-3-Clause
#include "point_at.h"
#include "region_growing.h"

#include <algorithm>
#include <cstring>

namespace pcl_attention
{

namespace
{

/** \brief Pixels by the top 15 bits of their curvature. Growth reaches most pixels before their bucket is opened, and only those
  * it did not are sorted. */
class CurvatureBuckets
{
public:
  CurvatureBuckets (const std::vector<float>& curvature, const std::vector<int>& pixels)
  : curvature_ (curvature), ends_ (bucket_count + 1, 0), pixels_ (pixels.size ())
  {
    for (const int pixel : pixels)
      ++ends_[bucketOf (pixel) + 1];
    for (int bucket = 0; bucket < bucket_count; ++bucket)
      ends_[bucket + 1] += ends_[bucket];
    for (const int pixel : pixels)
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
  static constexpr int bucket_count = 1 << 15;

  int
  bucketOf (int pixel) const
  {
    const float curvature = std::max (0.0f, curvature_[pixel]);
    std::uint32_t bits;
    std::memcpy (&bits, &curvature, sizeof (bits));
    return (static_cast<int> (bits >> 16));
  }

  const std::vector<float>& curvature_;
  std::vector<int> ends_;
  std::vector<int> pixels_;
};

} // namespace

void
growOnGrid (const OrganizedCloud& cloud, const NormalImage& normals, const PatchParameters& parameters, Image<int>& labels,
            int label)
{
  // A closed row above and below the image and marks on its first and last column spare the border tests.
  constexpr std::uint8_t open = 1, first_column = 2, last_column = 4;
  const int width = cloud.width;
  std::vector<std::uint8_t> memory (cloud.size () + 2 * static_cast<std::size_t> (width), 0);
  std::uint8_t* const cells = memory.data () + width;
  std::vector<int> pixels;
  pixels.reserve (cloud.size ());
  for (int row = 0, pixel = 0; row < cloud.height; ++row)
    for (int column = 0; column < width; ++column, ++pixel)
    {
      cells[pixel] = static_cast<std::uint8_t> ((column == 0 ? first_column : 0) | (column == width - 1 ? last_column : 0));
      if (cloud.valid[pixel] && normals.valid[pixel] && labels[pixel] == 0)
      {
        cells[pixel] |= open;
        pixels.push_back (pixel);
      }
    }
  const auto normalOf = [&] (int pixel) { return (Eigen::Vector3f (normals.x[pixel], normals.y[pixel], normals.z[pixel])); };

  struct Step
  {
    int offset;
    std::uint8_t blocked_at;
  };
  const Step steps[4] = {{1, last_column}, {width, 0}, {-1, first_column}, {-width, 0}};
  CurvatureBuckets buckets (normals.curvature, pixels);
  std::vector<int>& region = pixels; // the buckets have their own
  GrowingPlane plane (parameters);
  const auto grow = [&] (int seed) {
    std::size_t size = 0;
    region[size++] = seed;
    cells[seed] &= ~open;
    plane.start (pointAt (cloud, seed), normalOf (seed));
    for (std::size_t front = 0; front < size; ++front)
    {
      const int member = region[front];
      const Eigen::Vector3f member_point = pointAt (cloud, member), member_normal = normalOf (member);
      for (const Step& step : steps)
      {
        const int next = member + step.offset;
        if (!(cells[next] & open) || (cells[member] & step.blocked_at))
          continue;
        const Eigen::Vector3f point = pointAt (cloud, next), normal = normalOf (next);
        if (!plane.takes (point, normal, member_point, member_normal))
          continue;
        plane.add (point, normal);
        cells[next] &= ~open;
        region[size++] = next;
      }
    }
    if (size < static_cast<std::size_t> (parameters.minimum_size))
      return;
    ++label;
    for (std::size_t member = 0; member < size; ++member)
      labels[region[member]] = label;
  };
  buckets.visit ([&] (int pixel) { return ((cells[pixel] & open) != 0); }, grow);
}

} // namespace pcl_attention
