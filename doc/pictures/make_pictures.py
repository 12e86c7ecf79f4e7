#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the pages, of the scene that scripts/demo.sh renders:

PYTHONPATH=build/release/python doc/pictures/make_pictures.py build/demo/scene.pcd doc/pictures"""
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import pcl_attention


def lzf_decompress(data, size):
    """The compression of PCD files."""
    output, at = bytearray(), 0
    while at < len(data):
        control = data[at]
        at += 1
        if control < 32:
            output += data[at:at + control + 1]
            at += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += data[at]
            at += 1
        start = len(output) - ((control & 31) << 8) - data[at] - 1
        at += 1
        for i in range(start, start + length + 2):
            output.append(output[i])
    assert len(output) == size
    return bytes(output)


def read_scene(path):
    """xyz and rgb of a PCD file as pcl_attention_make_scene writes it: all values of a field after another."""
    content = path.read_bytes()
    header_end = content.index(b"binary_compressed\n") + len(b"binary_compressed\n")
    header = dict(line.split(" ", 1) for line in content[:header_end].decode().splitlines() if not line.startswith("#"))
    width, height = int(header["WIDTH"]), int(header["HEIGHT"])
    compressed, size = np.frombuffer(content, "<u4", 2, header_end)
    data = lzf_decompress(content[header_end + 8:header_end + 8 + int(compressed)], int(size))
    count = width * height
    names = header["FIELDS"].split()
    field = {name: np.frombuffer(data, "<u4" if name == "rgba" else "<f4", count, 4 * count * i)
             for i, name in enumerate(names)}
    xyz = np.stack([field[axis] for axis in "xyz"], axis=-1).reshape(height, width, 3)
    color = np.stack([field["rgba"] >> shift & 255 for shift in (16, 8, 0)], axis=-1)
    return xyz, color.astype(np.uint8).reshape(height, width, 3)


def save(path, image, points=(), **arguments):
    height, width = image.shape[:2]
    figure = plt.figure(figsize=(width / 160, height / 160), dpi=100, facecolor="black")
    axes = figure.add_axes([0, 0, 1, 1])
    axes.imshow(image, **arguments)
    for point in points:
        axes.plot(point.column, point.row, "o", color="white", markeredgecolor="black", markersize=5)
    axes.set_axis_off()
    axes.set_xlim(0, width - 1)
    axes.set_ylim(height - 1, 0)
    figure.savefig(path)
    plt.close(figure)


def main():
    xyz, rgb = read_scene(pathlib.Path(sys.argv[1]))
    folder = pathlib.Path(sys.argv[2])
    save(folder / "depth.png", xyz[..., 2], cmap="viridis")
    save(folder / "saliency.png", pcl_attention.saliency(xyz, rgb), pcl_attention.attention_points(xyz, rgb), cmap="magma")
    patches = pcl_attention.patches(xyz, rgb)
    colors = np.random.default_rng(1).integers(60, 256, (patches.max() + 1, 3), dtype=np.uint8)
    colors[0] = 0
    save(folder / "patches.png", colors[patches])
    objects = pcl_attention.segment(xyz, rgb)
    picture = rgb // 3
    for segment in reversed(list(objects)):
        picture[segment.mask] = np.array(plt.get_cmap("tab10")((segment.rank - 1) % 10)[:3]) * 160 + rgb[segment.mask] * 0.35
    save(folder / "segments.png", picture, [segment.attention_point for segment in objects])


if __name__ == "__main__":
    main()
