// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/matching.h"

#include <limits>

namespace pcl_attention
{

std::vector<int>
assignMaximum (const Eigen::MatrixXd& weights)
{
  const int rows = static_cast<int> (weights.rows ()), columns = static_cast<int> (weights.cols ());
  std::vector<int> column_of_row (rows, -1);
  if (rows > columns)
  {
    const std::vector<int> row_of_column = assignMaximum (weights.transpose ());
    for (int column = 0; column < columns; ++column)
      column_of_row[row_of_column[column]] = column;
    return (column_of_row);
  }

  // Minimum of cost = -weight. Potentials keep every reduced cost >= 0, with 0 on the assigned pairs; each row in turn
  // is added along the cheapest alternating path (Dijkstra) from it to a free column. Column `columns` is an auxiliary
  // start that holds the row being added.
  const double infinity = std::numeric_limits<double>::infinity ();
  const int start = columns;
  std::vector<double> row_potential (rows, 0), column_potential (columns + 1, 0);
  std::vector<int> row_of_column (columns + 1, -1);
  for (int row = 0; row < rows; ++row)
  {
    std::vector<double> distance (columns, infinity);
    std::vector<int> previous (columns, start);
    std::vector<bool> visited (columns + 1, false);
    row_of_column[start] = row;
    int column = start;
    while (row_of_column[column] != -1)
    {
      visited[column] = true;
      const int current_row = row_of_column[column];
      double step = infinity;
      int next = -1;
      for (int other = 0; other < columns; ++other)
      {
        if (visited[other])
          continue;
        const double reduced = -weights (current_row, other) - row_potential[current_row] - column_potential[other];
        if (reduced < distance[other])
        {
          distance[other] = reduced;
          previous[other] = column;
        }
        if (distance[other] < step)
        {
          step = distance[other];
          next = other;
        }
      }
      for (int other = 0; other <= columns; ++other)
      {
        if (visited[other])
        {
          row_potential[row_of_column[other]] += step;
          column_potential[other] -= step;
        }
        else
        {
          distance[other] -= step;
        }
      }
      column = next;
    }
    for (; column != start; column = previous[column])
      row_of_column[column] = row_of_column[previous[column]];
  }

  for (int column = 0; column < columns; ++column)
  {
    if (row_of_column[column] != -1)
      column_of_row[row_of_column[column]] = column;
  }
  return (column_of_row);
}

} // namespace pcl_attention
