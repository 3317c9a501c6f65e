/** What there is to see, as coordinates: the cloud or, of a bare table, the surface's vertices. */
export function shownPositions({ cloud, surface }) {
  return cloud.count === 0 && surface ? surface.positions : cloud.positions;
}
