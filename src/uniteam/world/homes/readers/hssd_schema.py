"""The JSON files of HSSD and of the challenge's objects, as far as they are read; the rest is passed over."""

from typing import Annotated, Any

import msgspec

Three = tuple[float, float, float]
Four = tuple[float, float, float, float]
Scale = Annotated[float, msgspec.Meta(gt=0.0, le=1000.0)]


class ObjectConfig(msgspec.Struct):
    """`*.object_config.json`: a model, its files by their paths from its own folder.

    Attributes:
        render_asset, collision_asset: glTF binaries.
        mass: kg.
        center_of_mass: in the file's frame before `scale`; the middle of the bounding box where it is left out.
        scale: along the file's axes.
        is_collidable: whether it can be touched.
        use_bounding_box_for_collision: whether it collides as the box around it.
        user_defined: among others the receptacles: `receptacle_mesh_*` and `receptacle_aabb_*`.
    """

    render_asset: str
    collision_asset: str | None = None
    mass: Annotated[float, msgspec.Meta(ge=0.0)] | None = None
    center_of_mass: Three | None = msgspec.field(default=None, name="COM")
    scale: tuple[Scale, Scale, Scale] | None = None
    is_collidable: bool = True
    use_bounding_box_for_collision: bool = False
    user_defined: dict[str, Any] = {}


class ReceptacleData(msgspec.Struct):
    """A receptacle of an object: a box of half extents `scale`, or a mesh, in the object's frame; y is up."""

    position: Three = (0.0, 0.0, 0.0)
    rotation: Four = (1.0, 0.0, 0.0, 0.0)
    scale: Three = (1.0, 1.0, 1.0)
    mesh_filepath: str | None = None


class StageConfig(msgspec.Struct):
    """`*.stage_config.json`."""

    render_asset: str


class StageInstance(msgspec.Struct):
    """Which stage, and where: by itself at the origin."""

    template_name: str
    translation: Three = (0.0, 0.0, 0.0)
    rotation: Four = (1.0, 0.0, 0.0, 0.0)


class ObjectInstance(msgspec.Struct):
    """A model that stands in a scene: scaled, rotated (w, x, y, z), translated.

    `translation_origin` "asset_local" says that the file's origin is what is translated, "COM" the centre of mass.
    """

    template_name: str
    translation: Three = (0.0, 0.0, 0.0)
    rotation: Four = (1.0, 0.0, 0.0, 0.0)
    non_uniform_scale: Three | None = None
    uniform_scale: Scale = 1.0
    translation_origin: str | None = None


class SceneInstance(msgspec.Struct):
    """`*.scene_instance.json`: one home."""

    stage_instance: StageInstance
    object_instances: list[ObjectInstance] = []
    articulated_object_instances: list[Any] = []
    translation_origin: str = "asset_local"


class Region(msgspec.Struct):
    """A room: its outline on the floor, and from where to where it reaches up."""

    poly_loop: list[Three]
    name: str = ""
    label: str = ""
    floor_height: float = 0.0
    extrusion_height: float = 0.0


class SemanticConfig(msgspec.Struct):
    """`<id>.semantic_config.json`."""

    region_annotations: list[Region] = []
