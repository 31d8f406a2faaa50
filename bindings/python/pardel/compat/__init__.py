"""Modules for programs that were written for other packages: one import changes, and pardel makes their meshes."""
