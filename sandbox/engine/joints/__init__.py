"""Joints: what each kind holds (`kinds`), how strongly (`laws`), and the direct solver of a jointed part (`direct`)."""
