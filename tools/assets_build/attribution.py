"""The file that thanks everyone whose models and textures the pack holds."""

from collections import defaultdict
from collections.abc import Mapping
from typing import Any

LICENCES = {
    "CC0-1.0": ("Creative Commons Zero 1.0", "https://creativecommons.org/publicdomain/zero/1.0/"),
    "CC-BY-3.0": ("Creative Commons Attribution 3.0", "https://creativecommons.org/licenses/by/3.0/"),
    "CC-BY-3.0-US": (
        "Creative Commons Attribution 3.0 United States",
        "https://creativecommons.org/licenses/by/3.0/us/",
    ),
    "BSD-3-Clause-Clear": ("BSD 3-Clause Clear", "https://spdx.org/licenses/BSD-3-Clause-Clear.html"),
}

_HEAD = """# Who made the models and textures of this pack

Every model was converted for this pack: scaled to its real size, turned to one frame, reduced to fewer triangles, its
textures made smaller and opaque, and given collision shapes and support surfaces. Some were scaled down or recoloured.
The creators named here do not endorse that. The models of the Sweet Home 3D libraries were gathered and converted to
OBJ by Emmanuel Puybaret / eTeks (http://www.sweethome3d.com); those of the library Scopia are by Scopia Visual
Interfaces Systems, s.l. (http://www.scopia.es), those of the library KatorLegaz by Andrew Kator and Jennifer Legaz,
those of the BlendSwap libraries by the artists named, who published them on Blend Swap.
"""


def attribution_text(models: list[dict[str, Any]], textures: Mapping[str, Mapping[str, Any]], robot: str) -> str:
    """Return the Markdown of the attribution file: by licence, source and creator, every title with its identifier."""
    lines = [_HEAD]
    groups: defaultdict[tuple[str, str, str], list[str]] = defaultdict(list)
    for m in models:
        groups[m["licence"], m["source"], m["creator"]].append(f"{m['name']} (`{m['source_id']}`)")
    for name, t in textures.items():
        groups[t["licence"], t["source"], t["creator"]].append(f"texture {t['title']} (`{name}`)")
    for licence in sorted({key[0] for key in groups}):
        title, address = LICENCES[licence]
        lines.append(f"\n## {title} ({licence})\n\n<{address}>\n")
        for key in sorted(k for k in groups if k[0] == licence):
            lines.append(f"- **{key[2]}**, {key[1]}: " + "; ".join(sorted(groups[key])))
    return "\n".join(lines) + "\n" + robot
