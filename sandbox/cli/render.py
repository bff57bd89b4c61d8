"""`sandbox render`: a scene or a recording as a picture, a film or a page, without a display and OpenGL."""

from __future__ import annotations

from sandbox.cli.options import takes
from sandbox.cli.render_options import RenderOptions
from sandbox.cli.running import telling_refusals

STILLS, FILMS, PAGE = (".png", ".svg"), (".gif", ".mp4", ".webm"), ".html"


@takes(RenderOptions)
def render(options: RenderOptions) -> None:
    """Draw a scene or a recording: a picture (PNG, SVG), a film (GIF, MP4, WebM), or a page that plays offline (HTML).

    Needs no display and no OpenGL. MP4 and WebM need the package av.
    """
    from sandbox.cli.picture_options import writable_picture
    from sandbox.cli.render_page import write_page
    from sandbox.cli.render_pictures import write_film, write_still

    suffix = writable_picture(options.output, (*STILLS, *FILMS, PAGE), [options.scene])
    with telling_refusals(options.scene):
        if suffix == PAGE:
            write_page(options)
        elif suffix in STILLS:
            write_still(options, suffix)
        else:
            write_film(options, suffix)
