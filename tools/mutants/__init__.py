"""Lists of small faults that the tests must notice; `tools/mutate.py` puts each in and runs the tests."""
