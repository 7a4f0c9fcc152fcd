"""Describing a mechanism: bodies, joints, forces, shapes, and the files that hold them."""
