// The street from above, to scale: the car stands anywhere and is dragged and turned, the ground is coloured by how many
// direction changes the way from there takes. Drawn in the world; beside a slot on the left the world is turned by half.
import type { Pose, Scene as Place } from "snug";
import { countColor, moreColor } from "./colors";
import { set, setText, svg } from "./dom";
import { carCorners, clamp, corners, degrees, entryPose, radians, samples, type Point, type Shape, type Track } from "./geometry";
import { arrowsAcross, arrowsAlong, createHandles, knob, watchSize } from "./handles";
import { tidyPose } from "./inputs";
import { more, type Slice } from "./questions";
import { carShape, createVehicle, dimension, pen, round, type View } from "./view";

export interface StreetScene {
    car: Shape;
    place: Place;
    /** What of it can be dragged; null: a place from a file. */
    street: { length: number; width: number; angle: number; road: number | null; left: boolean; forward: boolean; out: boolean } | null;
    clearance: number;
    pose: Pose;
    /** The way shown is known to end in the slot. */
    track: Track | null;
    /** The car meets something where it stands. */
    blocked: boolean;
    painted: { slice: Slice; counts: { lower: Int16Array; upper: Int16Array } } | null;
    /** Painted a moment ago, for another place. */
    stale: boolean;
    swept: boolean;
    tracks: boolean;
}

export interface StreetHandles {
    pose(pose: Pose): void;
    /** The rear neighbour, or the front one, which takes the car along. */
    along(by: number, front: boolean): void;
    depth(by: number): void;
    road(by: number): void;
    grabbed(): void;
    /** Nothing is dragged any more, or the picture has another size: it may be painted anew. */
    released(): void;
}

type Drag = "car" | "turn" | "rear" | "front" | "curb" | "far";
type Box = Slice["box"];

const quarter = Math.PI / 2;

export function createStreet(root: SVGSVGElement, handles: StreetHandles) {
    let scene: StreetScene | null = null;
    const view: View = { scale: 50, x0: 0, y0: 0, fx: 1, fy: 1 };
    const drawn = pen(view);
    const { at, polygon, path, stand } = drawn;
    let size = { width: 0, height: 0 };
    let measuresLeft = false;
    let shown: { pose: Pose; steer: number } | null = null;

    const title = root.appendChild(svg("title", {}));
    const layer = (name: string) => root.appendChild(svg("g", { class: name }));
    const ground = layer("street");
    const image = root.appendChild(svg("image", { class: "counts", preserveAspectRatio: "none" }));
    const obstacles = layer("neighbours");
    const entries = layer("entries");
    const trail = layer("trail");
    const vehicle = layer("vehicle");
    const way = layer("way");
    const dimensions = layer("dimensions");
    const grips = layer("grips");
    const vehicleAt = createVehicle(vehicle, drawn, view);
    const canvas = document.createElement("canvas");

    // --- handles
    const grip = (what: Drag, label: string, sign: string) => grips.appendChild(knob(what, label, sign));
    const carGrip = grips.appendChild(
        svg("g", { class: "grip grip-car", role: "button", tabindex: 0, "data-grip": "car" }, svg("path", { class: "reach" })),
    );
    const gripOf = {
        car: carGrip as SVGElement,
        turn: grip("turn", "Your car: its heading", "M5.5-4.5A7 7 0 1 0 7 1M7.5-8V-3.5H3"),
        rear: grip("rear", "Rear neighbour", arrowsAlong),
        front: grip("front", "Front neighbour", arrowsAlong),
        curb: grip("curb", "Curb: depth of the slot", arrowsAcross),
        far: grip("far", "Far side: width of the road", arrowsAcross),
    };

    // --- where everything is
    const bay = (s: StreetScene): Point[] => ("inside" in s.place.parked ? s.place.parked.inside : []).map(([x, y]) => ({ x, y }));
    const extent = (points: Point[]): Box => ({
        x_min: Math.min(...points.map((p) => p.x)),
        x_max: Math.max(...points.map((p) => p.x)),
        y_min: Math.min(...points.map((p) => p.y)),
        y_max: Math.max(...points.map((p) => p.y)),
    });
    /** In the street's own sense: y out of the slot, whichever side it is on. */
    const sense = (s: StreetScene) => (s.street?.left ? -1 : 1);

    const seenBox = (s: StreetScene): Box => {
        const region = s.place.region!;
        const stands = corners(s.car, s.pose, 0.4);
        const narrow = size.width < 600;
        // The knob that turns the car is ahead of it.
        const ahead = s.car.front + (narrow ? 1.5 : 1);
        const knob = { x: s.pose.x + ahead * Math.cos(s.pose.heading), y: s.pose.y + ahead * Math.sin(s.pose.heading) };
        if (!s.street) {
            const inside = bay(s);
            const named = s.place.obstacles.flatMap((one) => (Array.isArray(one) ? one : one.polygon).map(([x, y]) => ({ x, y })));
            const goal = "pose" in s.place.parked ? [{ x: s.place.parked.pose[0], y: s.place.parked.pose[1] }] : inside;
            const all = extent([...named, ...goal, ...stands, knob, { x: s.place.start[0], y: s.place.start[1] }]);
            const wide = (low: number, high: number, a: number, b: number): [number, number] => [Math.max(low, a) - 1, Math.min(high, b) + 1];
            const [x_min, x_max] = wide(region.x_min - 6, region.x_max + 6, all.x_min, all.x_max);
            const [y_min, y_max] = wide(region.y_min - 6, region.y_max + 6, all.y_min, all.y_max);
            return { x_min, x_max, y_min, y_max };
        }
        const slot = extent(bay(s));
        const own = s.car.front + s.car.rear;
        const beside = (narrow ? 0.75 : 1.45) * own;
        const out = Math.min(s.street.road ?? Infinity, Math.max(1.5 * own, 6));
        const below = narrow ? 1.25 : 0.75; // a length stands there
        const [low, high] = sense(s) > 0 ? [slot.y_min - below, out + 0.45] : [-out - 0.45, slot.y_max + below];
        const goal = s.street.out ? 0.8 * own : 0; // out on the road
        const ends = s.street.out && s.track ? s.track.legs.slice(-1).flatMap(({ end }) => corners(s.car, end, 0.4)) : [];
        return extent([{ x: slot.x_min - beside, y: low }, { x: slot.x_max + beside + goal, y: high }, ...stands, ...ends, knob]);
    };

    const fit = (s: StreetScene) => {
        const box = seenBox(s);
        const [across, up] = [box.x_max - box.x_min, box.y_max - box.y_min];
        const scale = Math.min(size.width / across, size.height / up);
        if (!(scale > 0)) return;
        view.scale = scale;
        view.fx = view.fy = sense(s);
        const [mx, my] = [(box.x_min + box.x_max) / 2, (box.y_min + box.y_max) / 2];
        view.x0 = size.width / 2 - view.fx * mx * scale;
        view.y0 = size.height / 2 + view.fy * my * scale;
    };
    const edges = (): Box => extent([drawn.ground(0, 0), drawn.ground(size.width, size.height)]);

    // --- drawing
    const drawGround = (s: StreetScene) => {
        const edge = edges();
        const parts: SVGElement[] = [svg("path", { class: "road", d: `M0 0H${round(size.width)}V${round(size.height)}H0Z` })];
        let grid = "";
        const step = view.scale > 12 ? 1 : 5;
        for (let x = Math.ceil(edge.x_min / step) * step; x <= edge.x_max; x += step) grid += path([{ x, y: edge.y_max }, { x, y: edge.y_min }]);
        for (let y = Math.ceil(edge.y_min / step) * step; y <= edge.y_max; y += step) grid += path([{ x: edge.x_min, y }, { x: edge.x_max, y }]);
        parts.push(svg("path", { class: "grid", d: grid }));
        ground.replaceChildren(...parts);

        const things: SVGElement[] = [];
        for (const one of s.place.obstacles) {
            const { polygon: around, low = false, name = "" } = Array.isArray(one) ? { polygon: one } : one;
            // Streets' obstacles go on for ever: the picture ends.
            const points = around.map(([x, y]) => ({ x: clamp(x, edge.x_min - 5, edge.x_max + 5), y: clamp(y, edge.y_min - 5, edge.y_max + 5) }));
            const kind = name === "curb" || name === "far side" ? "sidewalk" : "blocked";
            things.push(svg("path", { class: `${kind}${low ? " low" : ""}`, d: polygon(points) }, svg("title", {}, low ? `${name} (low)` : name)));
        }
        const slot = bay(s);
        if (slot.length > 0) {
            things.push(svg("path", { class: "slot", d: polygon(slot) }));
        } else if ("pose" in s.place.parked) {
            const [x, y, heading] = s.place.parked.pose;
            things.push(svg("path", { class: "slot", d: polygon(carCorners(s.car, { x, y, heading })) }));
        }
        if (s.street) things.push(...parkedCars(s, slot, edge), ...lines(s, slot, edge));
        obstacles.replaceChildren(...things);
    };

    /** Neighbours have the size of what is left of their place. */
    const parkedCars = (s: StreetScene, slot: Point[], edge: Box) => {
        const { length, width, angle } = s.street!;
        const cars: SVGElement[] = [];
        const add = (pose: Pose, long: number, wide: number, what: "rear" | "front") => {
            const car = carShape("neighbour");
            set(car, { "data-grip-for": what });
            stand(car, { front: 0.81 * long, rear: 0.19 * long, width: wide }, pose);
            cars.push(car);
        };
        if (angle === 0) {
            const [long, wide] = [4.3, clamp(1.78, 0, width * 0.92)];
            const y = sense(s) * (-wide / 2 - Math.min(0.02, width * 0.02));
            const gap = 0.55;
            for (let x = 0.0; x < edge.x_max + long; x += long + gap) add({ x: x + 0.19 * long, y, heading: 0 }, long, wide, "front");
            for (let x = -length; x > edge.x_min - long; x -= long + gap) add({ x: x - 0.81 * long, y, heading: 0 }, long, wide, "rear");
            return cars;
        }
        const middle = { x: slot.reduce((sum, p) => sum + p.x, 0) / 4, y: slot.reduce((sum, p) => sum + p.y, 0) / 4 };
        const heading = "heading" in s.place.parked ? s.place.parked.heading : 0;
        const [long, wide] = [Math.min(0.9 * length, 4.6), Math.min(0.8 * width, 1.9)];
        for (const [by, what] of [[1, "front"], [-1, "rear"]] as const) {
            const x = middle.x + (by * width) / Math.sin(angle);
            const back = 0.31 * long;
            add({ x: x - back * Math.cos(heading), y: middle.y - back * Math.sin(heading), heading }, long, wide, what);
        }
        return cars;
    };

    const lines = (s: StreetScene, slot: Point[], edge: Box) => {
        const out = sense(s);
        const level = (y: number) => path([{ x: edge.x_min, y: out * y }, { x: edge.x_max, y: out * y }]);
        const deep = out > 0 ? -extent(slot).y_min : extent(slot).y_max;
        return [
            svg("path", { class: "curb", d: level(-deep) }),
            svg("path", { class: "curb", d: s.street!.road === null ? "" : level(s.street!.road) }),
        ];
    };

    /** The map of counts as an image under everything: white where nothing is known, as the canvas has it. */
    let paintedNow: unknown = null;
    const paint = (s: StreetScene) => {
        set(image, { "data-stale": s.stale ? "" : null });
        if (!s.painted) {
            set(image, { href: null });
            paintedNow = null;
            return;
        }
        const { slice, counts } = s.painted;
        const { box, columns, rows } = slice;
        if (paintedNow !== counts) {
            paintedNow = counts;
            canvas.width = columns;
            canvas.height = rows;
            const context = canvas.getContext("2d")!;
            const pixels = context.createImageData(columns, rows);
            for (let row = 0; row < rows; ++row)
                for (let column = 0; column < columns; ++column) {
                    const i = row * columns + column;
                    const [low, high] = [counts.lower[i]!, counts.upper[i]!];
                    if (high < 0) continue;
                    // Bays of y run upward, rows of the image downward.
                    const to = 4 * ((rows - 1 - row) * columns + column);
                    const known = high < more;
                    const stripe = !known && low === more && (row + column) % 6 < 3;
                    if (stripe) continue;
                    pixels.data.set(known ? rgb(countColor(high)) : low === more ? rgb("#a8321f") : rgb(moreColor), to);
                    pixels.data[to + 3] = known ? 150 : low === more ? 110 : 90;
                }
            context.putImageData(pixels, 0, 0);
            set(image, { href: canvas.toDataURL() });
        }
        // A half turn of the image where the world is turned.
        const [left, top] = at({ x: box.x_min, y: box.y_max });
        const turned = view.fx < 0 ? `rotate(180 ${round(left)} ${round(top)})` : null;
        set(image, {
            x: round(left),
            y: round(top),
            width: round((box.x_max - box.x_min) * view.scale),
            height: round((box.y_max - box.y_min) * view.scale),
            transform: turned,
        });
    };

    /** The paper's entry positions: a line of them, and the one of this heading. */
    const drawEntries = (s: StreetScene) => {
        if (!s.street || s.street.angle !== 0 || s.street.out) {
            entries.replaceChildren();
            return;
        }
        const { length, left, forward } = s.street;
        const entry = (heading: number) => {
            const pose = entryPose(s.car, length, heading, forward, s.clearance);
            return { x: pose.x, y: sense(s) * pose.y };
        };
        // Beyond the curb no car can stand.
        const deep = extent(bay(s));
        const line = Array.from({ length: 91 }, (_, i) => entry(radians(i))).filter(({ y }) => y >= deep.y_min && y <= Math.max(deep.y_max, -deep.y_min));
        const mine = (left ? -1 : 1) * (forward ? -1 : 1) * s.pose.heading;
        const parts: SVGElement[] = [svg("path", { class: "entry-line", d: path(line) }, svg("title", {}, "The paper’s entry positions"))];
        if (mine >= 0 && mine <= quarter) {
            const [x, y] = at(entry(mine));
            parts.push(svg("circle", { class: "entry-dot", cx: round(x), cy: round(y), r: 4.5 }, svg("title", {}, "The entry position of this heading")));
        }
        entries.replaceChildren(...parts);
    };

    const drawTrail = (s: StreetScene) => {
        const parts: SVGElement[] = [];
        const lines: SVGElement[] = [];
        if (s.track && s.track.legs.length > 0) {
            const poses = s.track.legs.map((leg) => samples(s.car, leg, drag() ? 0.12 : 0.03));
            if (s.swept) parts.push(svg("path", { class: "swept", d: poses.flat().map((pose) => polygon(carCorners(s.car, pose))).join("") }));
            const turns = s.track.legs.filter((leg, i) => s.track!.legs[i + 1] && s.track!.legs[i + 1]!.backward !== leg.backward);
            parts.push(svg("path", { class: "ghosts", d: turns.map((leg) => polygon(carCorners(s.car, leg.end))).join("") }));
            if (s.tracks)
                for (const corner of [0, 1, 2, 3])
                    parts.push(svg("path", { class: "corner-track", d: poses.map((leg) => path(leg.map((pose) => corners(s.car, pose)[corner]!))).join("") }));
            parts.push(svg("path", { class: "goal-frame", d: polygon(carCorners(s.car, s.track.legs.at(-1)!.end)) }));
            for (const backward of [true, false]) {
                const d = poses.filter((_, i) => s.track!.legs[i]!.backward === backward).map(path).join("");
                if (d) lines.push(svg("path", { class: backward ? "path backward" : "path forward", d }));
            }
            for (const leg of turns) {
                const [x, y] = at(leg.end);
                lines.push(svg("circle", { class: "cusp", cx: round(x), cy: round(y), r: 2.6 }));
            }
        }
        trail.replaceChildren(...parts);
        way.replaceChildren(...lines);
    };

    /** What is grabbed moves with the car shown, the start keeps its frame. */
    const startFrame = vehicle.insertBefore(svg("path", { class: "entry-frame" }), vehicle.firstChild);

    const slider = (element: SVGElement, p: Point, values: Record<string, string | number>, off: [number, number] = [0, 0]) => {
        const [x, y] = at(p);
        const inside = (value: number, most: number) => clamp(value, 16, Math.max(16, most - 16));
        set(element, { transform: `translate(${round(inside(x + off[0], size.width))} ${round(inside(y + off[1], size.height))})`, ...values });
    };
    const metres = (value: number, low: number, high: number) => ({
        "aria-valuenow": value.toFixed(3),
        "aria-valuemin": low,
        "aria-valuemax": high,
        "aria-valuetext": `${value.toFixed(3)} metres`,
    });

    const turnKnob = (car: Shape, pose: Pose): Point => {
        const reach = car.front + 30 / view.scale;
        return { x: pose.x + reach * Math.cos(pose.heading), y: pose.y + reach * Math.sin(pose.heading) };
    };
    /** Where a length is written: clear of the curb, as far as the picture goes. */
    const belowCurb = (y: number) => Math.min(Math.max(0.55 * view.scale, 24), size.height - y - 6);

    const drawHandles = (s: StreetScene) => {
        const { street } = s;
        for (const what of ["rear", "front", "curb", "far"] as const) gripOf[what].style.display = street ? "" : "none";
        const measures: SVGElement[] = [];
        if (street) {
            const slot = extent(bay(s));
            const out = sense(s);
            const middle = (slot.y_min + slot.y_max) / 2;
            const inward = street.angle === 0 ? 26 / view.scale : street.width / Math.sin(street.angle) / 2;
            const along = street.angle === 0 ? metres(street.length, 0.5, 40) : metres(street.width, 0.3, 10);
            const deepest = out > 0 ? slot.y_min : slot.y_max;
            // Beside a slot they are near the curb: the knob of a car that stands in it is in the middle.
            const y = street.angle === 0 ? 0.25 * middle + 0.75 * (deepest + (out * 16) / view.scale) : middle;
            // Not over the knob that turns the car.
            const { x: turnX, y: turnY } = turnKnob(s.car, s.pose);
            const beside = (x: number, away: number) => (Math.hypot(x - turnX, y - turnY) * view.scale < 30 ? turnX + (away * 30) / view.scale : x);
            slider(gripOf.rear, { x: beside(slot.x_min - inward, -1), y }, along);
            slider(gripOf.front, { x: beside(slot.x_max + inward, 1), y }, along);
            slider(gripOf.curb, { x: slot.x_min - 22 / view.scale, y: deepest }, street.angle === 0 ? metres(street.width, 0.3, 10) : metres(street.length, 0.5, 40), [0, 17]);
            gripOf.far.style.display = street.road === null ? "none" : "";
            if (street.road !== null) slider(gripOf.far, { x: slot.x_min - 0.35 * s.car.front, y: out * street.road }, metres(street.road, 0.5, 30), [0, -6]);
            if (street.angle === 0) {
                const ends = [at({ x: slot.x_min, y: deepest }), at({ x: slot.x_max, y: deepest })].sort((a, b) => a[0] - b[0]) as [[number, number], [number, number]];
                measures.push(dimension(ends[0], ends[1], [0, belowCurb(ends[0][1])], `${street.length.toFixed(3)} m`));
            }
            if (street.angle > 0) {
                // Of a bay, along the end that is farthest in: of its corners the two farthest from the road, from left to right.
                const inner = bay(s)
                    .sort((a, b) => out * (a.y - b.y))
                    .slice(0, 2)
                    .map(at)
                    .sort((a, b) => a[0] - b[0]) as [[number, number], [number, number]];
                const [[x1, y1], [x2, y2]] = inner;
                const off = street.angle < quarter ? 20 : belowCurb(y1);
                const long = Math.hypot(x2 - x1, y2 - y1);
                measures.push(dimension(...inner, [(-off * (y2 - y1)) / long, (off * (x2 - x1)) / long], `${street.width.toFixed(3)} m`));
            }
            // Where the car is not, or does not go to.
            const there = (street.out && s.track?.legs.at(-1)?.end) || s.pose;
            if (!drag()) measuresLeft = at(there)[0] > size.width / 2;
            const x = measuresLeft ? 26 : size.width - 22;
            measures.push(dimension([x, at({ x: 0, y: deepest })[1]], [x, at({ x: 0, y: 0 })[1]], [0, 0], `${(street.angle === 0 ? street.width : slot.y_max - slot.y_min).toFixed(3)} m`));
            if (street.road !== null) measures.push(dimension([x, at({ x: 0, y: 0 })[1]], [x, at({ x: 0, y: out * street.road })[1]], [0, 0], `${street.road.toFixed(2)} m`));
        }
        dimensions.replaceChildren(...measures);
    };

    const placeCarHandles = (s: StreetScene, pose: Pose) => {
        const frame = polygon(carCorners(s.car, pose));
        set(carGrip.firstElementChild!, { d: frame });
        const turn = degrees(pose.heading);
        set(carGrip, { "aria-label": `Your car, ${pose.x.toFixed(2)} m along the street, ${pose.y.toFixed(2)} m across, turned ${turn.toFixed(1)} degrees. Arrow keys move it, comma and full stop turn it.` });
        slider(gripOf.turn, turnKnob(s.car, pose), {
            "aria-valuenow": turn.toFixed(1),
            "aria-valuemin": -180,
            "aria-valuemax": 180,
            "aria-valuetext": `${turn.toFixed(1)} degrees`,
        });
    };

    const render = (next: StreetScene) => {
        scene = next;
        if (size.width === 0) return;
        if (!drag()) fit(next);
        drawGround(next);
        paint(next);
        drawEntries(next);
        drawTrail(next);
        drawHandles(next);
        set(root, { "data-blocked": next.blocked ? "" : null });
        setText(title, "The street seen from above, coloured by the direction changes needed from each place, and the car");
    };

    /** The car itself, at a pose and with its front wheels turned. */
    const showCar = (pose: Pose, steer: number) => {
        shown = { pose, steer };
        if (!scene || size.width === 0) return;
        vehicleAt(scene.car, pose, steer, scene.clearance);
        placeCarHandles(scene, pose);
        const { pose: from } = scene;
        set(startFrame, { d: pose.x === from.x && pose.y === from.y ? "" : polygon(carCorners(scene.car, from)) });
    };

    /** What of the region is in the picture, in fields of so many pixels. */
    const slice = (heading: number, pixels: number): Slice | null => {
        if (!scene || size.width === 0) return null;
        const edge = edges();
        const region = scene.place.region!;
        const box = {
            x_min: Math.max(edge.x_min, region.x_min),
            x_max: Math.min(edge.x_max, region.x_max),
            y_min: Math.max(edge.y_min, region.y_min),
            y_max: Math.min(edge.y_max, region.y_max),
        };
        const [across, up] = [box.x_max - box.x_min, box.y_max - box.y_min];
        if (!(across > 0 && up > 0)) return null;
        return { heading, box, columns: Math.ceil((across * view.scale) / pixels), rows: Math.ceil((up * view.scale) / pixels) };
    };

    // --- dragging
    const grab = (what: Drag, last: Point) => {
        if (!scene) return null;
        const pose = shown?.pose ?? scene.pose;
        handles.grabbed();
        return { what, last, pose, offset: { x: pose.x - last.x, y: pose.y - last.y } };
    };
    const move = (drag: NonNullable<ReturnType<typeof grab>>, p: Point) => {
        if (!scene) return;
        const { what: held, offset, pose } = drag;
        if (held === "car") {
            handles.pose(tidyPose({ x: p.x + offset.x, y: p.y + offset.y, heading: pose.heading }));
        } else if (held === "turn") {
            const heading = Math.atan2(p.y - pose.y, p.x - pose.x);
            handles.pose(tidyPose({ ...pose, heading: radians(Math.round(degrees(heading) * 5) / 5) }));
        } else {
            // In steps of 5 mm; what is left over counts for the next.
            const steps = (value: number) => Math.round(value * 200) / 200;
            const [dx, dy] = [steps(p.x - drag.last.x), steps(p.y - drag.last.y)];
            const out = sense(scene);
            const by = held === "rear" ? -dx : held === "front" ? dx : held === "curb" ? -out * dy : out * dy;
            if (by === 0) return;
            // The front neighbour carries the world's origin: the ground under the pointer stays.
            if (held === "front") view.x0 += view.fx * dx * view.scale;
            drag.last = held === "front" ? drag.last : { x: drag.last.x + dx, y: drag.last.y + dy };
            if (held === "rear" || held === "front") handles.along(by, held === "front");
            else if (held === "curb") handles.depth(by);
            else handles.road(by);
        }
    };
    const key = (held: Drag, event: KeyboardEvent) => {
        if (!scene) return false;
        const step = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0], PageUp: [0, 10], PageDown: [0, -10] }[event.key];
        const turn = { ",": 1, "<": 1, ".": -1, ">": -1 }[event.key];
        const factor = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
        const pose = shown?.pose ?? scene.pose;
        // Keys may come faster than frames: the next one goes on from here.
        const put = (next: Pose) => {
            shown = { pose: tidyPose(next), steer: 0 };
            handles.pose(shown.pose);
        };
        if (held === "car" && turn) put({ ...pose, heading: pose.heading + radians(turn * factor) });
        else if (!step) return false;
        else if (held === "car") {
            const by = 0.05 * factor * view.fx; // as it looks on the screen
            put({ ...pose, x: pose.x + step[0]! * by, y: pose.y + step[1]! * by });
        } else if (held === "turn") put({ ...pose, heading: pose.heading + radians((step[1]! || -step[0]!) * factor) });
        else {
            const by = (step[0]! || step[1]!) * 0.01 * factor;
            if (held === "rear" || held === "front") handles.along(by, held === "front");
            else if (held === "curb") handles.depth(by);
            else handles.road(by);
        }
        return true;
    };
    const drag = createHandles(root, drawn.ground, gripOf, { grab, move, released: () => handles.released(), key });

    watchSize(root, (now) => {
        size = now;
        if (size.width === 0) return;
        if (!scene) return;
        render(scene);
        if (shown) showCar(shown.pose, shown.steer);
        handles.released();
    });

    return { render, showCar, slice, busy: () => drag() !== null };
}

const channels = new Map<string, [number, number, number]>();
function rgb(hex: string): [number, number, number] {
    let found = channels.get(hex);
    if (!found) {
        const value = parseInt(hex.slice(1), 16);
        found = [value >> 16, (value >> 8) & 255, value & 255];
        channels.set(hex, found);
    }
    return found;
}
