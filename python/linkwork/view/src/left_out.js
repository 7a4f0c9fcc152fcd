// What a page of a large mechanism does not have or does not draw, in words.

import { FRAMES, PATHS } from "./world.js";

/** Phrases; none of a small mechanism. */
export function leftOut(run, world, overlay) {
  const found = [];
  const { bodyCount: n, jointCount: joints } = run;
  const plotted = [[run.bodies.plotted.length, n, "bodies"], [run.joints.plotted.length, joints, "joints"]].filter(([some, all]) => some < all);
  if (plotted.length && !run.still) found.push(`plots of ${plotted.map(([some, all, what]) => `${some} of ${all} ${what}`).join(", ")}`);
  if (run.coordinates.length && run.coordinates.length < joints && run.joints.plotted.length > run.coordinates.length) found.push(`coordinates of ${run.coordinates.length} joints`);
  if (run.unmarked) found.push(`marks of all events but the last ${run.unmarked}`);
  const seen = world.figures[0].seen;
  if (seen && seen.lines + seen.smaller + seen.outside > 0) found.push(`drawn: ${said(seen)}`);
  if (world.crowded && world.shown.paths && !run.still) found.push(`paths of ${Math.min(PATHS, n)} bodies`);
  if (world.shown.axes && n > FRAMES) found.push(`axes of the first ${FRAMES} bodies`);
  if (overlay.named < overlay.asked) found.push(`${overlay.named} of ${overlay.asked} names`);
  return found;
}

/** Solids of bodies by what one sees of them; dots are those of their bodies. */
function said({ shapes, boxes, lines, smaller, outside }) {
  const parts = [[shapes, "as shapes"], [boxes, "as boxes"], [lines, "as lines"], [smaller, "as dots"], [outside, "out of the picture"]];
  return parts.filter(([count]) => count > 0).map(([count, how]) => `${count} ${how}`).join(", ");
}
