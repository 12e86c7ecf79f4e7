# SPDX-License-Identifier: BSD-3-Clause
"""All figures of pcl_attention_evaluate, computed once more with numpy from the files of results and labelled scenes.

Usage: test_figures.py pcl_attention_make_scene pcl_attention_segment pcl_attention_evaluate
Nothing is shared with the C++ code: the files are read, and every figure is defined, here.
"""
import csv
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

try:
    import matplotlib.image
    import numpy as np
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

NAN = float("nan")
INVALID, UNLABELLED, SUPPORT = -3, -2, -1


def lzf_decompress(data, size):
    out = bytearray()
    i = 0
    while i < len(data):
        control = data[i]
        i += 1
        if control < 32:
            out += data[i:i + control + 1]
            i += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += data[i]
            i += 1
        start = len(out) - ((control & 31) << 8) - data[i] - 1
        i += 1
        for k in range(start, start + length + 2):
            out.append(out[k])
    assert len(out) == size
    return bytes(out)


def read_pcd(path):
    """The fields of a compressed binary PCD file as images."""
    data = path.read_bytes()
    header, _, body = data.partition(b"DATA binary_compressed\n")
    values = {line.split()[0]: line.split()[1:] for line in header.decode().splitlines() if line[:1] not in ("#", "")}
    width, height = int(values["WIDTH"][0]), int(values["HEIGHT"][0])
    compressed, size = struct.unpack("<II", body[:8])
    raw = lzf_decompress(body[8:8 + compressed], size)
    fields, offset = {}, 0
    for name, bytes_each, kind in zip(values["FIELDS"], values["SIZE"], values["TYPE"]):
        dtype = {"F": "<f", "U": "<u", "I": "<i"}[kind] + bytes_each
        end = offset + width * height * int(bytes_each)
        fields[name] = np.frombuffer(raw[offset:end], dtype).reshape(height, width)
        offset = end
    return fields


def overlap(mask, region):
    """Precision, recall and F of two sets of pixels."""
    common = np.count_nonzero(mask & region)
    if common == 0:
        return 0.0, 0.0, 0.0
    precision, recall = common / np.count_nonzero(mask), common / np.count_nonzero(region)
    return precision, recall, 2 * precision * recall / (precision + recall)


def best_assignment(weights):
    """Pairs of rows and columns with the largest sum: tries every set of columns."""
    rows, columns = weights.shape
    best = {0: (0.0, ())}
    for row in range(rows):
        following = dict(best)
        for used, (total, pairs) in best.items():
            for column in range(columns):
                key = used | 1 << column
                value = total + weights[row, column]
                if not used >> column & 1 and value > following.get(key, (-1.0,))[0]:
                    following[key] = value, pairs + ((row, column),)
        best = following
    return max(best.values())[1]


def label_image_overlap(labels, valid, regions):
    names = [name for name in np.unique(labels[valid]) if name != 0]
    if not names or not regions:
        return (0.0 if names else 1.0), (0.0 if regions else 1.0), float(bool(names) == bool(regions))
    segments = [valid & (labels == name) for name in names]
    weights = np.array([[overlap(s, r)[2] for r in regions] for s in segments])
    common = sum(np.count_nonzero(segments[i] & regions[j]) for i, j in best_assignment(weights))
    if common == 0:
        return 0.0, 0.0, 0.0
    precision = common / sum(np.count_nonzero(s) for s in segments)
    recall = common / sum(np.count_nonzero(r) for r in regions)
    return precision, recall, 2 * precision * recall / (precision + recall)


def centre(region):
    rows, columns = np.nonzero(region)
    distance = (rows - rows.mean())**2 + (columns - columns.mean())**2
    nearest = np.argmin(distance)  # the first in row-major order
    return rows[nearest], columns[nearest]


def read_results(folder):
    with open(folder / "attention_points.csv") as file:
        points = [(int(row["row"]), int(row["column"])) for row in csv.DictReader(file)]
    masks = [matplotlib.image.imread(folder / f"mask_{rank:04d}.png") > 0.5 for rank in range(1, len(points) + 1)]
    confidence = {s["rank"]: s["confidence"] for s in json.loads((folder / "segments.json").read_text())["segments"]}
    return points, masks, [confidence[rank] for rank in range(1, len(points) + 1)], read_pcd(folder / "labels.pcd")["label"]


def evaluate_scene(scene_file, folder, kind):
    cloud = read_pcd(scene_file)
    valid = np.isfinite(cloud["x"]) & np.isfinite(cloud["y"]) & np.isfinite(cloud["z"])
    label = cloud["label"]
    name_of = label // 10 if kind == "objects" else label
    on_object = valid & (label >= 20)
    names = np.unique(name_of[on_object])
    regions = [on_object & (name_of == name) for name in names]
    points, masks, confidences, labels = read_results(folder)
    masks = [mask & valid for mask in masks]
    f = np.array([[overlap(m, r)[2] for r in regions] for m in masks]).reshape(len(masks), len(regions))

    hit = []  # the region of every point, or what surface it lies on
    for row, column in points:
        inside = [j for j, region in enumerate(regions) if region[row, column]]
        other = INVALID if not valid[row, column] else UNLABELLED if label[row, column] == 0 else SUPPORT
        hit.append(inside[0] if inside else other)
    objects = []
    for j, (name, region) in enumerate(zip(names, regions)):
        ranks = [i for i, h in enumerate(hit) if h == j]
        row, column = centre(region)
        at_centre = labels[row, column]
        first = overlap(masks[ranks[0]], region) if ranks else (0.0, 0.0, 0.0)
        objects.append({
            "scene": scene_file.stem, "category": scene_file.parent.name, "ground_truth": kind, "object": name,
            "pixels": np.count_nonzero(region), "center_column": column, "center_row": row,
            "attended": int(bool(ranks)), "points": len(ranks), "first_rank": ranks[0] + 1 if ranks else NAN,
            "first_precision": first[0], "first_recall": first[1], "first_f": first[2],
            "best_f": max((f[i, j] for i in ranks), default=0.0),
            "all_f": np.mean([f[i, j] for i in ranks]) if ranks else 0.0,
            "best_of_scene_f": f[:, j].max() if len(masks) else 0.0,
            "center_f": overlap(valid & (labels == at_centre), region)[2] if at_centre else 0.0})
    return {"category": scene_file.parent.name, "objects": objects, "hit": hit, "confidence": confidences,
            "f": [f[i, h] if h >= 0 else 0.0 for i, h in enumerate(hit)],
            "overlap": label_image_overlap(labels, valid, regions)}


def ranks_of(values):
    """From 1 on; equal values share their mean."""
    values = np.asarray(values)
    return np.array([np.count_nonzero(values < v) + (np.count_nonzero(values == v) + 1) / 2 for v in values])


def share(part, whole):
    return part / whole if whole else NAN


def summarize(group, kind, scenes):
    objects = [o for s in scenes for o in s["objects"]]
    attended = [o for o in objects if o["attended"]]
    hits = [h for s in scenes for h in s["hit"]]
    row = {"ground_truth": kind, "group": group, "scenes": len(scenes), "objects": len(objects),
           "attended": len(attended), "points": len(hits)}
    for name, chosen, column in [("attended_first", attended, "first_f"), ("attended_best", attended, "best_f"),
                                 ("attended_all", attended, "all_f"), ("strict_first", objects, "first_f"),
                                 ("strict_best", objects, "best_f"), ("strict_all", objects, "all_f"),
                                 ("best_of_scene", objects, "best_of_scene_f"), ("center", objects, "center_f")]:
        values = np.array([o[column] for o in chosen])
        row[name + "_f"] = values.mean() if len(values) else NAN
        row[name + "_f_deviation"] = math.sqrt(((values - values.mean())**2).mean()) if len(values) else NAN
    row["coverage"] = share(len(attended), len(objects))
    for name, most in [("5", lambda s: 5), ("10", lambda s: 10), ("objects", lambda s: len(s["objects"]))]:
        row["hits_within_" + name] = share(
            sum(o["attended"] and o["first_rank"] <= most(s) for s in scenes for o in s["objects"]), len(objects))
    on_objects = sum(h >= 0 for h in hits)
    row["points_per_scene"] = share(len(hits), len(scenes))
    row["points_per_object"] = share(on_objects, len(attended))
    row["points_on_objects"] = share(on_objects, len(hits))
    row["points_on_support"] = share(hits.count(SUPPORT), len(hits))
    row["points_on_invalid"] = share(hits.count(INVALID) + hits.count(UNLABELLED), len(hits))
    row["points_duplicate"] = share(on_objects - len(attended), len(hits))
    for i, name in enumerate(["precision", "recall", "f"]):
        row["overlap_" + name] = np.mean([s["overlap"][i] for s in scenes])
    confidence, f = ([x for s in scenes for x in s[key]] for key in ("confidence", "f"))
    row["confidence_correlation"] = np.corrcoef(ranks_of(confidence), ranks_of(f))[0, 1]
    return row


def compare(path, expected):
    """Every row and column of a CSV file; its numbers have six digits."""
    with open(path) as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(expected), f"{path.name}: {len(rows)} rows instead of {len(expected)}"
    compared = 0
    for row, want in zip(rows, expected):
        assert row.pop("system") == "results" and row.pop("theta_com") == ""
        assert list(row) == list(want), f"{path.name}: columns {list(row)}"
        for name, text in row.items():
            if isinstance(want[name], str):
                assert text == want[name], f"{path.name}: {name} is {text}, numpy says {want[name]}"
                continue
            value = float(text) if text else NAN
            same = math.isclose(value, want[name], rel_tol=1e-5, abs_tol=1e-9) or value != value and want[name] != want[name]
            assert same, f"{path.name}: {name} is {text} in {row}, numpy says {want[name]}"
            compared += 1
    return compared


def main(make_scene, segment, evaluate):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run = lambda *arguments: subprocess.run(list(map(str, arguments)), cwd=folder, check=True, stdout=subprocess.DEVNULL)
        for kind, preset, seed in [("clutter", "paper", 5), ("occluded", "default", 7)]:
            (folder / kind).mkdir()
            run(make_scene, folder / kind / f"{kind}.pcd", "-kind", kind, "-seed", seed, "-width", 240, "-height", 180,
                "-count", 3)
            # Points that lie in earlier segments too, so that masks overlap and objects have several.
            run(segment, kind, "-output_dir", "results", "-all_points", "-preset", preset)
        run(evaluate, "clutter", "occluded", "-results", "results", "-output_dir", "out")

        files = [file for kind in ("clutter", "occluded") for file in sorted((folder / kind).glob("*.pcd"))]
        scenes = {kind: [evaluate_scene(file, folder / "results" / file.stem, kind) for file in files]
                  for kind in ("objects", "parts")}
        assert any(o["points"] > 1 for s in scenes["objects"] for o in s["objects"]), "no object with several points"
        assert any(o["points"] == 0 for s in scenes["parts"] for o in s["objects"]), "no object without a point"
        summaries = [summarize(group, kind, [s for s in scenes[kind] if group in ("overall", s["category"])])
                     for kind in ("objects", "parts") for group in ("overall", "clutter", "occluded")]
        objects = [o for i in range(len(files)) for kind in ("objects", "parts") for o in scenes[kind][i]["objects"]]
        compared = compare(folder / "out/report.csv", summaries) + compare(folder / "out/objects.csv", objects)
        print(f"{compared} figures of {len(files)} scenes and {len(objects)} objects and parts are the same")


main(*map(pathlib.Path, sys.argv[1:]))
