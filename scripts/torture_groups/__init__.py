"""Groups of attacks on the tool; scripts/torture runs them."""
