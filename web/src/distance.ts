// How near the car is to the nearest thing.
import type { Scene } from "snug";
import type { Point } from "./geometry";

export interface Obstacle {
    corners: Point[];
    low: boolean;
    name: string;
}

export const obstaclesOf = (scene: Scene): Obstacle[] =>
    scene.obstacles.map((one, i) => {
        const { polygon, low = false, name = "" } = Array.isArray(one) ? { polygon: one } : one;
        return { corners: polygon.map(([x, y]) => ({ x, y })), low, name: name.slice(0, 40) || `obstacle ${i}` };
    });

/** From a point to the line between two others, squared. */
function apart(p: Point, a: Point, b: Point) {
    const [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, p.x - a.x, p.y - a.y];
    const long = ux * ux + uy * uy;
    const t = long > 0 ? Math.min(Math.max((ux * vx + uy * vy) / long, 0), 1) : 0;
    return (vx - t * ux) ** 2 + (vy - t * uy) ** 2;
}

/** Between two polygons that do not overlap: a corner of one is nearest to an edge of the other. */
function between(one: Point[], other: Point[]) {
    let least = Infinity;
    for (const [points, edges] of [[one, other], [other, one]] as const)
        for (const p of points) for (let i = 0; i < edges.length; ++i) least = Math.min(least, apart(p, edges[i]!, edges[(i + 1) % edges.length]!));
    return Math.sqrt(least);
}

/** `wheels`: what a low curb stops. */
export function nearest(body: Point[], wheels: Point[], obstacles: Obstacle[]): { distance: number; name: string } | null {
    let found: { distance: number; name: string } | null = null;
    for (const { corners, low, name } of obstacles) {
        const distance = between(low ? wheels : body, corners);
        if (!found || distance < found.distance) found = { distance, name };
    }
    return found;
}
