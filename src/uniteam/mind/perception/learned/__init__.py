"""From pixels and words to detections: the networks that the package ships, and what is around them."""
