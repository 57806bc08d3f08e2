"""`uniteam serve-perception`: a perception for agents on other machines."""

import os
from typing import Annotated

import tyro

import uniteam
from uniteam.cli.perceptions import perception_name
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.mind.perception.detectors.remote import TOKEN
from uniteam.mind.perception.perception_server import PerceptionServer

LOOPBACK = ("127.0.0.1", "localhost", "::1")


def serve_perception(
    perception: Annotated[str, tyro.conf.Positional, tyro.conf.arg(metavar="NAME")],
    model: Annotated[str | None, tyro.conf.arg(metavar="ORG/NAME")] = None,
    revision: Annotated[str | None, tyro.conf.arg(metavar="R")] = None,
    host: str = "127.0.0.1",
    port: Annotated[int, tyro.conf.arg(metavar="N")] = 8712,
) -> None:
    """Serve a perception over HTTP, until Ctrl-C, to agents that are given it as remote:http://HOST:PORT.

    Frames go over the network as they are, and whoever reaches the port can have frames looked at. Serve to other
    machines through an SSH tunnel, or set the environment variable UNITEAM_TOKEN to the same secret on both of them.

    Args:
        perception: What to serve: a name, or your own as MODULE:ATTRIBUTE; not one that needs the truth.
        model: The weights of a detector: ORG/NAME on the Hugging Face hub, or a folder.
        revision: Which commit of the model.
        host: The address to listen at; 0.0.0.0 for all of this machine's.
        port: The port to listen at; 0 for any that is free.
    """
    if not 0 <= port <= 65_535:
        raise InvalidInputError(f"--port must be from 0 to 65535, got {port}")
    console, token = make_console(), os.environ.get(TOKEN, "")
    name = perception_name(perception, model, revision)
    with console.status(f"loading {shown(name)}"):
        try:
            server = PerceptionServer((host, port), name, uniteam.__version__, token)
        except OSError as error:
            raise UnavailableError(
                f"{host}:{port} cannot be listened at ({error.strerror or error}); choose another --host or --port"
            ) from error
    with server:
        if host not in LOOPBACK and not token:
            console.print(f"[yellow]Anybody who reaches {shown(host)} can use this; set {TOKEN} to a secret.[/]")
        console.print(f"Serving {shown(name)}: --perception remote:{shown(server.url)}", soft_wrap=True)
        server.serve_forever()
