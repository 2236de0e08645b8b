// From metres to the picture: where a point of the ground is on the screen, and how a car standing there is drawn.
import { svg, set } from "./dom";
import { carCorners, corners, degrees, type Point, type Shape } from "./geometry";
import type { Pose } from "snug";

/** `fx`, `fy`: -1 where the picture runs against x or y. */
export interface View {
    scale: number;
    x0: number;
    y0: number;
    fx: number;
    fy: number;
}

export const round = (value: number) => value.toFixed(2);

/** Paths in the picture from points on the ground; the view may change later. */
export function pen(view: View) {
    const at = (p: Point): [number, number] => [view.x0 + view.fx * p.x * view.scale, view.y0 - view.fy * p.y * view.scale];
    const to = (p: Point) => at(p).map(round).join(" ");
    const polygon = (points: Point[]) => `M${points.map(to).join("L")}Z`;
    const path = (points: Point[]) => `M${points.map(to).join("L")}`;
    const box = (x1: number, y1: number, x2: number, y2: number) =>
        polygon([{ x: x1, y: y1 }, { x: x2, y: y1 }, { x: x2, y: y2 }, { x: x1, y: y2 }]);
    /** The point on the ground under a point of the picture. */
    const ground = (x: number, y: number): Point => ({ x: (view.fx * (x - view.x0)) / view.scale, y: (view.fy * (view.y0 - y)) / view.scale });
    /** A car shape standing at a pose: x from the rear to the front, y to its left. */
    const stand = (element: SVGElement, car: Pick<Shape, "front" | "rear" | "width">, pose: Pose) => {
        const c = Math.cos(pose.heading);
        const s = Math.sin(pose.heading);
        const long = (car.front + car.rear) * view.scale;
        const half = (car.width / 2) * view.scale;
        const [x, y] = at({ x: pose.x - car.rear * c, y: pose.y - car.rear * s });
        const { fx, fy } = view;
        set(element, { transform: `matrix(${[fx * c * long, -fy * s * long, -fx * s * half, -fy * c * half, x, y].map((v) => v.toFixed(4)).join(" ")})` });
    };
    return { at, to, polygon, path, box, ground, stand };
}
export type Pen = ReturnType<typeof pen>;

const bodyPath =
    "M.08-1L.84-1C.945-1 .982-.9 .988-.58C1.004-.2 1.004 .2 .988 .58C.982 .9 .945 1 .84 1L.08 1C.03 1 .008 .93 .005 .66" +
    "C-.002 .25-.002-.25 .005-.66C.008-.93 .03-1 .08-1Z";
const glassPath =
    "M.69-.8C.735-.4 .735 .4 .69 .8C.64 .87 .58 .88 .5 .88L.26 .88C.18 .88 .14 .84 .09 .72C.07 .3 .07-.3 .09-.72" +
    "C.14-.84 .18-.88 .26-.88L.5-.88C.58-.88 .64-.87 .69-.8ZM.595-.7C.625-.35 .625 .35 .595 .7L.19 .68" +
    "C.165 .35 .165-.35 .19-.68Z";
const lampsPath = "M.93-.93C.97-.9 .985-.7 .985-.5L.955-.48C.95-.7 .93-.82 .9-.9ZM.93 .93C.97 .9 .985 .7 .985 .5L.955 .48C.95 .7 .93 .82 .9 .9Z";
const tailPath = "M.012-.9L.012-.5L.035-.5L.035-.9ZM.012 .9L.012 .5L.035 .5L.035 .9Z";

/** Seen from above; lamps tell the front from the rear. */
export const carShape = (kind: string) =>
    svg(
        "g",
        { class: kind },
        svg("path", { d: bodyPath, class: "body" }),
        svg("path", { d: glassPath, class: "glass" }),
        svg("path", { d: lampsPath, class: "lamps" }),
        svg("path", { d: tailPath, class: "tail" }),
    );

/** The car one drives, with its wheels; a few elements that only move. */
export function createVehicle(layer: SVGElement, { at, polygon, path, stand }: Pen, view: View) {
    const wheels = [0, 1, 2, 3].map(() => layer.appendChild(svg("path", { class: "wheel" })));
    const body = layer.appendChild(carShape("car"));
    const outline = layer.appendChild(svg("path", { class: "frame" }));
    const ahead = layer.appendChild(svg("path", { class: "ahead" }));
    const axle = layer.appendChild(svg("path", { class: "axle" }));
    const kept = layer.appendChild(svg("path", { class: "kept" }));
    return (car: Shape, pose: Pose, steer: number, clearance: number) => {
        stand(body, car, pose);
        set(outline, { d: polygon(carCorners(car, pose)) });
        set(kept, { d: clearance > 0 ? polygon(corners(car, pose, clearance)) : "" });
        const c = Math.cos(pose.heading);
        const s = Math.sin(pose.heading);
        const local = (along: number, left: number): Point => ({ x: pose.x + along * c - left * s, y: pose.y + along * s + left * c });
        const [long, wide] = [0.065 * (car.front + car.rear), 0.05 * car.width];
        const beside = car.width / 2 - 2.4 * wide;
        const axleAhead = Math.min(car.wheelbase, car.front);
        const places: [number, number, number][] = [
            [0, beside, 0],
            [0, -beside, 0],
            [axleAhead, beside, steer],
            [axleAhead, -beside, steer],
        ];
        places.forEach(([along, left, turn], i) => {
            const [tc, ts] = [Math.cos(turn), Math.sin(turn)];
            const corner = (u: number, v: number) => local(along + u * tc - v * ts, left + u * ts + v * tc);
            set(wheels[i]!, { d: polygon([corner(long, wide), corner(-long, wide), corner(-long, -wide), corner(long, -wide)]) });
        });
        const arm = 5 / view.scale;
        set(axle, { d: path([local(-arm, 0), local(arm, 0)]) + path([local(0, -arm), local(0, arm)]) });
        // An arrow on the hood: this end is the front.
        const [tip, wing] = [car.front - 0.05 * (car.front + car.rear), 0.13 * car.width];
        set(ahead, { d: path([local(tip - wing, wing), local(tip, 0), local(tip - wing, -wing)]) });
        return at(pose);
    };
}

/** A dimension line between two points of the picture, `off` from them, as on an engineering drawing. */
export function dimension(from: [number, number], till: [number, number], off: [number, number], text: string) {
    const [ax, ay] = [from[0] + off[0], from[1] + off[1]];
    const [bx, by] = [till[0] + off[0], till[1] + off[1]];
    const long = Math.hypot(bx - ax, by - ay) || 1;
    const [ux, uy] = [(bx - ax) / long, (by - ay) / long];
    const head = (x: number, y: number, d: number) =>
        `M${round(x)} ${round(y)}L${round(x + d * (8 * ux - 2.6 * uy))} ${round(y + d * (8 * uy + 2.6 * ux))}` +
        `L${round(x + d * (8 * ux + 2.6 * uy))} ${round(y + d * (8 * uy - 2.6 * ux))}Z`;
    const turned = degrees(Math.atan2(uy, ux));
    // To be read from below or from the right.
    const turn = turned >= 90 ? turned - 180 : turned < -90 ? turned + 180 : turned;
    const [mx, my] = [(ax + bx) / 2, (ay + by) / 2];
    const reach = (p: number, q: number) => q + Math.sign(q - p) * 5;
    return svg(
        "g",
        {},
        svg("path", {
            class: "extension",
            d: `M${round(from[0])} ${round(from[1])}L${round(reach(from[0], ax))} ${round(reach(from[1], ay))}M${round(till[0])} ${round(till[1])}L${round(reach(till[0], bx))} ${round(reach(till[1], by))}`,
        }),
        svg("path", { class: "line", d: `M${round(ax)} ${round(ay)}L${round(bx)} ${round(by)}` }),
        svg("path", { class: "head", d: head(ax, ay, 1) + head(bx, by, -1) }),
        svg(
            "text",
            {
                class: "measure",
                x: round(mx),
                y: round(my),
                dy: "-0.4em",
                "text-anchor": "middle",
                transform: turn === 0 ? null : `rotate(${round(turn)} ${round(mx)} ${round(my)})`,
            },
            text,
        ),
    );
}
