"""Impacts with restitution on bodies that joints hold together."""
