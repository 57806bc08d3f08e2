"""The small objects drawn here: what the sources lack, and further instances."""

from collections.abc import Callable

from assets_build import finishes as f
from assets_build.drawn import Drawn
from assets_build.drawn_food import banana, carrot, fruit
from assets_build.drawn_household import (
    block,
    book,
    candle,
    carton,
    cuboid,
    flower_pot,
    frame,
    keyboard,
    lamp,
    laptop,
    mouse,
    roll,
    towel,
    umbrella,
    wallet,
)
from assets_build.drawn_toys import ball, die, dumbbell, toy_bricks, toy_car, trophy
from assets_build.drawn_vessels import (
    basket,
    bottle,
    can,
    cutlery,
    kettle,
    pan,
    rimmed_plate,
    rolling_pin,
    tray,
    turned,
    vessel,
)
from assets_build.primitives import Drawing, Finish

Draw = Callable[[Drawing], None]


def _color(r: float, g: float, b: float) -> Finish:
    return Finish((r, g, b))


def _print(paper: tuple[float, float, float], ink: tuple[float, float, float], seed: int) -> Finish:
    return f.printed(paper, ink, seed)


def _object(category: str, slug: str, draw: Draw, collision: str = "hull", mass: float = 0.0, name: str = "") -> Drawn:
    return Drawn("object", category, slug, name or category.replace("_", " "), draw, collision, 8, mass, 1100)


OBJECTS: tuple[Drawn, ...] = (
    _object("bowl", "white", vessel((0.035, 0.06, 0.072, 0.08), 0.07, 0.004, f.WHITE, foot=0.008), "hollow", 0.3),
    _object(
        "bowl",
        "blue",
        vessel((0.04, 0.075, 0.09, 0.095), 0.08, 0.005, _color(0.25, 0.42, 0.62), foot=0.01),
        "hollow",
        0.4,
    ),
    _object("bowl", "wood", vessel((0.05, 0.09, 0.11, 0.12), 0.085, 0.008, f.OAK), "hollow", 0.4),
    _object("cup", "red_mug", vessel((0.038, 0.04, 0.04, 0.04), 0.095, 0.004, f.RED, handle=True), "hollow", 0.3),
    _object("cup", "sage_mug", vessel((0.036, 0.043, 0.045, 0.042), 0.085, 0.004, f.SAGE, handle=True), "hollow", 0.3),
    _object(
        "cup",
        "yellow_mug",
        vessel((0.04, 0.041, 0.042, 0.042), 0.1, 0.004, _color(0.92, 0.76, 0.2), handle=True),
        "hollow",
        0.3,
    ),
    _object("plate", "blue_rim", rimmed_plate(0.13, 0.022, f.WHITE, _color(0.2, 0.35, 0.6)), mass=0.5),
    _object("plate", "terracotta", rimmed_plate(0.11, 0.022, f.TERRACOTTA, f.TERRACOTTA), mass=0.4),
    _object("plate", "cream", rimmed_plate(0.14, 0.025, f.CREAM, f.SAGE), mass=0.5),
    _object("can", "tomato_soup", can(0.037, 0.105, _print((0.8, 0.15, 0.1), (0.98, 0.95, 0.85), 1)), mass=0.4),
    _object("can", "beans", can(0.037, 0.11, _print((0.15, 0.5, 0.55), (0.98, 0.92, 0.7), 2)), mass=0.4),
    _object("can", "corn", can(0.042, 0.08, _print((0.95, 0.8, 0.2), (0.2, 0.45, 0.2), 3)), mass=0.35),
    _object("can", "cola", can(0.033, 0.12, _print((0.75, 0.08, 0.1), (0.95, 0.95, 0.95), 4)), mass=0.35),
    _object(
        "book",
        "red_novel",
        book(0.13, 0.2, 0.03, _print((0.6, 0.12, 0.12), (0.95, 0.85, 0.6), 5), _color(0.55, 0.1, 0.1)),
        mass=0.4,
    ),
    _object(
        "book",
        "blue_hardback",
        book(0.16, 0.24, 0.035, _print((0.15, 0.25, 0.5), (0.9, 0.9, 0.85), 6), f.NAVY),
        mass=0.6,
    ),
    _object(
        "book",
        "green_paperback",
        book(0.11, 0.18, 0.022, _print((0.25, 0.45, 0.3), (0.95, 0.9, 0.7), 7), _color(0.2, 0.4, 0.26)),
        mass=0.25,
    ),
    _object(
        "book",
        "cookery",
        book(0.21, 0.27, 0.028, _print((0.95, 0.9, 0.8), (0.75, 0.3, 0.15), 8), _color(0.9, 0.85, 0.75)),
        mass=0.8,
    ),
    _object("notebook", "black", book(0.14, 0.21, 0.014, f.BLACK, f.BLACK), mass=0.2),
    _object("notebook", "kraft", book(0.15, 0.21, 0.012, f.CARDBOARD, f.CARDBOARD), mass=0.2),
    _object("notebook", "teal", book(0.12, 0.18, 0.013, _color(0.15, 0.48, 0.5), _color(0.12, 0.4, 0.42)), mass=0.15),
    _object(
        "cereal_box",
        "flakes",
        carton(0.19, 0.065, 0.28, _print((0.95, 0.75, 0.15), (0.75, 0.15, 0.1), 9), _color(0.93, 0.72, 0.15)),
        mass=0.4,
    ),
    _object(
        "cereal_box",
        "oats",
        carton(0.18, 0.07, 0.26, _print((0.2, 0.4, 0.7), (0.98, 0.95, 0.85), 10), _color(0.18, 0.36, 0.62)),
        mass=0.4,
    ),
    _object(
        "cereal_box",
        "muesli",
        carton(0.17, 0.06, 0.25, _print((0.85, 0.88, 0.8), (0.3, 0.45, 0.2), 11), _color(0.8, 0.84, 0.74)),
        mass=0.4,
    ),
    _object(
        "tissue_box",
        "blue",
        carton(0.22, 0.12, 0.09, _print((0.7, 0.82, 0.9), (0.95, 0.95, 0.98), 12), _color(0.66, 0.78, 0.88)),
        mass=0.2,
    ),
    _object(
        "tissue_box",
        "rose",
        carton(0.12, 0.12, 0.13, _print((0.92, 0.78, 0.78), (0.98, 0.95, 0.92), 13), _color(0.9, 0.74, 0.74)),
        mass=0.2,
    ),
    _object(
        "tissue_box",
        "green",
        carton(0.22, 0.12, 0.07, _print((0.75, 0.86, 0.72), (0.4, 0.55, 0.38), 14), _color(0.7, 0.82, 0.68)),
        mass=0.2,
    ),
    _object(
        "bottle",
        "water",
        bottle(
            0.034, 0.22, 0.013, _color(0.72, 0.84, 0.9), _color(0.2, 0.4, 0.75), _print((0.3, 0.6, 0.85), (1, 1, 1), 15)
        ),
        mass=0.5,
    ),
    _object(
        "bottle",
        "ketchup",
        bottle(0.033, 0.2, 0.014, f.RED, f.WHITE, _print((0.95, 0.93, 0.88), (0.75, 0.1, 0.1), 16)),
        mass=0.5,
    ),
    _object(
        "bottle",
        "detergent",
        bottle(
            0.045,
            0.24,
            0.018,
            _color(0.95, 0.78, 0.2),
            _color(0.2, 0.45, 0.75),
            _print((0.2, 0.45, 0.75), (1, 1, 1), 17),
        ),
        mass=0.8,
    ),
    _object(
        "shampoo",
        "lilac",
        bottle(0.032, 0.19, 0.02, _color(0.72, 0.62, 0.82), f.WHITE, _print((0.95, 0.95, 0.98), (0.5, 0.35, 0.65), 18)),
        mass=0.4,
    ),
    _object(
        "shampoo",
        "green",
        bottle(
            0.03,
            0.21,
            0.018,
            _color(0.5, 0.74, 0.55),
            _color(0.2, 0.42, 0.28),
            _print((0.95, 0.98, 0.92), (0.2, 0.45, 0.28), 19),
        ),
        mass=0.4,
    ),
    _object("candle", "white_pillar", candle(0.035, 0.12, f.CREAM, False), mass=0.3),
    _object("candle", "red_saucer", candle(0.025, 0.14, f.RED, True), mass=0.3),
    _object("candle", "green_short", candle(0.04, 0.08, _color(0.35, 0.5, 0.36), False), mass=0.3),
    _object("sponge", "yellow", block((0.11, 0.07, 0.035), f.speckled((0.95, 0.8, 0.25), 0.08), 0.15), mass=0.02),
    _object("sponge", "blue", block((0.12, 0.075, 0.045), f.speckled((0.3, 0.6, 0.8), 0.08), 0.2), mass=0.02),
    _object("sponge", "pink", block((0.1, 0.1, 0.04), f.speckled((0.9, 0.55, 0.65), 0.08), 0.4), mass=0.02),
    _object("soap_bar", "white", block((0.085, 0.055, 0.03), _color(0.95, 0.93, 0.88), 0.4), mass=0.1),
    _object("soap_bar", "green", block((0.08, 0.05, 0.028), _color(0.62, 0.8, 0.6), 0.3), mass=0.1),
    _object("ball", "tennis", ball(0.034, f.cloth((0.8, 0.88, 0.25)), f.WHITE), mass=0.06),
    _object("ball", "red", ball(0.065, f.RED, f.WHITE), mass=0.15),
    _object("ball", "striped", ball(0.07, f.striped((0.95, 0.9, 0.3), (0.2, 0.5, 0.8)), None), mass=0.12),
    _object("ball", "orange_basket", ball(0.068, f.speckled((0.85, 0.45, 0.18), 0.05), f.BLACK), mass=0.2),
    _object("die", "white", die(0.06, f.WHITE, f.BLACK), mass=0.05),
    _object("die", "red", die(0.075, f.RED, f.WHITE), mass=0.08),
    _object("dumbbell", "black", dumbbell(0.24, 0.045, f.DARK_STEEL), mass=2.0),
    _object("dumbbell", "teal", dumbbell(0.2, 0.035, _color(0.15, 0.55, 0.55)), mass=1.0),
    _object("dumbbell", "pink", dumbbell(0.19, 0.032, _color(0.88, 0.42, 0.58)), mass=0.8),
    _object(
        "toy_construction_set",
        "wooden_blocks",
        toy_bricks((f.RED, _color(0.2, 0.45, 0.75), _color(0.95, 0.78, 0.2))),
        "boxes",
        0.15,
        "toy blocks",
    ),
    _object(
        "toy_construction_set",
        "pastel_blocks",
        toy_bricks((f.SAGE, f.TERRACOTTA, f.CREAM, _color(0.6, 0.7, 0.85))),
        "boxes",
        0.15,
        "toy blocks",
    ),
    _object("fork", "steel", cutlery("fork", 0.2, f.STEEL, f.STEEL), mass=0.05),
    _object("fork", "wood", cutlery("fork", 0.2, f.STEEL, f.WALNUT), mass=0.05),
    _object("knife", "wood", cutlery("knife", 0.22, f.STEEL, f.WALNUT), mass=0.08),
    _object("spoon", "steel", cutlery("spoon", 0.2, f.STEEL, f.STEEL), mass=0.05),
    _object("spoon", "red", cutlery("spoon", 0.24, f.STEEL, f.RED), mass=0.06),
    _object("pan", "black_frying", pan(0.12, 0.045, 0.17, f.DARK_STEEL, f.BLACK), "hollow", 0.9, "frying pan"),
    _object(
        "pan", "copper_frying", pan(0.1, 0.04, 0.16, _color(0.72, 0.42, 0.28), f.BRASS), "hollow", 0.8, "frying pan"
    ),
    _object("pot", "steel", pan(0.1, 0.11, 0.03, f.STEEL, f.BLACK, True), "hollow", 1.0, "cooking pot"),
    _object("pot", "red", pan(0.11, 0.1, 0.03, f.RED, f.STEEL, True), "hollow", 1.4, "cooking pot"),
    _object("pot", "saucepan", pan(0.08, 0.09, 0.15, f.STEEL, f.BLACK), "hollow", 0.7, "saucepan"),
    _object("basket", "round", basket(0.26, 0.26, 0.12, f.NATURAL_WICKER, True, False), "hollow", 0.3),
    _object("basket", "square", basket(0.3, 0.2, 0.13, f.DARK_WICKER, False, False), "boxes", 0.4),
    _object("basket", "handled", basket(0.14, 0.14, 0.08, f.WHITE_WICKER, True, True), "hull", 0.3),
    _object("laptop", "silver", laptop(0.32, 0.22, f.STEEL), mass=1.4, name="closed laptop"),
    _object("laptop", "black", laptop(0.34, 0.24, f.DARK_STEEL), mass=1.8, name="closed laptop"),
    _object("laptop", "blue", laptop(0.3, 0.21, f.NAVY), mass=1.2, name="closed laptop"),
    _object("keyboard", "black", keyboard(0.42, 0.14, f.BLACK, f.DARK_STEEL), mass=0.5),
    _object("keyboard", "white", keyboard(0.36, 0.13, f.STEEL, f.WHITE), mass=0.4),
    _object("computer_mouse", "black", mouse(f.DARK_STEEL), mass=0.1),
    _object("computer_mouse", "white", mouse(f.WHITE), mass=0.1),
    _object("apple", "red", fruit(0.04, 0.9, _color(0.75, 0.12, 0.12), True), mass=0.17),
    _object("apple", "green", fruit(0.039, 0.9, _color(0.55, 0.72, 0.22), True), mass=0.17),
    _object("orange", "plain", fruit(0.04, 0.97, f.speckled((0.95, 0.55, 0.12), 0.04), False), mass=0.17),
    _object("lemon", "plain", fruit(0.031, 1.25, f.speckled((0.95, 0.85, 0.2), 0.04), False), mass=0.1),
    _object("pear", "green", fruit(0.036, 1.2, _color(0.72, 0.76, 0.3), True, 0.45), mass=0.18),
    _object("tomato", "red", fruit(0.038, 0.8, _color(0.85, 0.16, 0.1), True), mass=0.15),
    _object("banana", "yellow", banana(_color(0.93, 0.8, 0.25)), mass=0.12),
    _object("carrot", "orange", carrot(), mass=0.08),
    _object("towel", "white", towel((0.3, 0.2, 0.09), f.cloth((0.93, 0.93, 0.92)), 3), mass=0.4),
    _object("towel", "blue", towel((0.28, 0.2, 0.08), f.cloth((0.35, 0.5, 0.68)), 3), mass=0.4),
    _object(
        "towel", "striped", towel((0.26, 0.18, 0.06), f.striped((0.9, 0.88, 0.84), (0.72, 0.4, 0.36)), 2), mass=0.3
    ),
    _object("toilet_paper", "roll", roll(0.055, 0.1, 0.02, f.WHITE, f.CARDBOARD), mass=0.1),
    _object(
        "toilet_paper",
        "large_roll",
        roll(0.065, 0.11, 0.02, f.speckled((0.95, 0.94, 0.92), 0.02), f.CARDBOARD),
        mass=0.15,
    ),
    _object("tape", "brown", roll(0.045, 0.05, 0.035, _color(0.62, 0.45, 0.25), f.CARDBOARD), mass=0.1),
    _object("rolling_pin", "pine", rolling_pin(0.42, 0.027, f.PINE), mass=0.5),
    _object("rolling_pin", "walnut", rolling_pin(0.38, 0.025, f.WALNUT), mass=0.5),
    _object("tray", "oak", tray(0.4, 0.28, 0.045, f.OAK), "boxes", 0.7),
    _object("tray", "white", tray(0.34, 0.24, 0.035, f.WHITE), "boxes", 0.5),
    _object("cutting_board", "oak", block((0.34, 0.22, 0.022), f.OAK, 0.12), mass=0.8),
    _object("cutting_board", "walnut", block((0.3, 0.2, 0.018), f.WALNUT, 0.12), mass=0.6),
    _object("potted_plant", "aloe", flower_pot(0.065, 0.2, f.TERRACOTTA, _color(0.35, 0.55, 0.3), 9), mass=0.7),
    _object("potted_plant", "grass", flower_pot(0.06, 0.26, f.WHITE, _color(0.3, 0.5, 0.22), 12), mass=0.6),
    _object(
        "picture_frame", "oak", frame(0.16, 0.21, f.OAK, _print((0.7, 0.8, 0.85), (0.3, 0.45, 0.35), 20)), mass=0.3
    ),
    _object(
        "picture_frame", "black", frame(0.2, 0.16, f.BLACK, _print((0.9, 0.75, 0.6), (0.5, 0.25, 0.3), 21)), mass=0.3
    ),
    _object("trophy", "gold", trophy(0.24), mass=0.8),
    _object("trophy", "small", trophy(0.18), mass=0.5),
    _object("toy_vehicle", "red_car", toy_car(f.RED, 0.18), mass=0.25, name="toy car"),
    _object("toy_vehicle", "yellow_truck", toy_car(_color(0.93, 0.75, 0.2), 0.24), mass=0.35, name="toy truck"),
    _object("wallet", "brown", wallet((0.11, 0.09, 0.022), f.speckled((0.42, 0.26, 0.16), 0.05)), mass=0.12),
    _object("wallet", "black", wallet((0.12, 0.09, 0.02), f.speckled((0.12, 0.12, 0.13), 0.08)), mass=0.12),
    _object("umbrella", "blue", umbrella(0.42, f.NAVY), mass=0.4),
    _object("umbrella", "red", umbrella(0.3, f.RED), mass=0.3),
    _object("lamp", "white_shade", lamp(0.32, 0.068, f.BRASS, f.CREAM), mass=0.8, name="table lamp"),
    _object("lamp", "blue_shade", lamp(0.28, 0.066, f.OAK, _color(0.35, 0.5, 0.65)), mass=0.7, name="table lamp"),
    _object("kettle", "white", kettle(0.065, 0.22, f.WHITE), mass=0.9),
    _object("kettle", "steel", kettle(0.06, 0.24, f.STEEL), mass=0.9),
    _object("cushion", "blue", block((0.42, 0.42, 0.13), f.cloth((0.30, 0.42, 0.62)), 0.55), mass=0.4),
    _object("cushion", "mustard", block((0.4, 0.4, 0.12), f.cloth((0.82, 0.64, 0.22)), 0.55), mass=0.4),
    _object(
        "cushion", "striped", block((0.45, 0.3, 0.12), f.striped((0.9, 0.88, 0.82), (0.4, 0.5, 0.46)), 0.55), mass=0.4
    ),
    _object("box", "cardboard_small", cuboid((0.24, 0.18, 0.12), f.CARDBOARD), mass=0.3, name="cardboard box"),
    _object("box", "cardboard_flat", cuboid((0.3, 0.22, 0.08), f.CARDBOARD), mass=0.3, name="cardboard box"),
    _object("box", "wooden", cuboid((0.2, 0.13, 0.1), f.CHERRY), mass=0.5, name="wooden box"),
    _object(
        "jar",
        "jam",
        turned(
            [(0, 0), (0.035, 0), (0.036, 0.07), (0.03, 0.078), (0.032, 0.078), (0.032, 0.095), (0, 0.095)],
            _color(0.55, 0.12, 0.16),
            f.BRASS,
            3,
        ),
        mass=0.4,
    ),
    _object(
        "jar",
        "honey",
        turned(
            [(0, 0), (0.04, 0), (0.041, 0.085), (0.033, 0.095), (0.036, 0.095), (0.036, 0.112), (0, 0.112)],
            _color(0.85, 0.58, 0.15),
            f.WHITE,
            3,
        ),
        mass=0.5,
    ),
    _object(
        "jar",
        "coffee",
        turned(
            [(0, 0), (0.042, 0), (0.042, 0.11), (0.036, 0.12), (0.038, 0.12), (0.038, 0.14), (0, 0.14)],
            _color(0.25, 0.16, 0.1),
            f.RED,
            3,
        ),
        mass=0.4,
    ),
    _object(
        "vase",
        "blue",
        vessel((0.045, 0.06, 0.066, 0.05, 0.032, 0.038), 0.24, 0.005, _color(0.2, 0.36, 0.58)),
        "hull",
        0.7,
    ),
    _object("vase", "terracotta", vessel((0.04, 0.055, 0.06, 0.05, 0.045), 0.18, 0.006, f.TERRACOTTA), "hull", 0.6),
    _object(
        "salt_and_pepper_shaker",
        "wood",
        turned([(0, 0), (0.025, 0), (0.022, 0.05), (0.014, 0.065), (0.02, 0.08), (0.012, 0.1), (0, 0.105)], f.WALNUT),
        mass=0.1,
    ),
    _object(
        "salt_and_pepper_shaker",
        "white",
        turned([(0, 0), (0.022, 0), (0.018, 0.06), (0.02, 0.06), (0.016, 0.078), (0, 0.08)], f.WHITE, f.STEEL, 3),
        mass=0.1,
    ),
    _object(
        "coaster",
        "cork",
        turned([(0, 0), (0.048, 0), (0.048, 0.008), (0, 0.008)], f.speckled((0.72, 0.54, 0.36), 0.08)),
        mass=0.03,
    ),
    _object("coaster", "slate", cuboid((0.1, 0.1, 0.008), f.GRANITE), mass=0.08),
    _object("lunch_box", "red", block((0.2, 0.14, 0.07), f.RED, 0.15), mass=0.3),
    _object("lunch_box", "blue", block((0.18, 0.12, 0.065), _color(0.25, 0.5, 0.75), 0.15), mass=0.3),
    _object("egg", "brown", fruit(0.022, 1.3, _color(0.82, 0.62, 0.46), False, 0.12), mass=0.06),
    _object("egg", "white", fruit(0.022, 1.3, _color(0.95, 0.93, 0.9), False, 0.12), mass=0.06),
)
