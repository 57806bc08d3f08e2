"""From what is seen to what it is: the kinds of perception, and which detections to believe."""
