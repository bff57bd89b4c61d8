"""The part of the window in which the scene is seen: where it lies, and through which camera one looks."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sandbox.render.camera import Camera, Size, Vec, fit, scene_camera
from sandbox.render.follow import followed
from sandbox.render.frame import Frame
from sandbox.window.session import Session

Rect = tuple[int, int, int, int]
"""Left, top, width, height in pixels of the window."""
ZOOM_A_NOTCH = 1.15
USUAL_ASPECT = 1.6
"""Width to height of the picture that a scene's `view` is made for."""


@dataclass
class Viewport:
    """A camera and the rectangle it fills."""

    rect: Rect
    camera: Camera
    touched: bool = False
    """True once the user has chosen the view; until then it follows the window."""
    follow: str | None = None
    """The id of the body that it goes along with, or "moving"."""
    home: Camera | None = None
    """What is looked through where nothing is followed: it says how much is seen."""

    @classmethod
    def of(cls, session: Session, size: Size) -> Viewport:
        """All of a window of `size` pixels, looking as the scene asks for."""
        camera = _home(session, size)
        return cls((0, 0, *size), camera, follow=getattr(session.scene.view, "follow", None), home=camera)

    def place(self, rect: Rect, session: Session) -> None:
        """Lie at `rect` from now on."""
        size = rect[2], rect[3]
        if size != self.camera.size:
            self.camera = self.camera.resized(size) if self.touched else _home(session, size)
            self.home = self.camera
        self.rect = rect

    def local(self, pixel: Vec) -> Vec:
        """A pixel of the window as one of the viewport."""
        return pixel[0] - self.rect[0], pixel[1] - self.rect[1]

    def holds(self, pixel: Vec) -> bool:
        """Whether a pixel of the window lies in it."""
        x, y = self.local(pixel)
        return 0 <= x < self.rect[2] and 0 <= y < self.rect[3]

    def point(self, pixel: Vec) -> Vec:
        """The point of the plane, in metres, under a pixel of the window."""
        return self.camera.point(self.local(pixel))

    def pixel(self, point: Vec) -> Vec:
        """The pixel of the window over a point of the plane."""
        x, y = self.camera.to_screen(point)
        return float(x) + self.rect[0], float(y) + self.rect[1]

    def go_along(self, frame: Frame, seconds: float | None) -> None:
        """Follow what is to be followed, `seconds` after the picture before; None is there at once."""
        if self.follow is not None:
            self.camera = followed(self.camera, frame, self.follow, self.home or self.camera, seconds)

    def set_follow(self, target: str | None) -> None:
        """Follow another body, "moving", or nothing, with as much in sight as now."""
        self.follow, self.home = target, self.camera

    def pan(self, dx: float, dy: float) -> None:
        """Move the picture by pixels; nothing is followed any more."""
        self.follow = None
        self.camera = self.camera.panned(dx, dy)
        self.touched = True

    def zoom(self, factor: float, pixel: Vec | None = None) -> None:
        """Zoom about a pixel of the window, or about the middle."""
        about = (self.rect[2] / 2, self.rect[3] / 2) if pixel is None else self.local(pixel)
        self.camera = self.camera.zoomed(factor, about)
        self.home = self.camera
        self.touched = True

    def fit(self, session: Session) -> None:
        """Show all that there is to see now; nothing is followed any more."""
        self.follow = None
        self.camera = fit(session.bounds(), self.camera.size)
        self.touched = True

    def center_on(self, point: Vec) -> None:
        """Bring a point of the plane (m) into the middle."""
        self.camera = replace(self.camera, center=point)
        self.touched = True

    def look_home(self, session: Session) -> None:
        """Look as the scene asks for."""
        self.follow = getattr(session.scene.view, "follow", None)
        self.home = _home(session, self.camera.size)
        self.camera, self.touched = _home(session, self.camera.size), False


def _home(session: Session, size: Size) -> Camera:
    """As the scene asks, but at least as wide as in a picture of `USUAL_ASPECT`: panels take from the width."""
    camera = scene_camera(session.scene.view, session.home, size)
    if getattr(session.scene.view, "height", None) is None or size[0] >= USUAL_ASPECT * size[1]:
        return camera
    return replace(camera, scale=camera.scale * size[0] / (USUAL_ASPECT * size[1]))
