"""Sweeps: tables of many runs."""
