"""Pictures in KTX2 as a compressed data set has them, and what the coding leaves of them."""

import alktx2
import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]


class Ktx2Pictures:
    """Encodes pictures (H, W, 3) RGB, each once; the picture is kept with its file, so that its id stays its own."""

    def __init__(self) -> None:
        self._files: dict[int, tuple[Picture, bytes]] = {}

    def file(self, picture: Picture) -> bytes:
        """Return a picture's KTX2 file, in UASTC."""
        if id(picture) not in self._files:
            height, width = picture.shape[:2]
            rgba = np.dstack([picture, np.full((height, width), 255, np.uint8)]).tobytes()
            file = alktx2.encode_raw_rgba_to_ktx2(rgba, width, height, codec="uastc", effort=0, threads=1)
            self._files[id(picture)] = (picture, file)
        return self._files[id(picture)][1]

    def left_of(self, picture: Picture) -> Picture:
        """Return what the coding leaves of a picture, by another decoder than ours: that of the encoder's makers."""
        png, _ = alktx2.decode_ktx2_to_bytes(self.file(picture), format="png")
        decoded = np.asarray(cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR), np.uint8)
        # That decoder shows the whole of the last blocks of 4 x 4, which reach beyond a picture of another size.
        return np.ascontiguousarray(decoded[: picture.shape[0], : picture.shape[1], ::-1])
