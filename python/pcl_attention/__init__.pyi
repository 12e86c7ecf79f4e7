# SPDX-License-Identifier: BSD-3-Clause
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str
__all__: List[str]

class AttentionPoint:
    @property
    def column(self) -> int: ...
    @property
    def row(self) -> int: ...
    @property
    def saliency(self) -> float: ...
    @property
    def point_saliency(self) -> float: ...
    @property
    def kind(self) -> str: ...

class SupportingPlane:
    @property
    def coefficients(self) -> NDArray[np.float32]: ...
    @property
    def indices(self) -> NDArray[np.int32]: ...
    @property
    def area(self) -> float: ...
    @property
    def confidence(self) -> float: ...
    @property
    def supports_objects(self) -> bool: ...

class Segment:
    @property
    def rank(self) -> int: ...
    @property
    def indices(self) -> NDArray[np.int32]: ...
    @property
    def mask(self) -> NDArray[np.bool_]: ...
    @property
    def points(self) -> NDArray[np.float32]: ...
    @property
    def attention_point(self) -> AttentionPoint: ...
    @property
    def plane(self) -> NDArray[np.float32]: ...
    @property
    def box_center(self) -> NDArray[np.float32]: ...
    @property
    def box_orientation(self) -> NDArray[np.float32]: ...
    @property
    def box_size(self) -> NDArray[np.float32]: ...
    @property
    def compactness(self) -> float: ...
    @property
    def confidence(self) -> float: ...
    @property
    def patches(self) -> List[int]: ...
    @property
    def growth_end(self) -> str: ...

class Segmentation(Sequence[Segment]):
    @property
    def segments(self) -> List[Segment]: ...
    @property
    def supporting_planes(self) -> List[SupportingPlane]: ...
    @property
    def labels(self) -> NDArray[np.int32]: ...
    @property
    def milliseconds(self) -> Dict[str, float]: ...
    @overload
    def __getitem__(self, index: int) -> Segment: ...
    @overload
    def __getitem__(self, index: slice) -> List[Segment]: ...
    def __len__(self) -> int: ...

_Numbers = Union[Sequence[float], NDArray[Any]]
_Fixations = Union[Sequence[Tuple[float, float]], NDArray[Any]]
_Range = Tuple[float, float]
_Parameter = Union[bool, float, str, np.generic]

def segment(
    xyz: ArrayLike,
    rgb: Optional[NDArray[np.uint8]] = None,
    *,
    mask: Optional[NDArray[np.bool_]] = None,
    sensor_origin: Optional[_Numbers] = None,
    sensor_orientation: Optional[_Numbers] = None,
    saliency: Optional[ArrayLike] = None,
    fixations: Optional[_Fixations] = None,
    prior_map: Optional[ArrayLike] = None,
    prior_region: Optional[Tuple[int, int, int, int]] = None,
    prior_box: Optional[Union[Sequence[_Numbers], NDArray[Any]]] = None,
    prior_color: Optional[Union[str, Tuple[int, int, int], NDArray[np.uint8]]] = None,
    prior_color_exemplar: Optional[NDArray[np.uint8]] = None,
    prior_size: Optional[_Range] = None,
    prior_distance: Optional[_Range] = None,
    threads: int = 0,
    preset: str = "default",
    parts: bool = False,
    **parameters: _Parameter,
) -> Segmentation: ...
def iterate(
    xyz: ArrayLike,
    rgb: Optional[NDArray[np.uint8]] = None,
    *,
    mask: Optional[NDArray[np.bool_]] = None,
    sensor_origin: Optional[_Numbers] = None,
    sensor_orientation: Optional[_Numbers] = None,
    saliency: Optional[ArrayLike] = None,
    fixations: Optional[_Fixations] = None,
    prior_map: Optional[ArrayLike] = None,
    prior_region: Optional[Tuple[int, int, int, int]] = None,
    prior_box: Optional[Union[Sequence[_Numbers], NDArray[Any]]] = None,
    prior_color: Optional[Union[str, Tuple[int, int, int], NDArray[np.uint8]]] = None,
    prior_color_exemplar: Optional[NDArray[np.uint8]] = None,
    prior_size: Optional[_Range] = None,
    prior_distance: Optional[_Range] = None,
    threads: int = 0,
    preset: str = "default",
    parts: bool = False,
    **parameters: _Parameter,
) -> Iterator[Segment]: ...
def saliency(
    xyz: ArrayLike,
    rgb: Optional[NDArray[np.uint8]] = None,
    *,
    mask: Optional[NDArray[np.bool_]] = None,
    sensor_origin: Optional[_Numbers] = None,
    sensor_orientation: Optional[_Numbers] = None,
    threads: int = 0,
    preset: str = "default",
    **parameters: _Parameter,
) -> NDArray[np.float32]: ...
def attention_points(
    xyz: ArrayLike,
    rgb: Optional[NDArray[np.uint8]] = None,
    *,
    mask: Optional[NDArray[np.bool_]] = None,
    sensor_origin: Optional[_Numbers] = None,
    sensor_orientation: Optional[_Numbers] = None,
    saliency: Optional[ArrayLike] = None,
    prior_map: Optional[ArrayLike] = None,
    prior_region: Optional[Tuple[int, int, int, int]] = None,
    prior_box: Optional[Union[Sequence[_Numbers], NDArray[Any]]] = None,
    prior_color: Optional[Union[str, Tuple[int, int, int], NDArray[np.uint8]]] = None,
    prior_color_exemplar: Optional[NDArray[np.uint8]] = None,
    prior_size: Optional[_Range] = None,
    prior_distance: Optional[_Range] = None,
    threads: int = 0,
    preset: str = "default",
    **parameters: _Parameter,
) -> List[AttentionPoint]: ...
def patches(
    xyz: ArrayLike,
    rgb: Optional[NDArray[np.uint8]] = None,
    *,
    mask: Optional[NDArray[np.bool_]] = None,
    sensor_origin: Optional[_Numbers] = None,
    sensor_orientation: Optional[_Numbers] = None,
    threads: int = 0,
    preset: str = "default",
    **parameters: _Parameter,
) -> NDArray[np.int32]: ...
def parameters(
    *, preset: str = "default", parts: bool = False, **parameters: _Parameter
) -> Dict[str, Union[bool, int, float, str]]: ...
