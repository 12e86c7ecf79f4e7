# SPDX-License-Identifier: BSD-3-Clause
import ast
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import pcl_attention

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples" / "python"))
import table_scene  # noqa: E402


@pytest.fixture(scope="module")
def scene():
    return table_scene.render()[:2]


@pytest.fixture(scope="module")
def objects(scene):
    return pcl_attention.segment(*scene)


def same(a, b):
    return len(a) == len(b) and all(np.array_equal(x.indices, y.indices) and np.array_equal(x.box_size, y.box_size)
                                    for x, y in zip(a, b))


def write_pcd(path, xyz, rgb):
    height, width = xyz.shape[:2]
    points = np.zeros(height * width, dtype=[("xyz", "<f4", 3), ("rgba", "<u4")])
    points["xyz"] = xyz.reshape(-1, 3)
    r, g, b = rgb.reshape(-1, 3).astype(np.uint32).T
    points["rgba"] = r << 16 | g << 8 | b
    header = (f"VERSION 0.7\nFIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH {width}\nHEIGHT {height}\n"
              f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {height * width}\nDATA binary\n")
    path.write_bytes(header.encode() + points.tobytes())


def test_finds_the_objects(scene, objects):
    assert len(objects) >= 3
    assert [segment.rank for segment in objects] == list(range(1, len(objects) + 1))
    centers = sorted(float(np.median(segment.points[:, 0])) for segment in objects[:3])
    assert centers == pytest.approx([-0.16, 0.0, 0.18], abs=0.03)
    for segment in objects:
        assert segment.mask.dtype == bool and segment.mask.shape == scene[0].shape[:2]
        assert np.array_equal(np.flatnonzero(segment.mask), segment.indices)
        assert np.array_equal(segment.points, scene[0].reshape(-1, 3)[segment.indices])
        assert 0.0 <= segment.confidence <= 1.0
        assert abs(np.linalg.norm(segment.plane[:3]) - 1.0) < 1e-4
        assert segment.mask[segment.attention_point.row, segment.attention_point.column]


def test_gives_labels_planes_and_times(scene, objects):
    labels = np.zeros(scene[0].shape[:2], dtype=np.int32)
    for segment in reversed(list(objects)):
        labels[segment.mask] = segment.rank
    assert np.array_equal(objects.labels, labels)
    table = objects.supporting_planes[0]
    assert table.supports_objects
    assert table.coefficients == pytest.approx([0.0, -0.8, -0.6, 0.6], abs=0.02)
    stages = [value for name, value in objects.milliseconds.items() if name != "total"]
    assert max(stages) <= objects.milliseconds["total"] <= sum(stages) * 1.001  # some run beside each other


def test_finds_the_same_as_the_program(scene, objects, tmp_path):
    program = os.environ.get("PCL_ATTENTION_SEGMENT")
    if not program:
        pytest.skip("the programs are not built")
    write_pcd(tmp_path / "scene.pcd", *scene)
    subprocess.run([program, tmp_path / "scene.pcd", "-output_dir", tmp_path / "out"], check=True, capture_output=True)
    with open(tmp_path / "out/scene/attention_points.csv") as stream:
        rows = list(csv.DictReader(stream))
    segments = json.loads((tmp_path / "out/scene/segments.json").read_text())["segments"]
    assert len(segments) == len(rows) == len(objects)
    image = pytest.importorskip("matplotlib.image")
    for row, expected, segment in zip(rows, segments, objects):
        mask = image.imread(tmp_path / f"out/scene/mask_{segment.rank:04d}.png") > 0
        assert np.array_equal(segment.mask, mask)
        assert (segment.attention_point.column, segment.attention_point.row) == (int(row["column"]), int(row["row"]))
        assert segment.plane.tolist() == np.float32(expected["plane"]).tolist()
        assert segment.box_size.tolist() == np.float32(expected["box"]["size"]).tolist()
        assert np.float32(segment.confidence) == np.float32(expected["confidence"])
        assert segment.growth_end == expected["growth_end"]


def test_reads_any_memory_layout_and_type(scene, objects):
    xyz, rgb = scene
    wide = np.full(xyz.shape[:2] + (4,), np.nan, dtype=np.float32)
    wide[..., :3] = xyz
    for points in (wide[..., :3], np.asfortranarray(xyz), xyz.astype(np.float64), xyz[::-1][::-1]):
        assert same(pcl_attention.segment(points, rgb), objects)
    assert same(pcl_attention.segment(xyz, rgb[..., ::-1][..., ::-1]), objects)


def test_does_not_change_its_input(scene):
    xyz, rgb = (array.copy() for array in scene)
    xyz.setflags(write=False)
    rgb.setflags(write=False)
    pcl_attention.segment(xyz, rgb)
    assert np.array_equal(xyz, scene[0], equal_nan=True) and np.array_equal(rgb, scene[1])


def test_views_outlive_their_segment(scene):
    indices = pcl_attention.segment(*scene)[0].indices
    copy = indices.copy()
    pcl_attention.segment(*scene)
    assert np.array_equal(indices, copy)
    with pytest.raises(ValueError):
        indices[0] = 0


def test_works_without_color(scene):
    assert len(pcl_attention.segment(scene[0])) >= 3


def test_gives_the_same_with_any_number_of_threads(scene, objects):
    assert same(pcl_attention.segment(*scene, threads=1), objects)


def test_iterates_in_order_of_attention(scene, objects):
    assert same(list(pcl_attention.iterate(*scene)), objects)
    first = next(pcl_attention.iterate(*scene))
    assert np.array_equal(first.indices, objects[0].indices)


def test_refuses_a_second_thread_on_the_same_iterator(scene, objects):
    """While one thread computes an object, another one that asks for the next is told so; the objects stay the same."""
    iterator = pcl_attention.iterate(*scene, threads=1)
    found, refused = [], []
    together = threading.Barrier(2)

    def take():
        together.wait()
        while True:
            try:
                found.append(next(iterator))
            except StopIteration:
                return
            except ValueError as error:
                refused.append(str(error))
                time.sleep(0.001)

    threads = [threading.Thread(target=take) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert same(sorted(found, key=lambda segment: segment.rank), objects)
    assert refused and set(refused) == {"iterator already executing"}


def test_keeps_to_the_mask(scene):
    mask = np.zeros(scene[0].shape[:2], dtype=bool)
    mask[60:180, 40:160] = True
    holes = np.where(mask[..., None], scene[0], np.nan)
    masked = pcl_attention.segment(*scene, mask=mask)
    assert len(masked) > 0 and all(mask.reshape(-1)[segment.indices].all() for segment in masked)
    assert same(masked, pcl_attention.segment(holes, scene[1]))


def test_looks_where_it_is_told(scene):
    row, column = (int(np.median(values)) for values in np.nonzero(scene[1][..., 2] == 200))  # the blue box
    segments = pcl_attention.segment(*scene, fixations=[(column, row)], coverage=False)
    assert len(segments) == 1
    assert segments[0].attention_point.kind == "user"
    assert segments[0].mask[row, column]
    assert (scene[1][segments[0].mask][:, 2] == 200).mean() > 0.95


def test_puts_first_what_is_asked_for(scene, objects):
    xyz, rgb = scene
    for target in objects[:3]:
        mask, points = target.mask, target.points
        rows, columns = np.nonzero(mask)
        distances = np.linalg.norm(points, axis=1)
        priors = {
            "prior_map": mask,
            "prior_region": (columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1),
            "prior_box": (points.min(axis=0), points.max(axis=0)),
            "prior_color": np.median(rgb[mask], axis=0).astype(np.uint8),
            "prior_color_exemplar": rgb[mask],
            "prior_distance": (distances.min(), distances.max()),
        }
        for name, prior in priors.items():
            found = pcl_attention.segment(xyz, rgb, **{name: prior})
            assert len(found) >= len(objects)
            if name != "prior_distance":  # another object may be as far away
                assert np.isin(found[0].indices, target.indices).mean() > 0.9, name
        assert pcl_attention.attention_points(xyz, rgb, prior_map=mask)[0].saliency > 0.0
    blue = next(pcl_attention.iterate(xyz, rgb, prior_color="blue"))
    assert (rgb[blue.mask][:, 2] == 200).mean() > 0.95
    longest = [max(segment.box_size) for segment in objects[:3]]
    large = pcl_attention.segment(xyz, rgb, prior_size=(max(longest) - 0.01, max(longest) + 0.01))
    small = pcl_attention.segment(xyz, rgb, prior_size=(0.0, min(longest)))
    assert max(large[0].box_size) > max(small[0].box_size)
    everywhere = np.ones(xyz.shape[:2])
    assert same(pcl_attention.segment(xyz, rgb, prior_map=everywhere), objects)


def test_keeps_the_order_of_fixations_whatever_is_asked_for(scene, objects):
    fixations = [(segment.attention_point.column, segment.attention_point.row) for segment in reversed(list(objects))]
    assert same(pcl_attention.segment(*scene, fixations=fixations, prior_map=objects[0].mask),
                pcl_attention.segment(*scene, fixations=fixations))


def test_gives_saliency_and_points(scene, objects):
    saliency = pcl_attention.saliency(*scene)
    assert saliency.shape == scene[0].shape[:2] and saliency.dtype == np.float32
    assert saliency.min() == 0.0 and saliency.max() == pytest.approx(1.0)
    points = pcl_attention.attention_points(*scene)
    assert points and all(saliency[point.row, point.column] > 0 for point in points)
    assert [point.saliency for point in points] == sorted((point.saliency for point in points), reverse=True)
    assert same(pcl_attention.segment(*scene, saliency=saliency), objects)


def test_gives_the_patches_of_the_segments(scene, objects):
    patches = pcl_attention.patches(*scene)
    assert patches.shape == scene[0].shape[:2] and patches.dtype == np.int32
    assert set(objects[0].patches) <= set(np.unique(patches[objects[0].mask]).tolist())


def test_moves_with_cloud_and_sensor(scene, objects):
    angle = 0.3
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    shift = np.array([1.0, -2.0, 0.5])
    moved = pcl_attention.segment(scene[0] @ turn.T + shift, scene[1], sensor_origin=shift,
                                  sensor_orientation=(np.cos(angle / 2), 0, 0, np.sin(angle / 2)))
    assert len(moved) == len(objects)
    for b in objects:
        a = max(moved, key=lambda segment: np.isin(segment.indices, b.indices).sum())  # rounding may change the order
        assert np.isin(a.indices, b.indices).mean() > 0.97
        assert a.box_center == pytest.approx(turn @ b.box_center + shift, abs=0.01)


def test_takes_every_parameter(scene):
    table = pcl_attention.parameters()
    assert table["levels"] == 4 and table["coverage"] is True and table["plane_model"] in ("initial", "running")
    assert pcl_attention.parameters(**table) == table
    paper = pcl_attention.parameters(preset="paper")
    assert paper != table
    assert pcl_attention.parameters(parts=True)["join_hollows"] is False
    assert pcl_attention.parameters(coverage=np.False_)["coverage"] is False
    assert pcl_attention.parameters(levels=np.int64(3), full_size=np.float32(0.1))["full_size"] == 0.1
    assert same(pcl_attention.segment(*scene, **paper), pcl_attention.segment(*scene, preset="paper"))
    assert len(pcl_attention.segment(*scene, minimum_segment_size=10**6)) == 0


def test_gives_the_same_parameters_in_any_locale(tmp_path):
    if shutil.which("localedef") is None or subprocess.run(
            ["localedef", "-i", "de_DE", "-f", "UTF-8", tmp_path / "de_DE.UTF-8"], capture_output=True).returncode != 0:
        pytest.skip("a locale with a decimal comma cannot be made: no localedef, or no sources of locales")
    script = ("import locale, json, pcl_attention; locale.setlocale(locale.LC_ALL, 'de_DE.UTF-8'); "
              "assert locale.localeconv()['decimal_point'] == ','; print(json.dumps(pcl_attention.parameters()))")
    run = subprocess.run([sys.executable, "-c", script], env={**os.environ, "LOCPATH": str(tmp_path)}, check=True,
                         capture_output=True, text=True)
    assert json.loads(run.stdout) == pcl_attention.parameters()


@pytest.mark.parametrize("error, message, arguments", [
    (ValueError, "xyz has the shape (240, 320), but must have (height, width, 3)", {"xyz": np.zeros((240, 320))}),
    (ValueError, "xyz has the shape (500, 3)", {"xyz": np.zeros((500, 3))}),
    (ValueError, "xyz has the shape (1, 500, 3), which is no image", {"xyz": np.zeros((1, 500, 3))}),
    (ValueError, "xyz has the shape (0, 5, 3)", {"xyz": np.zeros((0, 5, 3))}),
    (ValueError, "rgb has the shape (2, 2, 3), but must have (240, 320, 3), as xyz",
     {"rgb": np.zeros((2, 2, 3), np.uint8)}),
    (TypeError, "rgb must be an array of uint8", {"rgb": np.zeros((240, 320, 3))}),
    (TypeError, "mask must be an array of bool", {"mask": np.zeros((240, 320))}),
    (ValueError, "the fixation (320", {"fixations": [(320, 10)]}),
    (ValueError, "fixations has the shape (3,), but must have (n, 2)", {"fixations": [1, 2, 3]}),
    (ValueError, "The saliency at column 0, row 0 is -1", {"saliency": -np.ones((240, 320))}),
    (ValueError, "sensor_origin is not finite", {"sensor_origin": (0, np.nan, 0)}),
    (ValueError, "levels is '99', but must be a whole number from 1 to 8", {"levels": 99}),
    (ValueError, "preset is 'best', but must be 'default' or 'paper'", {"preset": "best"}),
    (ValueError, "threads is -1, but must be 0 (all) or more", {"threads": -1}),
    (TypeError, "threads must be a whole number", {"threads": "all"}),
    (ValueError, "prior_map has the shape (2, 2), but must have (240, 320), as xyz", {"prior_map": np.zeros((2, 2))}),
    (ValueError, "the map of the prior holds 2.0", {"prior_map": np.full((240, 320), 2.0)}),
    (TypeError, "prior_region must be whole numbers: column, row, width and height", {"prior_region": (1, 2, 3)}),
    (ValueError, "the region of the prior has 5 x 5 pixels from column 320", {"prior_region": (320, 0, 5, 5)}),
    (TypeError, "prior_box must be two corners of three numbers each", {"prior_box": (0, 0, 0, 1, 1, 1)}),
    (ValueError, "the box of the prior is empty or not finite", {"prior_box": ((0, 0, 1), (1, 1, 0))}),
    (TypeError, "prior_color must be red, green, blue from 0 to 255, or one of black, grey", {"prior_color": "reddish"}),
    (TypeError, "prior_color must be red, green, blue from 0 to 255", {"prior_color": (0, 0, 256)}),
    (ValueError, "the prior asks for a colour, but the cloud has none", {"prior_color": "red"}),
    (TypeError, "prior_color_exemplar must be an array of uint8", {"prior_color_exemplar": np.zeros((5, 3))}),
    (ValueError, "prior_color_exemplar has the shape (5,), but must have (n, 3)",
     {"prior_color_exemplar": np.zeros(5, np.uint8)}),
    (TypeError, "prior_size must be two numbers: minimum and maximum, metres", {"prior_size": 0.2}),
    (ValueError, "the distance of the prior is from 2.0", {"prior_distance": (2.0, 1.0)}),
    (TypeError, "there is no argument 'level'; pcl_attention.parameters () lists", {"level": 3}),
])
def test_says_what_is_wrong(scene, error, message, arguments):
    arguments = {"xyz": scene[0], **arguments}
    with pytest.raises(error) as raised:
        pcl_attention.segment(**arguments)
    assert message in str(raised.value)


def test_finds_nothing_where_there_is_nothing():
    assert len(pcl_attention.segment(np.full((48, 64, 3), np.nan, dtype=np.float32))) == 0


def test_releases_the_lock(scene):
    """Another thread runs on while a frame is segmented."""
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    pcl_attention.segment(*scene, threads=1)
    end = time.monotonic()
    done.set()
    thread.join()
    assert sum(begin < at < end for at in ticks) >= 3


def test_stubs_name_what_there_is():
    folder = pathlib.Path(pcl_attention.__file__).parent
    assert (folder / "py.typed").exists()
    stubs = ast.parse((folder / "__init__.pyi").read_text())
    named = {node.name for node in stubs.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    assert named == set(pcl_attention.__all__) - {"__version__"}
    for node in stubs.body:
        if isinstance(node, ast.ClassDef):
            members = {member.name for member in node.body
                       if isinstance(member, ast.FunctionDef) and not member.name.startswith("_")}
            there = {name for name in dir(getattr(pcl_attention, node.name)) if not name.startswith("_")}
            assert members == there, node.name
    for name in named:
        assert getattr(pcl_attention, name).__doc__, f"{name} has no docstring"
