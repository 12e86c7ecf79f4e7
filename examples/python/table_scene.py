# SPDX-License-Identifier: BSD-3-Clause
"""A rendered depth image, for the examples and tests: boxes and a ball on a table, as a noisy depth camera sees them."""
import numpy as np


def render(width=320, height=240, seed=0):
    """Returns xyz (height, width, 3) in metres, rgb (height, width, 3) and the intrinsics (fx, fy, cx, cy)."""
    noise = np.random.default_rng(seed)
    focal, cx, cy = 900.0 * width / 640, 0.5 * (width - 1), 0.5 * (height - 1)
    column, row = np.meshgrid(np.arange(width), np.arange(height))
    ray = np.stack([(column - cx) / focal, (row - cy) / focal, np.ones((height, width))], axis=-1)

    # The table's frame: right, towards the camera, up.
    right, up = np.array([1.0, 0.0, 0.0]), np.array([0.0, -0.8, -0.6])
    axes = np.stack([right, np.cross(right, up), up])
    middle = np.array([0.0, 0.0, 1.0])
    origin, direction = axes @ -middle, ray @ axes.T

    depth = -origin[2] / direction[..., 2]  # the table
    depth[(depth < 0) | (depth > 3)] = np.nan
    color = np.full((height, width, 3), (150, 130, 110))
    for low, high, paint in (((-0.22, -0.05, 0.0), (-0.10, 0.05, 0.14), (200, 60, 50)),
                             ((0.10, -0.02, 0.0), (0.26, 0.10, 0.08), (60, 90, 200))):
        with np.errstate(divide="ignore"):
            to_low, to_high = (low - origin) / direction, (high - origin) / direction
        enter = np.minimum(to_low, to_high).max(axis=-1)
        hit = (enter < np.maximum(to_low, to_high).min(axis=-1)) & (enter > 0) & ~(enter > depth)
        depth[hit], color[hit] = enter[hit], paint
    center, radius = np.array([0.0, 0.12, 0.06]), 0.06
    along = (direction * (center - origin)).sum(-1) / (direction ** 2).sum(-1)
    inside = radius ** 2 - ((along[..., None] * direction + origin - center) ** 2).sum(-1)
    enter = along - np.sqrt(np.maximum(inside, 0) / (direction ** 2).sum(-1))
    hit = (inside > 0) & (enter < depth)
    depth[hit], color[hit] = enter[hit], (70, 180, 80)

    depth += noise.normal(0.0, 0.0012, depth.shape) * depth ** 2
    depth = np.round(depth * 1000) / 1000
    return (ray * depth[..., None]).astype(np.float32), color.astype(np.uint8), (focal, focal, cx, cy)
