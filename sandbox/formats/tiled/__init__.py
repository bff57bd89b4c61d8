"""Maps of Tiled: JSON (.tmj, .json) and XML (.tmx), with tilesets inside and beside them."""
