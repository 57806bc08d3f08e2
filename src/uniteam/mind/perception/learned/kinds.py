"""The kinds of things that the segmenter tells apart before anything is named."""

from enum import IntEnum


class Kind(IntEnum):
    """What a pixel belongs to; the value is the index of the network's channel."""

    STUFF = 0
    RECEPTACLE = 1
    OBJECT = 2
    DECOR = 3
