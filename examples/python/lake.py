"""Meshes a lake with islands for a model of its currents. The shore is GeoJSON in degrees, as maps have it; lengths and
angles need a plane, so it is projected to metres first. With pyproj, `Transformer.transform` does the same for any
system, and with GeoPandas `frame.to_crs(frame.estimate_utm_crs())`.

    python3 lake.py [FILE.gr3]
"""

import sys

import numpy as np

import pardel

CENTRE = (9.4, 47.6)  # longitude and latitude in degrees
SHORE, ISLAND = 1, 2  # markers


def ring(centre, radii, waves, count):
    """A closed ring around a place, in degrees; `waves` makes bays."""
    t = np.append(np.arange(count), 0) * 2 * np.pi / count
    r = 1 + 0.12 * np.sin(waves * t) + 0.05 * np.cos(3 * waves * t)
    return np.column_stack([centre[0] + radii[0] * r * np.cos(t), centre[1] + radii[1] * r * np.sin(t)]).tolist()


def lake():
    """The features of a map: the lake with its islands as holes, their shores, and a river that flows in."""
    outline = ring(CENTRE, (0.18, 0.05), 5, 240)
    islands = [ring((9.34, 47.605), (0.012, 0.006), 2, 48), ring((9.47, 47.59), (0.006, 0.004), 3, 32)]
    shapes = [({"type": "MultiLineString", "coordinates": islands}, {"marker": ISLAND, "length": 120}),
              ({"type": "Polygon", "coordinates": [outline, *islands]}, {"marker": SHORE}),  # the first marker counts
              ({"type": "Point", "coordinates": outline[0]}, {"length": 40, "name": "mouth of the river"})]
    return {"type": "FeatureCollection",
            "features": [{"type": "Feature", "geometry": shape, "properties": known} for shape, known in shapes]}


def projected(coordinates):
    """Metres to the east and to the north of the centre, on the ellipsoid WGS 84; for a few tens of kilometres."""
    if isinstance(coordinates[0], (list, tuple)):
        return [projected(each) for each in coordinates]
    radius, flattening = 6378137.0, 1 / 298.257223563
    squared = flattening * (2 - flattening)
    latitude = np.radians(CENTRE[1])
    bent = 1 - squared * np.sin(latitude) ** 2
    east = np.radians(coordinates[0] - CENTRE[0]) * np.cos(np.radians(coordinates[1])) * radius / np.sqrt(bent)
    north = np.radians(coordinates[1] - CENTRE[1]) * radius * (1 - squared) / bent**1.5
    return [float(east), float(north)]


def in_metres(collection):
    """The same features, projected."""
    return {**collection, "features": [
        {**each, "geometry": {**each["geometry"], "coordinates": projected(each["geometry"]["coordinates"])}}
        for each in collection["features"]]}


def main(arguments):
    features = in_metres(lake())
    bounds = dict(min_angle=30, max_edge=800, sources=features, grading=0.15)  # lengths are properties of features
    mesh = pardel.mesh(features, **bounds)
    certificate = pardel.check(features, mesh, **bounds)
    extremes = certificate.extremes
    print(f"{len(mesh.points)} points, {len(mesh.triangles)} triangles; right: {certificate.valid}")
    print(f"{mesh.area() / 1e6:.2f} square kilometres of water, {len(mesh.domain.holes)} islands")
    print(" and ".join(f"{np.sum(mesh.segment_markers == marker)} edges on the {name}"
                       for marker, name in ((SHORE, "shore"), (ISLAND, "islands"))))
    print(f"edges from {extremes['min_edge'].value:.0f} to {extremes['max_edge'].value:.0f} metres, angles from "
          f"{extremes['min_angle'].value:.1f} degrees")
    if arguments:
        mesh.save(arguments[0])


if __name__ == "__main__":
    main(sys.argv[1:])
