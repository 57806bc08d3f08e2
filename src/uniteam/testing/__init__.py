"""Checks for what you bring: does an agent, a perception, a home or a body keep what its interface promises?

Each check returns nothing where all is well, and raises `CheckFailedError` with one sentence where something is not:
what differed, and at which step. They need no test framework, and are as easily called in one:

    from uniteam.testing import check_agent, check_perception

    def test_my_agent() -> None:
        check_agent("my_package.my_agent:MyAgent")

    def test_my_perception() -> None:
        check_perception("my_package.my_eyes:MyDetector")
"""

from uniteam.testing.agent import check_agent
from uniteam.testing.body import check_body
from uniteam.testing.failure import CheckFailedError
from uniteam.testing.home import check_home
from uniteam.testing.perception import check_perception

__all__ = ["CheckFailedError", "check_agent", "check_body", "check_home", "check_perception"]
