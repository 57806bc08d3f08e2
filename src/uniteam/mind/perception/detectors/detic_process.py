"""Detic (Zhou et al. 2022) in a process of its own; run by the Python that has it, which need not be uniteam's.

It uses nothing of uniteam, and of Python nothing newer than 3.8. `detic` speaks with it through its standard input and
output: a question is a line of JSON, {"names", "height", "width"}, and the bytes of an RGB frame; an answer is a line
of JSON, {"scores", "classes", "shape"}, and the bits of its masks, or {"error"}.
"""

import json
import os
import sys
from importlib import import_module
from pathlib import Path
from typing import Any, BinaryIO, Dict, List, Tuple  # noqa: UP035 - for Python 3.8

import numpy as np

LEAST_SCORE = 0.1


class Detector:
    """Detic with a vocabulary that changes."""

    def __init__(self, settings: Dict[str, str]) -> None:  # noqa: UP006
        """Load the network.

        Args:
            settings: "detic" (folder of its repository), "config" and "weights" (files, relative to that folder or
                absolute) and "device".
        """
        here = str(Path(__file__).resolve().parent)  # Python puts it first, and it holds another module `detic`
        sys.path[:] = [path for path in sys.path if str(Path(path).resolve()) != here]
        sys.path[:0] = [settings["detic"], str(Path(settings["detic"]) / "third_party" / "CenterNet2")]
        os.chdir(settings["detic"])
        configuration = import_module("detectron2.config").get_cfg()
        import_module("centernet.config").add_centernet_config(configuration)
        import_module("detic.config").add_detic_config(configuration)
        configuration.merge_from_file(settings["config"])
        configuration.MODEL.WEIGHTS = settings["weights"]
        configuration.MODEL.DEVICE = settings["device"]
        configuration.MODEL.ROI_HEADS.SCORE_THRESH_TEST = LEAST_SCORE
        configuration.MODEL.ROI_HEADS.ONE_CLASS_PER_PROPOSAL = True
        configuration.MODEL.ROI_BOX_HEAD.ZEROSHOT_WEIGHT_PATH = "rand"  # the vocabulary comes with the questions
        self._predictor = import_module("detectron2.engine").DefaultPredictor(configuration)
        self._encoder = import_module("detic.modeling.text.text_encoder").build_text_encoder(pretrain=True)
        self._encoder.eval()
        self._names: List[str] = []  # noqa: UP006

    def detect(self, rgb: Any, names: List[str]) -> Tuple[Dict[str, Any], bytes]:  # noqa: UP006
        """Return what is found in an (H, W, 3) frame of the names: the answer's line, and its masks as bits."""
        if names != self._names:
            texts = self._encoder(["a " + name for name in names])
            classifier = texts.detach().permute(1, 0).contiguous().cpu()
            import_module("detic.modeling.utils").reset_cls_test(self._predictor.model, classifier, len(names))
            self._names = names
        instances = self._predictor(np.ascontiguousarray(rgb[:, :, ::-1]))["instances"].to("cpu")
        masks = np.asarray(instances.pred_masks, dtype=bool).reshape(-1, *rgb.shape[:2])
        answer = {
            "scores": [float(score) for score in instances.scores],
            "classes": [int(index) for index in instances.pred_classes],
            "shape": list(masks.shape),
        }
        return answer, np.packbits(masks).tobytes()


def main() -> None:
    """Answer questions until the input ends."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print is no answer
    try:
        detector = Detector(json.loads(sys.argv[1]))
    except Exception as error:
        _send(answers, {"error": "{}: {}".format(type(error).__name__, error)}, b"")  # noqa: UP032
        raise
    _send(answers, {"ready": True}, b"")
    while True:
        line = sys.stdin.buffer.readline()
        if not line:
            return
        question = json.loads(line)
        shape = (question["height"], question["width"], 3)
        rgb = np.frombuffer(sys.stdin.buffer.read(int(np.prod(shape))), np.uint8).reshape(shape)
        try:
            _send(answers, *detector.detect(rgb, question["names"]))
        except Exception as error:
            _send(answers, {"error": "{}: {}".format(type(error).__name__, error)}, b"")  # noqa: UP032


def _send(answers: BinaryIO, head: Dict[str, Any], body: bytes) -> None:  # noqa: UP006
    answers.write(json.dumps(head).encode() + b"\n" + body)
    answers.flush()


if __name__ == "__main__":
    main()
