// The street from above, to scale, and the handles that change it. Drawn in the slot's frame with the road at the top; a
// slot on the left is seen by a car that drives to the left, so nothing is mirrored.
import type { HeadingRange, Pose } from "snug";
import { countColor } from "./colors";
import { set, setText, svg } from "./dom";
import { carCorners, clamp, degrees, samples, type Point, type Shape, type Track } from "./geometry";
import { arrowsAcross, arrowsAlong, createHandles, knob as knobOf, watchSize } from "./handles";
import { carShape, createVehicle, dimension, pen, round, type View } from "./view";
import { plural } from "./words";

export interface Scene {
    car: Shape;
    length: number;
    width: number;
    frontSetback: number;
    rearSetback: number;
    low: boolean;
    left: boolean;
    forward: boolean;
    clearance: number;
    /** The entry heading shown, in the slot's sense. */
    heading: number;
    ranges: HeadingRange[];
    track: Track | null;
    parked: boolean;
    swept: boolean;
}

export interface Handles {
    /** Something was dragged to a new size or heading [m, rad]. */
    length(value: number): void;
    width(value: number): void;
    heading(value: number): void;
    /** Nothing is dragged any more: the scale may change. */
    released(): void;
}

type Drag = "rear" | "front" | "curb" | "heading";

export function createDrawing(root: SVGSVGElement, handles: Handles) {
    let scene: Scene | null = null;
    const view: View = { scale: 50, x0: 0, y0: 0, fx: 1, fy: 1 };
    const drawn = pen(view);
    const { at, polygon, path, box, stand } = drawn;
    let size = { width: 0, height: 0 };
    let shown: { pose: Pose; steer: number } | null = null;

    const layer = (name: string) => root.appendChild(svg("g", { class: name }));
    const street = layer("street");
    const fan = layer("fan");
    const neighbours = layer("neighbours");
    const trail = layer("trail");
    const vehicle = layer("vehicle");
    const way = layer("way");
    const dimensions = layer("dimensions");
    const grips = layer("grips");

    // --- what stays and only moves
    const rearCar = neighbours.appendChild(carShape("neighbour"));
    const frontCar = neighbours.appendChild(carShape("neighbour"));
    set(rearCar, { "data-grip-for": "rear" });
    set(frontCar, { "data-grip-for": "front" });
    const vehicleAt = createVehicle(vehicle, drawn, view);

    const grip = (what: Drag, label: string, sign: string) => grips.appendChild(knobOf(what, label, sign));
    const gripOf = {
        rear: grip("rear", "Rear neighbour: length of the slot", arrowsAlong),
        front: grip("front", "Front neighbour: length of the slot", arrowsAlong),
        curb: grip("curb", "Curb: width of the slot", arrowsAcross),
        heading: grip("heading", "Entry heading", arrowsAcross),
    };

    const fit = (s: Scene) => {
        const narrow = size.width < 600;
        // On a narrow screen the room goes to the side where the protractor is.
        const [behind, ahead] = !narrow ? [190, 210] : s.forward ? [104, 44] : [44, 104];
        const above = Math.max(2.3, Math.min(s.car.front * 0.6 + 0.9, 8));
        const below = narrow ? 1.25 : 1.35;
        const scale = Math.min((size.width - behind - ahead) / s.length, size.height / (s.width + above + below));
        if (!(scale > 0)) return; // no room at all
        const spare = size.height / scale - (s.width + above + below);
        view.scale = scale;
        view.fx = s.left ? -1 : 1;
        view.x0 = size.width / 2 + (view.fx * (s.length * scale + behind - ahead)) / 2;
        view.y0 = (above + spare * 0.55) * scale;
    };

    const bounds = () => {
        const xs = [-view.x0, size.width - view.x0].map((x) => (view.fx * x) / view.scale);
        return { left: Math.min(...xs), right: Math.max(...xs), top: view.y0 / view.scale, bottom: -(size.height - view.y0) / view.scale };
    };

    const drawStreet = (s: Scene) => {
        const edge = bounds();
        const lane = Math.min(3.2, edge.top - 0.3);
        const parts: SVGElement[] = [svg("path", { class: "road", d: box(edge.left, edge.top, edge.right, -s.width) })];
        let grid = "";
        for (let x = Math.ceil(edge.left); x <= edge.right; ++x) grid += path([{ x, y: edge.top }, { x, y: edge.bottom }]);
        for (let y = Math.ceil(edge.bottom); y <= edge.top; ++y) grid += path([{ x: edge.left, y }, { x: edge.right, y }]);
        parts.push(
            svg("path", { class: "sidewalk", d: box(edge.left, -s.width, edge.right, edge.bottom) }),
            svg("path", { class: "blocked", d: box(edge.left, -s.rearSetback, -s.length, -s.width) + box(0, -s.frontSetback, edge.right, -s.width) }),
            svg("path", { class: "floor", d: box(-s.length, 0, 0, -s.width) }),
            svg("path", { class: "grid", d: view.scale > 12 ? grid : "" }),
            svg("path", { class: "lane", d: path([{ x: edge.left, y: lane }, { x: edge.right, y: lane }]) }),
            svg("path", { class: s.low ? "curb low" : "curb", d: path([{ x: edge.left, y: -s.width }, { x: edge.right, y: -s.width }]) }),
            svg("path", {
                class: "slot",
                d: path([{ x: -s.length, y: 0 }, { x: -s.length, y: -s.width }, { x: 0, y: -s.width }, { x: 0, y: 0 }]),
            }),
            svg("path", { class: "entry-side", d: path([{ x: -s.length, y: 0 }, { x: 0, y: 0 }]) }),
        );
        street.replaceChildren(...parts);
        const other = { rear: 0.8, front: 3.5, width: clamp(1.78, 0, s.width * 0.92) };
        const beside = (setback: number) => {
            const width = Math.min(other.width, Math.max(s.width - setback, 0.2));
            return { car: { ...other, width }, y: -setback - width / 2 - Math.min(0.02, s.width * 0.02) };
        };
        const [front, rear] = [beside(s.frontSetback), beside(s.rearSetback)];
        stand(frontCar, front.car, { x: other.rear, y: front.y, heading: 0 });
        stand(rearCar, rear.car, { x: -s.length - other.front, y: rear.y, heading: 0 });
    };

    // --- the protractor on which the entry headings lie
    const fanCentre = (s: Scene): Point => ({ x: s.forward ? -s.length : 0, y: 0 });
    const fanRadius = () => {
        const edge = bounds();
        const beside = scene!.forward ? -scene!.length - edge.left : edge.right;
        return clamp(1.75, 55 / view.scale, Math.max(55, Math.min(150, Math.min(beside, edge.top) * view.scale - 34)) / view.scale);
    };
    const ray = (s: Scene, heading: number, radius: number): Point => {
        const c = fanCentre(s);
        return { x: c.x + (s.forward ? -1 : 1) * radius * Math.cos(heading), y: radius * Math.sin(heading) };
    };

    const drawFan = (s: Scene) => {
        const radius = fanRadius();
        const arc = (from: number, till: number, r: number) =>
            Array.from({ length: 33 }, (_, i) => ray(s, from + ((till - from) * i) / 32, r));
        const parts: SVGElement[] = [
            svg("path", { class: "protractor", d: polygon([fanCentre(s), ...arc(0, Math.PI / 2, radius)]) }),
        ];
        let ticks = "";
        for (let d = 0; d <= 90; d += 5) {
            const reach = d % 10 === 0 ? 9 : 5;
            ticks += path([ray(s, (d * Math.PI) / 180, radius), ray(s, (d * Math.PI) / 180, radius - reach / view.scale)]);
        }
        parts.push(svg("path", { class: "ticks", d: ticks }));
        // Outside, where no fan hides them; the knob takes the place of the one it stands on.
        const outward = s.left === s.forward ? "start" : "end";
        for (const d of [0, 30, 60, 90]) {
            const angle = (d * Math.PI) / 180;
            if (Math.abs(s.heading - angle) * (radius * view.scale + 17) < 26) continue;
            const [x, y] = at(ray(s, angle, radius + 7 / view.scale));
            parts.push(svg("text", { class: "degree", x: round(x), y: round(y + (d === 0 ? -3 : 2)), "text-anchor": outward }, `${d}°`));
        }
        for (const range of s.ranges) {
            const wedge = polygon([fanCentre(s), ...arc(range.heading_min, range.heading_max, radius)]);
            const color = countColor(range.direction_changes);
            const word = `${range.direction_changes} ${plural(range.direction_changes)}: ${degrees(range.heading_min).toFixed(3)}° to ${degrees(range.heading_max).toFixed(3)}°`;
            parts.push(svg("path", { class: "wedge", d: wedge, fill: color, stroke: color }, svg("title", {}, word)));
        }
        parts.push(svg("path", { class: "ray", d: path([fanCentre(s), ray(s, s.heading, radius)]) }));
        fan.replaceChildren(...parts);
    };

    const drawTrail = (s: Scene) => {
        const parts: SVGElement[] = [];
        const lines: SVGElement[] = [];
        if (s.track && s.track.legs.length > 0) {
            const poses = s.track.legs.map((leg) => samples(s.car, leg, drag() ? 0.04 : 0.015));
            if (s.swept) {
                const frames = poses.flat().map((pose) => polygon(carCorners(s.car, pose)));
                parts.push(svg("path", { class: "swept", d: frames.join("") }));
            }
            const ends = s.track.legs.slice(0, -1).map((leg) => polygon(carCorners(s.car, leg.end)));
            parts.push(svg("path", { class: "ghosts", d: ends.join("") }));
            parts.push(svg("path", { class: "entry-frame", d: polygon(carCorners(s.car, s.track.legs[0]!.start)) }));
            if (s.parked) parts.push(svg("path", { class: "goal-frame", d: polygon(carCorners(s.car, s.track.legs.at(-1)!.end)) }));
            for (const backward of [true, false]) {
                const d = poses.filter((_, i) => s.track!.legs[i]!.backward === backward).map(path).join("");
                if (d) lines.push(svg("path", { class: backward ? "path backward" : "path forward", d }));
            }
        }
        const [x, y] = at(fanCentre(s));
        parts.push(svg("circle", { class: "corner", cx: round(x), cy: round(y), r: 3.5 }));
        trail.replaceChildren(...parts);
        way.replaceChildren(...lines);
    };

    const drawDimensions = (s: Scene) => {
        const below = Math.min(1.0 * view.scale, size.height - at({ x: 0, y: -s.width })[1] - 12);
        const [a, b] = [at({ x: -s.length, y: -s.width }), at({ x: 0, y: -s.width })];
        const [left, right] = s.left ? [b, a] : [a, b];
        // On a narrow screen the width is told on the roomy side, where no handle is.
        const onRight = size.width < 600 ? s.forward === s.left : s.left;
        const beside = onRight ? size.width - 14 : 26;
        dimensions.replaceChildren(
            dimension(left, right, [0, Math.max(below, Math.min(56, size.height - left[1] - 12))], `${s.length.toFixed(3)} m`),
            dimension([beside, at({ x: 0, y: -s.width })[1]], [beside, at({ x: 0, y: 0 })[1]], [0, 0], `${s.width.toFixed(3)} m`),
        );
        const slider = (element: SVGElement, p: Point, now: number, low: number, high: number, text: string) => {
            const [x, y] = at(p);
            set(element, {
                transform: `translate(${round(x)} ${round(y)})`,
                "aria-valuenow": now.toFixed(3),
                "aria-valuemin": low,
                "aria-valuemax": high,
                "aria-valuetext": text,
            });
        };
        const inward = 24 / view.scale;
        const middle = -s.width / 2;
        slider(gripOf.rear, { x: -s.length - inward, y: middle }, s.length, 0.5, 40, `${s.length.toFixed(3)} metres`);
        slider(gripOf.front, { x: inward, y: middle }, s.length, 0.5, 40, `${s.length.toFixed(3)} metres`);
        slider(gripOf.curb, { x: -s.length / 2, y: -s.width - 17 / view.scale }, s.width, 0.3, 10, `${s.width.toFixed(3)} metres`);
        const knob = ray(s, s.heading, fanRadius() + 17 / view.scale);
        slider(gripOf.heading, knob, degrees(s.heading), 0, 90, `${degrees(s.heading).toFixed(2)} degrees off parallel`);
        const turn = degrees(s.heading) * (s.left === s.forward ? -1 : 1);
        set(gripOf.heading, { transform: `${gripOf.heading.getAttribute("transform")} rotate(${round(turn)})` });
    };

    const render = (next: Scene) => {
        scene = next;
        if (size.width === 0) return;
        const dragged = drag()?.what;
        if (!dragged) fit(next);
        else if (dragged === "front") {
            // The corner the scene hangs on is the one being dragged: keep the rear neighbour where it is.
            view.x0 = dragAnchor + view.fx * next.length * view.scale;
        }
        drawStreet(next);
        drawFan(next);
        drawTrail(next);
        drawDimensions(next);
        setText(title, `A slot of ${next.length.toFixed(3)} by ${next.width.toFixed(3)} metres seen from above, and the car`);
    };
    const title = root.insertBefore(svg("title", {}), root.firstChild);

    /** The car itself, at a pose and with its front wheels turned. */
    const showCar = (pose: Pose, steer: number) => {
        shown = { pose, steer };
        if (!scene || size.width === 0) return;
        vehicleAt(scene.car, pose, steer, scene.clearance);
    };

    // --- dragging
    let dragAnchor = 0;
    const snap = (value: number) => Math.round(value * 200) / 200; // 5 mm

    const grab = (what: Drag, p: Point) => {
        if (!scene) return null;
        dragAnchor = view.x0 - view.fx * scene.length * view.scale;
        const offset = { rear: p.x + scene.length, front: p.x, curb: p.y + scene.width, heading: 0 }[what];
        return { what, offset };
    };
    const move = ({ what, offset }: NonNullable<ReturnType<typeof grab>>, p: Point) => {
        if (!scene) return;
        if (what === "rear") handles.length(snap(offset - p.x));
        else if (what === "front") handles.length(snap(scene.length + p.x - offset));
        else if (what === "curb") handles.width(snap(offset - p.y));
        else {
            const c = fanCentre(scene);
            const heading = Math.atan2(p.y, (scene.forward ? -1 : 1) * (p.x - c.x));
            handles.heading(clamp(heading < -Math.PI / 2 ? Math.PI / 2 : heading, 0, Math.PI / 2));
        }
    };
    const key = (held: Drag, event: KeyboardEvent) => {
        if (!scene) return false;
        const more = ["ArrowUp", "ArrowRight", "PageUp"].includes(event.key);
        if (!more && !["ArrowDown", "ArrowLeft", "PageDown"].includes(event.key)) return false;
        const big = event.shiftKey || event.key.startsWith("Page");
        const step = (more ? 1 : -1) * (big ? 10 : event.altKey ? 0.1 : 1);
        const tidy = (value: number) => Math.round(value * 1e6) / 1e6;
        if (held === "heading") handles.heading(clamp(scene.heading + (step * Math.PI) / 180 / 10, 0, Math.PI / 2));
        else if (held === "curb") handles.width(tidy(scene.width + step / 100));
        else handles.length(tidy(scene.length + step / 100));
        return true;
    };
    const drag = createHandles(root, drawn.ground, gripOf, { grab, move, released: () => handles.released(), key });

    watchSize(root, (now) => {
        size = now;
        if (!scene) return;
        render(scene);
        if (shown) showCar(shown.pose, shown.steer);
    });

    return { render, showCar, busy: () => drag() !== null };
}
