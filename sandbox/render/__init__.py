"""From a world to pictures: camera, theme, frames, the draw list and the painters that read it."""
