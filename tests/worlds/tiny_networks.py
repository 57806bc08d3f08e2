"""Networks of transformers with a few random weights, saved as real ones are: the whole path without a download."""

from pathlib import Path
from typing import Any

WORDS = ("a", "photo", "of", "cup", "table", "bed", "chest", "drawers", "counter", "couch", "die", "stand", "bottle")


def tokenizer(length: int) -> Any:
    """Return a tokenizer of whole words; the highest id is the end's, as OWLv2 needs it."""
    from tokenizers import Tokenizer, models, pre_tokenizers, processors
    from transformers import PreTrainedTokenizerFast

    special = ("[PAD]", "[UNK]", "[CLS]", "[SEP]", ".", "?")
    names = (*special, *WORDS, "[END]")
    plain = Tokenizer(models.WordLevel({name: k for k, name in enumerate(names)}, unk_token="[UNK]"))
    plain.pre_tokenizer = pre_tokenizers.BertPreTokenizer()
    plain.post_processor = processors.TemplateProcessing(
        single="[CLS] $A [SEP]", special_tokens=[("[CLS]", 2), ("[SEP]", 3)]
    )
    return PreTrainedTokenizerFast(
        tokenizer_object=plain, pad_token="[PAD]", unk_token="[UNK]", cls_token="[CLS]", sep_token="[SEP]",
        model_max_length=length,
    )  # fmt: skip


def save_owlv2(folder: Path) -> Path:
    """Write an OWLv2 of one layer and its processor into a folder, and return it."""
    import torch
    from transformers import Owlv2Config, Owlv2ForObjectDetection, Owlv2ImageProcessor, Owlv2Processor

    torch.manual_seed(0)
    small = {"hidden_size": 16, "intermediate_size": 16, "num_hidden_layers": 1, "num_attention_heads": 2}
    config = Owlv2Config(
        text_config={
            **small,
            "vocab_size": 64,
            "max_position_embeddings": 16,
            "eos_token_id": 3,
            "pad_token_id": 0,
            "bos_token_id": 2,
        },
        vision_config={**small, "image_size": 64, "patch_size": 16},
        projection_dim=16,
    )
    model = Owlv2ForObjectDetection(config).eval()
    with torch.no_grad():  # boxes of a third of the frame, at their patches, instead of specks in its corners
        model.box_head.dense2.weight.zero_()
        model.box_head.dense2.bias.copy_(torch.tensor([0.0, 0.0, 0.5, 0.5]))
    model.save_pretrained(folder)
    images = Owlv2ImageProcessor(size={"height": 64, "width": 64})
    Owlv2Processor(image_processor=images, tokenizer=tokenizer(16)).save_pretrained(folder)
    return folder
