"""Plausible masses: an average density of the bounding box by category, within bounds."""

DENSITIES = {
    "receptacle": 110.0,
    "bathtub": 70.0,
    "bed": 35.0,
    "bench": 90.0,
    "chair": 45.0,
    "couch": 35.0,
    "hamper": 30.0,
    "serving_cart": 60.0,
    "shelves": 80.0,
    "shoe_rack": 60.0,
    "sink": 90.0,
    "stool": 50.0,
    "table": 40.0,
    "trunk": 90.0,
    "washer_dryer": 200.0,
    "plant": 30.0,
    "tv": 40.0,
    "curtain": 10.0,
    "decor": 120.0,
    "door": 350.0,
    "object": 250.0,
    "book": 700.0,
    "knife": 700.0,
    "fork": 500.0,
    "spoon": 500.0,
    "hammer": 700.0,
    "dumbbell": 2500.0,
    "plate": 700.0,
    "bowl": 250.0,
    "stuffed_toy": 60.0,
    "sponge": 60.0,
    "basketball": 75.0,
    "soccer_ball": 75.0,
    "hat": 40.0,
    "basket": 40.0,
    "box": 120.0,
    "bread": 250.0,
    "cushion": 60.0,
    "shoe": 120.0,
    "vase": 300.0,
    "plant_container": 200.0,
    "can": 900.0,
    "wine_bottle": 600.0,
    "bottle": 600.0,
}


def estimate_mass(role: str, category: str, size: tuple[float, ...]) -> float:
    """Return kg; graspable objects weigh between 10 g and 2.5 kg, furniture at least 2 kg."""
    volume = size[0] * size[1] * size[2]
    mass = DENSITIES.get(category, DENSITIES[role]) * volume
    low, high = (0.01, 2.5) if role == "object" else (2.0, 150.0)
    return round(min(max(mass, low), high), 3)
