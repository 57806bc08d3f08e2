"""The figures of the UniTeam report (arXiv 2312.08611), drawn from runs of our agents."""
