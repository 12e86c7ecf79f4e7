# SPDX-License-Identifier: BSD-3-Clause
"""Objects of an organized RGB-D cloud, one fixation at a time, the most salient first.

>>> import pcl_attention
>>> for segment in pcl_attention.segment(xyz, rgb):   # (height, width, 3), metres, NaN for holes
...     print(segment.rank, segment.confidence, segment.points.mean(axis=0))

The arrays are those of a depth camera in its own frame: x right, y down, z forward.
"""
from ._core import (AttentionPoint, Segment, Segmentation, SupportingPlane, __version__, attention_points, iterate,
                    parameters, patches, saliency, segment)

__all__ = ["AttentionPoint", "Segment", "Segmentation", "SupportingPlane", "__version__", "attention_points", "iterate",
           "parameters", "patches", "saliency", "segment"]
