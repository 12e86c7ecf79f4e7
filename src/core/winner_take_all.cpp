// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_attention/core/winner_take_all.h>

#include <algorithm>
#include <cmath>

namespace pcl_attention
{

namespace
{

// A neuron is a capacitor that leaks; its membrane is at rest at 0 V.
constexpr double capacity = 1e-9;                      // farad
constexpr double leak = 1e-8;                          // siemens
constexpr double full_input = 1e-9;                    // ampere, where the map is at its maximum
constexpr double firing_voltage = 1e-3;                // volt
constexpr double inhibiting_voltage = -0.02;           // volt, which inhibition pulls to
constexpr double time_step = 1e-4;                     // second
constexpr double inhibition_gain = 0.1;                // siemens a volt of the winner
constexpr double inhibition_decay = 0.9999;            // in a time step
constexpr double surround_width = 4.0, surround_share = 1e-4; // of the centre's Gaussian: far neighbours are eased a little
constexpr int most_steps = 1000000;

struct Neuron
{
  int column, row; /**< of its cell */
  float saliency;  /**< mean of its cell */
  double input;    /**< ampere */
  double voltage{0.0};
  double inhibition{0.0}; /**< siemens */
  bool has_won{false};
};

float
salientPart (float value)
{
  return (std::isfinite (value) && value > 0.0f ? value : 0.0f);
}

std::vector<Neuron>
makeNeurons (const Image<float>& map, int cell_size, float threshold)
{
  std::vector<Neuron> neurons;
  for (int top = 0; top < map.height; top += cell_size)
    for (int left = 0; left < map.width; left += cell_size)
    {
      const int right = std::min (map.width, left + cell_size), bottom = std::min (map.height, top + cell_size);
      double sum = 0.0;
      for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column)
          sum += salientPart (map (column, row));
      if (sum > 0.0)
        neurons.push_back ({left / cell_size, top / cell_size, static_cast<float> (sum / ((right - left) * (bottom - top))), 0.0});
    }
  float maximum = 0.0f;
  for (const Neuron& neuron : neurons)
    maximum = std::max (maximum, neuron.saliency);
  neurons.erase (std::remove_if (neurons.begin (), neurons.end (),
                                 [&] (const Neuron& neuron) { return (neuron.saliency <= threshold * maximum); }),
                 neurons.end ());
  for (Neuron& neuron : neurons)
    neuron.input = full_input * neuron.saliency / maximum;
  return (neurons);
}

/** \brief A time step of all; implicitly, as inhibition is far stronger than the leak.
  * \return the one that fires, the most charged of several; null if none does */
Neuron*
charge (std::vector<Neuron>& neurons)
{
  constexpr double rate = time_step / capacity;
  Neuron* winner = nullptr;
  for (Neuron& neuron : neurons)
  {
    neuron.voltage = (neuron.voltage + rate * (neuron.input + neuron.inhibition * inhibiting_voltage)) /
                     (1.0 + rate * (leak + neuron.inhibition));
    neuron.inhibition *= inhibition_decay;
    if (neuron.voltage > firing_voltage && (!winner || neuron.voltage > winner->voltage))
      winner = &neuron;
  }
  return (winner);
}

void
inhibit (std::vector<Neuron>& neurons, const Neuron& winner, double width)
{
  const double strength = inhibition_gain * winner.voltage;
  const auto gaussian = [] (double squared_distance, double deviation) {
    return (std::exp (-squared_distance / (2.0 * deviation * deviation)));
  };
  for (Neuron& neuron : neurons)
  {
    const double across = neuron.column - winner.column, down = neuron.row - winner.row;
    const double squared_distance = across * across + down * down;
    neuron.inhibition += strength * (gaussian (squared_distance, width) -
                                     surround_share * gaussian (squared_distance, surround_width * width));
  }
  for (Neuron& neuron : neurons)
    neuron.voltage = 0.0;
}

/** \brief The centre of the salient pixels within a cell's size around a cell's middle. */
Pixel
salientCenter (const Image<float>& map, const Neuron& neuron, int cell_size)
{
  const int middle_column = neuron.column * cell_size + cell_size / 2, middle_row = neuron.row * cell_size + cell_size / 2;
  double columns = 0.0, rows = 0.0;
  int count = 0;
  for (int row = std::max (0, middle_row - cell_size); row <= std::min (map.height - 1, middle_row + cell_size); ++row)
    for (int column = std::max (0, middle_column - cell_size); column <= std::min (map.width - 1, middle_column + cell_size); ++column)
      if (salientPart (map (column, row)) > 0.0f)
      {
        columns += column;
        rows += row;
        ++count;
      }
  return {static_cast<int> (std::lround (columns / count)), static_cast<int> (std::lround (rows / count))};
}

} // namespace

std::vector<Winner>
findWinners (const Image<float>& saliency, int cell_size, float threshold, float inhibition_width)
{
  std::vector<Winner> winners;
  std::vector<Neuron> neurons = makeNeurons (saliency, cell_size, threshold);
  for (int step = 0; step < most_steps && !neurons.empty (); ++step)
  {
    Neuron* const winner = charge (neurons);
    if (!winner)
      continue;
    if (winner->has_won)
      break;
    winner->has_won = true;
    winners.push_back ({salientCenter (saliency, *winner, cell_size), winner->saliency});
    inhibit (neurons, *winner, inhibition_width);
  }
  return (winners);
}

} // namespace pcl_attention
