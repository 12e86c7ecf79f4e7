#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the objects of a depth image with matplotlib: outlines, ranks and the saliency they come from.

draw_objects.py [DEPTH.png COLOR.png FX,FY,CX,CY [METRES_A_UNIT]] [-o PICTURE.png]"""
import argparse

import matplotlib.pyplot as plt
import numpy as np

import pcl_attention
import table_scene


def read_scene(depth_file, color_file, intrinsics, scale):
    """xyz and rgb of a 16-bit depth image and its colour image."""
    fx, fy, cx, cy = (float(value) for value in intrinsics.split(","))
    depth = plt.imread(depth_file).astype(np.float64) * 65535 * scale  # matplotlib divides by 65535
    depth[depth == 0] = np.nan
    rows, columns = np.indices(depth.shape)
    xyz = np.stack([(columns - cx) / fx * depth, (rows - cy) / fy * depth, depth], axis=-1)
    return xyz.astype(np.float32), np.round(plt.imread(color_file)[..., :3] * 255).astype(np.uint8)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene", nargs="*", help="depth image, colour image, intrinsics, and metres a unit (0.001)")
    parser.add_argument("-o", dest="picture", default="objects.png", help="the picture to write")
    arguments = parser.parse_args()
    if arguments.scene and len(arguments.scene) not in (3, 4):
        parser.error("give a depth image, its colour image and the intrinsics, or nothing")

    if arguments.scene:
        xyz, rgb = read_scene(*arguments.scene[:3], scale=float((arguments.scene + ["0.001"])[3]))
    else:
        xyz, rgb, _ = table_scene.render()

    objects = pcl_attention.segment(xyz, rgb)
    saliency = pcl_attention.saliency(xyz, rgb)

    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 5), layout="constrained")
    left.imshow(rgb)
    for segment in objects:
        color = f"C{(segment.rank - 1) % 10}"
        left.contour(segment.mask, levels=[0.5], colors=[color])
        point = segment.attention_point
        left.annotate(str(segment.rank), (point.column, point.row), color="white", ha="center", va="center",
                      bbox={"boxstyle": "circle", "color": color})
    left.set_title(f"{len(objects)} objects in {objects.milliseconds['total']:.0f} ms")
    right.imshow(saliency, cmap="magma")
    right.set_title("saliency")
    for axes in (left, right):
        axes.set_axis_off()
    figure.savefig(arguments.picture)
    print(f"wrote {arguments.picture}")


if __name__ == "__main__":
    main()
