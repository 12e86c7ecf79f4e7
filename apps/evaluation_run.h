// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data_set.h"
#include "evaluated_systems.h"
#include "evaluation/evaluation.h"
#include "evaluation_store.h"

#include <optional>
#include <string>
#include <vector>

namespace pcl_attention
{

/** \brief How the work is done; nothing of it but for the data changes the results. */
struct EvaluationWork
{
  DataSetOptions data;              /**< how scenes are read */
  unsigned int jobs{1};             /**< scenes at once */
  unsigned int threads{0};          /**< of one scene, 0: all processors, shared among the jobs */
  unsigned int shard{1}, shards{1}; /**< of the scenes, every \a shards th from number \a shard on */
  bool pictures{true};              /**< draw what is found, into the store */
};

/** \brief Everything that the results depend on but for the data's content. */
nlohmann::ordered_json describeEvaluation (const std::vector<SceneSource>& sources, const DataSetOptions& data,
                                           const std::vector<EvaluatedSystem>& systems,
                                           const std::vector<GroundTruthKind>& kinds);

/** \brief Score every system on every scene of the shard that the store does not have yet, with progress on stderr.
 * \param[in] store where results are kept as soon as they are there; may be null
 * \return by system and scene; empty for scenes of other shards that are not in the store
 * \throws std::runtime_error that names the scene which fails, or whose data has changed since it was evaluated */
std::vector<std::vector<std::optional<SceneResult>>>
evaluateScenes (const std::vector<SceneSource>& sources, const std::vector<EvaluatedSystem>& systems,
                const std::vector<GroundTruthKind>& kinds, const EvaluationWork& work, const EvaluationStore* store);

} // namespace pcl_attention
