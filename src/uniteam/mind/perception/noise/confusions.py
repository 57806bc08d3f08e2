"""What is taken for what: groups of names whose things look alike to a detector; a name may be in several."""

LOOK_ALIKES = (
    # receptacles, and large furniture that is taken for them
    ("table", "counter", "bench", "stand", "chest_of_drawers", "serving_cart"),
    ("chest_of_drawers", "cabinet", "filing_cabinet", "wardrobe", "stand", "trunk", "upper_cabinet", "crib"),
    ("cabinet", "shelves", "wardrobe", "shoe_rack", "refrigerator", "upper_cabinet", "door"),
    ("chair", "stool", "bench", "couch", "stand"),
    ("couch", "bed", "bench", "chair", "crib"),
    ("bathtub", "sink", "toilet", "shower"),
    ("counter", "sink", "cabinet", "washer_dryer", "oven", "dishwasher"),
    ("washer_dryer", "dishwasher", "oven", "hamper", "microwave"),
    ("hamper", "trunk", "basket", "trash_can", "stool"),
    ("shoe_rack", "shelves", "stand", "clothes_rack", "towel_rack", "serving_cart"),
    # what one drinks from and pours from
    ("cup", "glass", "wineglass", "bowl", "jar", "can", "candle", "utensil_holder"),
    ("bowl", "pot", "pan", "plate", "ashtray", "basket", "tray"),
    ("pitcher", "kettle", "teapot", "coffee_press", "moka_pot", "vase", "coffee_maker"),
    ("bottle", "wine_bottle", "baby_bottle", "spray_bottle", "shampoo", "soap_dispenser", "perfume", "medicine_bottle"),
    ("can", "canister", "jar", "candle", "salt_and_pepper_shaker", "medicine_bottle", "speaker", "camera"),
    ("vase", "jar", "bottle", "statue", "trophy", "lantern", "table_lamp", "lamp"),
    ("plate", "cutting_board", "tray", "coaster", "clock", "scale"),
    # boxes, books and things with screens
    ("box", "gift_box", "cereal_box", "tissue_box", "milk_carton", "lunch_box", "board_game", "file_sorter", "radio"),
    ("book", "notebook", "newspaper", "tablet", "picture_frame", "calendar", "laptop", "wallet"),
    ("laptop", "tablet", "keyboard", "monitor", "tv", "picture_frame", "game_console"),
    ("cellphone", "remote_control", "telephone", "wallet", "computer_mouse", "game_controller", "stapler", "soap_bar"),
    ("toaster", "sandwich_maker", "microwave", "blender", "mixer", "citrus_juicer", "printer", "radio", "coffee_maker"),
    # long thin things
    ("pen", "marker", "brush", "comb", "toilet_brush", "lipstick", "flashlight", "ruler", "carrot"),
    ("fork", "knife", "spoon", "spatula", "ladle", "rolling_pin", "knife_block"),
    ("hammer", "screwdriver", "pliers", "saw", "drill", "scissors", "stapler", "umbrella"),
    # food
    ("apple", "orange", "lemon", "pear", "tomato", "ball", "egg", "bread"),
    ("banana", "carrot", "hot_dog", "french_fries", "bread", "lemon"),
    ("cake", "cupcake", "hamburger", "bread", "butter", "sponge", "steak", "roasted_chicken"),
    # cloth and what is soft
    ("towel", "folded_clothes", "cushion", "sock", "glove", "hat", "backpack"),
    ("handbag", "backpack", "briefcase", "basket", "lunch_box", "pencil_case"),
    ("shoe", "sock", "glove", "hat", "toy_vehicle"),
    ("toilet_paper", "paper_towel", "tape", "candle", "sponge", "soap_bar"),
    # toys, ornaments, plants
    ("stuffed_toy", "doll", "action_figure", "statue", "trophy", "toy_airplane"),
    ("toy_vehicle", "toy_airplane", "toy_construction_set", "action_figure", "game_controller", "xylophone"),
    ("die", "puzzle_cube", "box", "toy_construction_set", "gift_box", "salt_and_pepper_shaker"),
    ("potted_plant", "plant", "vase", "christmas_tree", "basket"),
    ("watch", "keys", "spectacles", "coaster", "wallet", "tape"),
    ("dumbbell", "kettle", "telephone", "table_tennis_paddle", "hammer"),
)


def look_alikes(name: str) -> tuple[str, ...]:
    """Return the names that a thing of a name is taken for, sorted; none where it is in no group."""
    return tuple(sorted({other for group in LOOK_ALIKES if name in group for other in group} - {name}))
