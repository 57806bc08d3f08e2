"""Which model of ours stands in for an asset: one of its class, the nearest in size."""

import math
from zlib import crc32

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model

Sizes = tuple[float | None, float | None, float | None]
"""Width, depth and height (m), as far as they are known."""


def stand_in(library: Catalogue, category: str, asset: str, size: Sizes) -> Model | None:
    """Return the model that stands in for an asset, or None where the library has none of its class.

    Models kept from training go before all others. The same asset has the same stand-in in every house; assets of which
    no size is known are spread over the class.

    Args:
        library: of the models.
        category: ours.
        asset: its id.
        size: what is known of it.
    """
    models = library.of_category(category, "test") or library.of_category(category)
    return min(models, key=lambda model: (misfit(model, size), crc32(f"{asset} {model.id}".encode())), default=None)


def misfit(model: Model, size: Sizes) -> float:
    """Return how unlike in size a model is: the sum of the logarithms of the ratios that are known; 0 is alike."""
    return sum(abs(math.log(own / other)) for own, other in zip(model.size, size, strict=True) if other and other > 0.0)
