"""Colours of the material names that Java 3D knows without a material file, as near as a plain diffuse colour comes."""

Color = tuple[float, float, float]

NEUTRAL: Color = (0.72, 0.70, 0.67)

_COLORS: dict[str, Color] = {
    "amber": (0.85, 0.55, 0.15),
    "archwhite": (0.93, 0.93, 0.90),
    "archwhite2": (0.93, 0.93, 0.90),
    "black": (0.08, 0.08, 0.08),
    "bluegrey": (0.45, 0.52, 0.60),
    "bluteal": (0.15, 0.40, 0.50),
    "bone": (0.88, 0.84, 0.72),
    "bone2": (0.88, 0.84, 0.72),
    "brown": (0.42, 0.26, 0.14),
    "brzskin": (0.70, 0.48, 0.35),
    "dkblue": (0.10, 0.15, 0.45),
    "dkdkgrey": (0.18, 0.18, 0.18),
    "dkgrey": (0.32, 0.32, 0.32),
    "dkred": (0.45, 0.08, 0.08),
    "flblack": (0.08, 0.08, 0.08),
    "flblonde": (0.85, 0.72, 0.50),
    "flbrown": (0.45, 0.29, 0.16),
    "fldkdkgrey": (0.18, 0.18, 0.18),
    "fldkgrey": (0.30, 0.30, 0.30),
    "flesh": (0.88, 0.68, 0.55),
    "flgrey": (0.55, 0.55, 0.55),
    "flltbrown": (0.62, 0.45, 0.28),
    "flltgrey": (0.75, 0.75, 0.75),
    "florange": (0.90, 0.50, 0.12),
    "fltan": (0.80, 0.68, 0.50),
    "flwhite": (0.95, 0.95, 0.95),
    "flwhite1": (0.95, 0.95, 0.95),
    "flyellow": (0.92, 0.82, 0.35),
    "grey": (0.50, 0.50, 0.50),
    "iris": (0.40, 0.45, 0.65),
    "jetflame": (0.90, 0.45, 0.15),
    "lavendar": (0.70, 0.62, 0.82),
    "lighttan": (0.84, 0.74, 0.58),
    "ltgrey": (0.72, 0.72, 0.72),
    "offwhite.warm": (0.94, 0.91, 0.84),
    "red": (0.75, 0.12, 0.10),
    "redwood": (0.48, 0.22, 0.14),
    "ruby": (0.60, 0.08, 0.15),
    "sand_stone": (0.78, 0.68, 0.52),
    "ship2": (0.45, 0.45, 0.48),
    "silver": (0.76, 0.77, 0.78),
    "sky_blue": (0.55, 0.75, 0.90),
    "tan": (0.80, 0.68, 0.50),
    "teeth": (0.95, 0.93, 0.86),
    "white": (0.96, 0.96, 0.96),
    "yellow": (0.92, 0.82, 0.15),
    "yellow_green": (0.55, 0.68, 0.25),
    "yellowbrt": (0.96, 0.86, 0.10),
}


def builtin_color(name: str) -> Color:
    """Return the colour of a material name, or a neutral one where the name says nothing."""
    name = name.split(".0")[0]
    return _COLORS.get(name, _COLORS.get(name.rstrip("0123456789").removesuffix("new"), NEUTRAL))
