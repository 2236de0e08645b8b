// Where a car is along its maneuver. Everything here is in the slot's frame: the front corner at (0, 0), x along the road,
// y towards it; a slot on the left is the mirror image, so that every slot is [-length, 0] x [-width, 0].
import type { Car, Maneuver, Pose, SlotLike } from "snug";

export interface Point {
    x: number;
    y: number;
}

/** What of a car is drawn and driven. */
export type Shape = Pick<Car, "width" | "front" | "rear" | "wheelbase" | "outline">;

export interface Leg {
    backward: boolean;
    /** Positive to the left in the slot's frame. */
    steer: number;
    length: number;
    start: Pose;
    end: Pose;
    /** Driven before this leg. */
    from: number;
}

export interface Track {
    legs: Leg[];
    length: number;
}

export const degrees = (radians: number) => (radians * 180) / Math.PI;
export const radians = (inDegrees: number) => (inDegrees * Math.PI) / 180;
export const clamp = (value: number, low: number, high: number) => Math.min(Math.max(value, low), high);

const seen = (pose: Pose, mirror: number): Pose => ({ x: pose.x, y: mirror * pose.y, heading: mirror * pose.heading });

export function track(maneuver: Pick<Maneuver, "moves">, side: SlotLike["side"]): Track {
    const mirror = side === "left" ? -1 : 1;
    let from = 0;
    const legs = maneuver.moves.map((move) => {
        const leg = {
            backward: move.direction === "backward",
            steer: mirror * move.steering_angle,
            length: move.length,
            start: seen(move.start, mirror),
            end: seen(move.end, mirror),
            from,
        };
        from += move.length;
        return leg;
    });
    return { legs, length: from };
}

/** An arc, as its chord: exact, and steady for steering angles near zero. */
export function drive(car: Shape, leg: Leg, distance: number): Pose {
    const s = leg.backward ? -distance : distance;
    const turned = (s * Math.tan(leg.steer)) / car.wheelbase;
    const half = turned / 2;
    const chord = Math.abs(half) < 1e-8 ? s : (s * Math.sin(half)) / half;
    const { x, y, heading } = leg.start;
    return {
        x: x + chord * Math.cos(heading + half),
        y: y + chord * Math.sin(heading + half),
        heading: heading + turned,
    };
}

/** The leg driven at a distance from the start; a direction change belongs to the leg it begins. */
export function legAt(of: Track, distance: number): number {
    let index = 0;
    while (index + 1 < of.legs.length && of.legs[index + 1]!.from <= distance) ++index;
    return index;
}

export function poseAt(car: Shape, of: Track, distance: number): Pose {
    const leg = of.legs[legAt(of, distance)]!;
    return distance >= leg.from + leg.length ? leg.end : drive(car, leg, distance - leg.from);
}

/** Poses of a leg, close enough for the eye. */
export function samples(car: Shape, leg: Leg, spacing: number): Pose[] {
    const count = Math.min(400, Math.max(1, Math.ceil(leg.length / spacing)));
    return Array.from({ length: count + 1 }, (_, i) =>
        i === count ? leg.end : drive(car, leg, (leg.length * i) / count),
    );
}

/** Corners of the frame, grown on every side: front left, rear left, rear right, front right. */
export function corners(car: Shape, pose: Pose, grown = 0): Point[] {
    const half = car.width / 2 + grown;
    const [front, rear] = [car.front + grown, -car.rear - grown];
    return moved(pose, [{ x: front, y: half }, { x: rear, y: half }, { x: rear, y: -half }, { x: front, y: -half }]);
}

export const moved = (pose: Pose, points: Point[]): Point[] => {
    const c = Math.cos(pose.heading);
    const s = Math.sin(pose.heading);
    return points.map(({ x, y }) => ({ x: pose.x + x * c - y * s, y: pose.y + x * s + y * c }));
};

/** Of the car itself: its outline where it has one, else its frame. */
export const carCorners = (car: Shape, pose: Pose): Point[] =>
    car.outline ? moved(pose, car.outline.map(([x, y]) => ({ x, y }))) : corners(car, pose);

/** The entry position of a heading: the grown frame's corner on the curb side at the slot's corner. */
export function entryPose(car: Shape, length: number, heading: number, forward: boolean, clearance: number): Pose {
    const ahead = (forward ? car.rear : car.front) + clearance;
    const half = car.width / 2 + clearance;
    const x = -(ahead * Math.cos(heading) + half * Math.sin(heading));
    const y = -(ahead * Math.sin(heading) - half * Math.cos(heading));
    return forward ? { x: -length - x, y, heading: -heading } : { x, y, heading };
}
