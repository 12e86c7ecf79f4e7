// SPDX-License-Identifier: BSD-3-Clause
#include "lanes.h"
#include "lane_kernels.h"

namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
{

namespace
{

/** \brief Some pixels of a row, 0 where not valid. */
inline void
surfaceAt (const StoredRow& stored, int column, int count, Lanes (&channels)[SurfaceRow::channels_size])
{
  const LaneMask valid = loadFlags (stored.valid + column, count) & loadFlags (stored.normal_valid + column, count);
  channels[SurfaceRow::x] = keep (valid, load (stored.x + column, count));
  channels[SurfaceRow::y] = keep (valid, load (stored.y + column, count));
  channels[SurfaceRow::z] = keep (valid, load (stored.z + column, count));
  channels[SurfaceRow::normal_x] = keep (valid, load (stored.normal_x + column, count));
  channels[SurfaceRow::normal_y] = keep (valid, load (stored.normal_y + column, count));
  channels[SurfaceRow::normal_z] = keep (valid, load (stored.normal_z + column, count));
  channels[SurfaceRow::valid] = keep (valid, broadcast (1.0f));
}

} // namespace

void
fillRow (const StoredRow& stored, int width, const SurfaceRow& row)
{
  for (int column = 0; column < width; column += lane_count)
  {
    Lanes channels[SurfaceRow::channels_size];
    surfaceAt (stored, column, width - column, channels);
    for (int channel = 0; channel < SurfaceRow::channels_size; ++channel)
      store (channels[channel], row.channels[channel] + column);
  }
}

void
fillSplitRow (const StoredRow& stored, int width, const SplitRow& row)
{
  for (int column = 0; column < width; column += 2 * lane_count)
  {
    Lanes first[SurfaceRow::channels_size], second[SurfaceRow::channels_size] = {};
    surfaceAt (stored, column, width - column, first);
    if (column + lane_count < width)
      surfaceAt (stored, column + lane_count, width - column - lane_count, second);
    for (int channel = 0; channel < SurfaceRow::channels_size; ++channel)
    {
      Lanes even, odd;
      splitLanes (first[channel], second[channel], even, odd);
      store (even, row.even.channels[channel] + column / 2);
      store (odd, row.odd.channels[channel] + column / 2);
    }
  }
}

void
halveRow (const SplitRow* const* around, int width, const HalvedRow& half)
{
  constexpr float kernel[4] = {0.125f, 0.375f, 0.375f, 0.125f};
  for (int column = 0; column < width; column += lane_count)
  {
    Lanes sums[SurfaceRow::channels_size] = {};
    for (int row = 0; row < 4; ++row)
    {
      // The fine columns 2c - 1, 2c, 2c + 1 and 2c + 2.
      const SurfaceRow* const halves[4] = {&around[row]->odd, &around[row]->even, &around[row]->odd, &around[row]->even};
      const int at[4] = {column - 1, column, column, column + 1};
      for (int step = 0; step < 4; ++step)
      {
        const float weight = kernel[step] * kernel[row];
        for (int channel = 0; channel < SurfaceRow::channels_size; ++channel)
          sums[channel] += weight * load (halves[step]->channels[channel] + at[step]);
      }
    }
    const Lanes weights = sums[SurfaceRow::valid];
    const LaneVector normal{sums[SurfaceRow::normal_x], sums[SurfaceRow::normal_y], sums[SurfaceRow::normal_z]};
    const Lanes length = squareRoot (dot (normal, normal));
    const LaneMask valid = (weights >= 0.5f) & (length >= 1e-6f);
    const Lanes divisor = select (valid, weights, broadcast (1.0f)), normal_divisor = select (valid, length, broadcast (1.0f));
    const int lanes = width - column;
    store (keep (valid, sums[SurfaceRow::x] / divisor), half.x + column, lanes);
    store (keep (valid, sums[SurfaceRow::y] / divisor), half.y + column, lanes);
    store (keep (valid, sums[SurfaceRow::z] / divisor), half.z + column, lanes);
    store (keep (valid, normal.x / normal_divisor), half.normal_x + column, lanes);
    store (keep (valid, normal.y / normal_divisor), half.normal_y + column, lanes);
    store (keep (valid, normal.z / normal_divisor), half.normal_z + column, lanes);
    storeBytes (valid & 1, half.valid + column, lanes);
    storeBytes (valid & 1, half.normal_valid + column, lanes);
  }
}

} // namespace pcl_attention::PCL_ATTENTION_INSTRUCTION_SET
