"""Which instances Infinigen generates: its factories, the classes they fill, and seeds that train or only test."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

FIRST_TRAIN, FIRST_TEST = 10_000, 20_000


@dataclass(frozen=True)
class Generated:
    """A factory and what becomes of its instances.

    Attributes:
        module, factory: where Infinigen has it, below `infinigen.assets.objects`.
        role, category, name: as in the catalogue of the pack.
        train, test: how many seeds are tried for each pool.
        longest: the usual longest side (m) of an object, or the most that furniture may be wide or deep.
        tallest: the most that furniture may be high (m): the robot is to reach its top.
        trained: how many of the seeds for training, the first ones, are left out: the pack has them.
        turn: degrees about z that bring the front to -y; Infinigen has it towards x.
        lying: whether it is laid on its broad side.
        collision: as in an `Entry`.
        density: kg for each m3 of the bounding box; that of `masses` where 0.
    """

    module: str
    factory: str
    role: str
    category: str
    name: str
    train: int
    test: int
    longest: float
    turn: float = -90.0
    lying: bool = False
    collision: str = ""
    density: float = 0.0
    tallest: float = 1.95
    trained: int = 0

    @property
    def seeds(self) -> Iterator[int]:
        """The seeds that are tried, those for training first."""
        yield from range(FIRST_TRAIN + self.trained, FIRST_TRAIN + self.train)
        yield from range(FIRST_TEST, FIRST_TEST + self.test)

    def more(self, count: int) -> "Generated":
        """Return the factory with so many more seeds for training where it trains, and none besides."""
        return replace(self, train=self.train + count if self.train else 0, test=0, trained=self.train)

    def file(self, seed: int) -> str:
        """Return the stem of an instance's file."""
        return f"{self.category}_{self.factory.removesuffix('Factory').lower()}_{seed}"


PLAN: tuple[Generated, ...] = (
    Generated("tableware.cup", "CupFactory", "object", "cup", "cup", 5, 3, 0.115, collision="hollow", density=330),
    Generated("tableware.bowl", "BowlFactory", "object", "bowl", "bowl", 5, 3, 0.19, collision="hollow", density=330),
    Generated("tableware.plate", "PlateFactory", "object", "plate", "plate", 5, 3, 0.25, density=800),
    Generated(
        "tableware.pot", "PotFactory", "object", "pot", "cooking pot", 4, 3, 0.25, collision="hollow", density=230
    ),
    Generated(
        "tableware.pan", "PanFactory", "object", "pan", "frying pan", 0, 3, 0.42, collision="hollow", density=120
    ),
    Generated("tableware.bottle", "BottleFactory", "object", "bottle", "bottle", 5, 3, 0.24, density=600),
    Generated("tableware.can", "CanFactory", "object", "can", "can", 5, 3, 0.12, density=850),
    Generated("tableware.jar", "JarFactory", "object", "jar", "jar", 5, 3, 0.16, density=780),
    Generated("tableware.wineglass", "WineglassFactory", "object", "wineglass", "wine glass", 8, 4, 0.19, density=160),
    Generated("tableware.fork", "ForkFactory", "object", "fork", "fork", 5, 3, 0.2, density=900),
    Generated("tableware.fork", "SpatulaFactory", "object", "spatula", "spatula", 5, 3, 0.3, density=260),
    Generated("tableware.knife", "KnifeFactory", "object", "knife", "knife", 5, 3, 0.22, density=1400),
    Generated("tableware.food_box", "FoodBoxFactory", "object", "cereal_box", "cereal box", 0, 3, 0.27, density=130),
    Generated("lamp.lamp", "DeskLampFactory", "object", "lamp", "table lamp", 5, 3, 0.36, density=90),
    Generated(
        "table_decorations.vase", "VaseFactory", "object", "vase", "vase", 0, 4, 0.24, collision="hull", density=300
    ),
    Generated("table_decorations.book", "BookFactory", "object", "book", "book", 5, 3, 0.22, density=650),
    Generated("appliances.toaster", "ToasterFactory", "object", "toaster", "toaster", 4, 2, 0.32, density=270),
    Generated("tables.dining_table", "TableDiningFactory", "receptacle", "table", "dining table", 4, 2, 1.8),
    Generated("tables.dining_table", "SideTableFactory", "receptacle", "stand", "side table", 5, 3, 0.6),
    Generated("tables.dining_table", "CoffeeTableFactory", "receptacle", "table", "coffee table", 3, 2, 1.2),
    Generated(
        "tables.cocktail_table", "TableCocktailFactory", "receptacle", "table", "bar table", 3, 1, 0.7, tallest=1.02
    ),
    Generated("seating.chairs", "ChairFactory", "receptacle", "chair", "chair", 6, 3, 0.65),
    Generated("seating.chairs", "BarChairFactory", "receptacle", "stool", "bar chair", 6, 3, 0.5, tallest=0.78),
    Generated("seating.chairs", "OfficeChairFactory", "receptacle", "chair", "office chair", 4, 2, 0.65),
    Generated("seating.sofa", "SofaFactory", "receptacle", "couch", "sofa", 5, 3, 2.1),
    Generated("shelves.simple_bookcase", "SimpleBookcaseFactory", "receptacle", "shelves", "bookcase", 6, 3, 1.2),
    Generated("shelves.cell_shelf", "CellShelfFactory", "receptacle", "shelves", "cube shelves", 5, 2, 1.5),
    Generated("shelves.cell_shelf", "TVStandFactory", "receptacle", "stand", "TV stand", 4, 2, 1.6),
    Generated("shelves.large_shelf", "LargeShelfFactory", "receptacle", "shelves", "wide shelves", 4, 2, 1.5),
    Generated("shelves.triangle_shelf", "TriangleShelfFactory", "receptacle", "shelves", "corner shelves", 3, 1, 0.6),
    Generated("shelves.simple_desk", "SimpleDeskFactory", "receptacle", "table", "desk", 4, 2, 1.5),
    Generated(
        "shelves.single_cabinet", "SingleCabinetFactory", "receptacle", "cabinet", "cabinet", 5, 3, 1.2, tallest=1.04
    ),
    Generated("bathroom.bathtub", "BathtubFactory", "receptacle", "bathtub", "bathtub", 10, 5, 1.8),
    Generated("bathroom.toilet", "ToiletFactory", "receptacle", "toilet", "toilet", 9, 4, 0.8),
    Generated("bathroom.bathroom_sink", "StandingSinkFactory", "receptacle", "sink", "washbasin", 7, 3, 0.8),
    Generated("seating.pillow", "PillowFactory", "object", "cushion", "cushion", 1, 1, 0.42, lying=True, density=30),
    Generated(
        "organizer.basket", "BasketBaseFactory", "object", "basket", "basket", 0, 1, 0.34, collision="boxes", density=60
    ),
)
