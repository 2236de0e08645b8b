// What a person can set: read from fields and links, checked, and written back as a link or a command line.
import type { Car, Pose, Scene, SlotLike, StreetLike } from "snug";
import { clamp, degrees, radians } from "./geometry";

export interface Inputs {
    /** Where the car begins: anywhere in the street, or at the paper's entry position. */
    mode: "street" | "entry";
    /** Into the slot, or out of it. */
    way: "in" | "out";
    car: Car & { corner_radius?: number };
    length: number;
    width: number;
    side: "right" | "left";
    frontSetback: number;
    rearSetback: number;
    curb: "high" | "low";
    /** Between the parked car and the street [degrees]: the command takes them, so both turn the same number into radians. */
    angle: number;
    /** How wide the road is; null: open. */
    road: number | null;
    clearance: number;
    enter: "backward" | "forward";
    strategy: "max-steer" | "fewest";
    /** The entry heading looked at [rad]; null: the best. */
    heading: number | null;
    /** Where the car stands in the street, in the world; null: where the command puts it. */
    pose: Pose | null;
    /** A place from a file, instead of a street. */
    scene: Scene | null;
}

const setbacks = ({ frontSetback, rearSetback, curb }: Inputs): Partial<SlotLike> => ({
    ...(frontSetback ? { front_setback: frontSetback } : {}),
    ...(rearSetback ? { rear_setback: rearSetback } : {}),
    ...(curb === "low" ? { curb } : {}),
});
export const slotOf = (inputs: Inputs) => {
    const { length, width, side } = inputs;
    return { length, width, side, ...setbacks(inputs) };
};
export const drivingOf = ({ clearance, enter }: Inputs) => ({ clearance, enter });

export const placeOf = (inputs: Inputs): StreetLike | Scene => {
    const { scene, angle, road } = inputs;
    return scene ?? { ...slotOf(inputs), angle: Math.min(angle * (Math.PI / 180), Math.PI / 2), road };
};
/** Of a street; a scene has but one way. */
export const goalOf = ({ way, scene }: Inputs) => (way === "out" && !scene ? "road" : "bay");

/** As fine as is shown: what the link says is what was asked. */
export const tidyPose = ({ x, y, heading }: Pose): Pose => ({ x: tidy(x, 3), y: tidy(y, 3), heading: radians(tidy(degrees(heading), 2)) });
const tidy = (value: number, digits: number) => Number(value.toFixed(digits)) + 0; // not -0

/** A number that can be typed: its limits, and what it is in the inputs. */
interface Field {
    title: string;
    what: string;
    low: number;
    high: number;
    unit: "m" | "°";
    /** What the empty field stands for, where it may be empty. */
    empty?: string;
    get(inputs: Inputs): number | null;
    set(inputs: Inputs, value: number | null): Inputs;
}

type Plain = "length" | "width" | "clearance" | "frontSetback" | "rearSetback" | "angle" | "road";
const of = (key: Plain): Pick<Field, "get" | "set"> => ({
    get: (inputs) => inputs[key],
    set: (inputs, value) => ({ ...inputs, [key]: value }),
});
/** A changed car has no name any more. */
const withCar = (inputs: Inputs, part: Partial<Inputs["car"]>): Inputs => {
    const { name: _, ...car } = { ...inputs.car, ...part };
    return { ...inputs, car };
};
const ofCar = (key: "width" | "front" | "rear" | "wheelbase"): Pick<Field, "get" | "set"> => ({
    get: ({ car }) => car[key],
    set: (inputs, value) => withCar(inputs, { [key]: value! }),
});
const start: Pose = { x: 0, y: 0, heading: 0 };
const ofPose = (key: "x" | "y"): Pick<Field, "get" | "set"> => ({
    get: ({ pose }) => pose && pose[key],
    set: (inputs, value) => ({ ...inputs, pose: value === null ? null : { ...(inputs.pose ?? start), [key]: value } }),
});

/** The circle of the outer front wheel, as data sheets print it. */
const turningCircle = ({ wheelbase, width, max_steer }: Car) => 2 * Math.hypot(wheelbase / Math.tan(max_steer) + width / 2, wheelbase);
const steerFor = ({ wheelbase, width }: Car, circle: number) => {
    const radius = Math.sqrt(Math.max(0, (circle / 2) ** 2 - wheelbase ** 2)) - width / 2;
    return Math.atan2(wheelbase, Math.max(radius, 1e-3));
};

/** What the page takes and can show; the command takes more. */
const table = {
    length: { title: "Length [m]", what: "The slot’s length", low: 0.5, high: 40, unit: "m", ...of("length") },
    width: { title: "Width [m]", what: "The slot’s width", low: 0.3, high: 10, unit: "m", ...of("width") },
    angle: { title: "Angle [°]", what: "The angle of the bay", low: 0, high: 90, unit: "°", ...of("angle") },
    road: { title: "Road [m]", what: "The road’s width", low: 0.5, high: 30, unit: "m", empty: "open", ...of("road") },
    "front-setback": { title: "Front setback [m]", what: "The front setback", low: 0, high: 10, unit: "m", ...of("frontSetback") },
    "rear-setback": { title: "Rear setback [m]", what: "The rear setback", low: 0, high: 10, unit: "m", ...of("rearSetback") },
    clearance: { title: "Clearance [m]", what: "The clearance", low: 0, high: 1, unit: "m", ...of("clearance") },
    heading: {
        title: "Entry heading [°]", what: "The entry heading", low: 0, high: 90, unit: "°", empty: "best",
        get: ({ heading }) => heading && degrees(heading),
        set: (inputs, value) => ({ ...inputs, heading: value === null ? null : radians(value) }),
    },
    x: { title: "Ahead [m]", what: "The place along the street", low: -1000, high: 1000, unit: "m", empty: "usual", ...ofPose("x") },
    y: { title: "Aside [m]", what: "The place across the street", low: -1000, high: 1000, unit: "m", empty: "usual", ...ofPose("y") },
    turn: {
        title: "Turned [°]", what: "The car’s heading", low: -360, high: 360, unit: "°", empty: "usual",
        get: ({ pose }) => pose && degrees(pose.heading),
        set: (inputs, value) => ({ ...inputs, pose: value === null ? null : { ...(inputs.pose ?? start), heading: radians(value) } }),
    },
    "car-width": { title: "Width [m]", what: "The car’s width", low: 0.3, high: 6, unit: "m", ...ofCar("width") },
    "car-front": { title: "Front [m]", what: "The front, measured from the rear axle,", low: 0.3, high: 25, unit: "m", ...ofCar("front") },
    "car-rear": { title: "Rear [m]", what: "The rear overhang", low: 0.05, high: 12, unit: "m", ...ofCar("rear") },
    "car-wheelbase": { title: "Wheelbase [m]", what: "The wheelbase", low: 0.3, high: 20, unit: "m", ...ofCar("wheelbase") },
    "car-steer": {
        title: "Steering [°]", what: "The largest steering angle", low: 5, high: 80, unit: "°",
        get: ({ car }) => degrees(car.max_steer),
        set: (inputs, value) => withCar(inputs, { max_steer: radians(value!) }),
    },
    "car-corner": {
        title: "Corner radius [m]", what: "The corner radius", low: 0, high: 3, unit: "m",
        get: ({ car }) => car.corner_radius ?? 0,
        set: (inputs, value) => withCar(inputs, { corner_radius: value || undefined }),
    },
    "front-overhang": {
        title: "Front overhang [m]", what: "The front overhang", low: 0, high: 10, unit: "m",
        get: ({ car }) => car.front - car.wheelbase,
        set: (inputs, value) => withCar(inputs, { front: tidy(inputs.car.wheelbase + value!, 6) }),
    },
    "turning-circle": {
        title: "Turning circle [m]", what: "The turning circle, curb to curb,", low: 1, high: 100, unit: "m",
        get: ({ car }) => turningCircle(car),
        set: (inputs, value) => withCar(inputs, { max_steer: steerFor(inputs.car, value!) }),
    },
} satisfies Record<string, Field>;
export type NumberField = keyof typeof table;
export const fields: Record<NumberField, Field> = table;

/** The nearest number the page takes, without noise from arithmetic. */
export const within = (field: NumberField, value: number) => clamp(Number(value.toFixed(6)), fields[field].low, fields[field].high);

/** In the field's own unit. */
const units = {
    m: { m: 1, cm: 0.01, mm: 0.001, ft: 0.3048, in: 0.0254 },
    "°": { "°": 1, deg: 1, rad: 180 / Math.PI },
} as Record<string, Record<string, number>>;

/** The number typed, with a unit or without, or a sentence that says what is wrong with it. */
export function parseNumber(field: NumberField, typed: string): number | string {
    const { what, low, high, unit } = fields[field];
    const text = typed.trim().replace(",", ".");
    const range = `between ${low} and ${high} ${unit}`;
    if (text === "") return `${what} is missing; give a number ${range}.`;
    const parts = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?)\s*([a-z°]*)$/i.exec(text);
    const factor = parts?.[2] ? units[unit]![parts[2].toLowerCase()] : 1;
    if (!parts || !factor) return `${what} must be a number ${range}.`;
    const value = factor === 1 ? Number(parts[1]) : Number((Number(parts[1]) * factor).toFixed(9));
    return value >= low && value <= high ? value : `${what} must lie ${range}.`;
}

/** A number as a person would write it, without noise from arithmetic. */
export const plain = (value: number, digits = 6) => String(Number(value.toFixed(digits)) + 0);

export const fieldValue = (inputs: Inputs, field: NumberField) => fields[field].get(inputs);
export const withField = (inputs: Inputs, field: NumberField, value: number | null) => fields[field].set(inputs, value);

/** What is wrong with the car as a whole, and where. */
export function carTrouble({ car }: Inputs): Complaint | null {
    const { front, wheelbase, max_steer } = car;
    if (front < wheelbase)
        return { field: "car-front", sentence: `The front, ${plain(front)} m from the rear axle, must lie ahead of the front axle, ${plain(wheelbase)} m from it.` };
    if (!(degrees(max_steer) >= 5 && degrees(max_steer) <= 80))
        return { field: "turning-circle", sentence: "With that turning circle the wheels would turn less than 5° or more than 80°." };
    return null;
}

const lengths = ["car-width", "car-front", "car-rear", "car-wheelbase", "car-steer"] as const;
const words = {
    mode: ["street", "entry"],
    way: ["in", "out"],
    side: ["right", "left"],
    curb: ["high", "low"],
    enter: ["backward", "forward"],
    strategy: ["max-steer", "fewest"],
} as const;

/** Of a link after its #: longer ones are cut off on the way by some programs. */
const longestLink = 8000;

/** The part of a link after its #. A place from a file is in it if it is short enough. */
export function toLink(inputs: Inputs): string {
    const link = new URLSearchParams();
    link.set("mode", inputs.mode);
    if (inputs.car.name) link.set("car", inputs.car.name);
    else for (const field of lengths) link.set(field, plain(fieldValue(inputs, field)!, 9));
    if (inputs.car.corner_radius) link.set("car-corner", plain(inputs.car.corner_radius));
    link.set("length", plain(inputs.length));
    link.set("width", plain(inputs.width));
    for (const key of ["side", "curb", "enter", "way"] as const) if (inputs[key] !== words[key][0]) link.set(key, inputs[key]);
    for (const field of ["angle", "front-setback", "rear-setback", "clearance"] as const) {
        const value = fieldValue(inputs, field);
        if (value) link.set(field, plain(value));
    }
    link.set("road", inputs.road === null ? "open" : plain(inputs.road));
    if (inputs.strategy !== "max-steer") link.set("strategy", inputs.strategy);
    if (inputs.heading !== null) link.set("heading", plain(degrees(inputs.heading), 9));
    if (inputs.pose) for (const field of ["x", "y", "turn"] as const) link.set(field, plain(fieldValue(inputs, field)!, 9));
    const street = link.toString();
    if (!inputs.scene) return street;
    link.set("scene", JSON.stringify(inputs.scene));
    const whole = link.toString();
    return whole.length <= longestLink ? whole : street;
}
export const holdsScene = (link: string) => new URLSearchParams(link).has("scene");

export interface Complaint {
    sentence: string;
    field?: NumberField;
}

/** What is good in a link, and sentences about what is not. `readScene` throws such a sentence. */
export function fromLink(
    text: string,
    usual: Inputs,
    catalogue: Car[],
    readScene: (text: string) => Scene,
): { inputs: Inputs; complaints: Complaint[] } {
    const link = new URLSearchParams(text.slice(0, longestLink));
    // Before there was a street, links did not say which mode they mean: there was but one.
    let inputs: Inputs = [...link.keys()].length > 0 && !link.has("mode") ? { ...usual, mode: "entry" } : usual;
    const complaints: Complaint[] = [];
    const name = link.get("car");
    if (name !== null) {
        const car = catalogue.find((one) => one.name === name);
        if (car) inputs = { ...inputs, car };
        else complaints.push({ sentence: "The link names a car that is not in the catalogue." });
    }
    const before = inputs.car;
    for (const field of Object.keys(fields) as NumberField[]) {
        const typed = link.get(field);
        if (typed === null) continue;
        if (typed === fields[field].empty) {
            inputs = withField(inputs, field, null);
            continue;
        }
        const value = parseNumber(field, typed);
        if (typeof value === "number") inputs = withField(inputs, field, value);
        else complaints.push({ field, sentence: `In the link: ${value}` });
    }
    const wrong = carTrouble(inputs);
    if (wrong) {
        complaints.push({ field: wrong.field, sentence: `In the link: ${wrong.sentence}` });
        inputs = { ...inputs, car: before };
    }
    for (const [key, known] of Object.entries(words)) {
        const word = link.get(key);
        if (word === null) continue;
        if ((known as readonly string[]).includes(word)) inputs = { ...inputs, [key]: word };
        else complaints.push({ sentence: `In the link: “${key}” must be ${known.join(" or ")}.` });
    }
    const scene = link.get("scene");
    if (scene !== null) {
        try {
            inputs = { ...inputs, mode: "street", way: "in", scene: readScene(scene) };
        } catch (error) {
            complaints.push({ sentence: error instanceof Error ? `${error.message}.` : String(error) });
        }
    }
    return { inputs, complaints };
}

/** The same question for the command. `moves`: the changes that full steering takes from the heading that is set. */
export function commandLine(inputs: Inputs, moves?: number): string {
    const { car, mode, scene, pose, road, angle, heading } = inputs;
    const street = mode === "street";
    const out = goalOf(inputs) === "road";
    const said = [`snug ${!street ? "entry" : out ? "leave" : "park"}`, `--car ${car.name ?? "car.json"}`];
    const files = car.name ? [] : [`echo '${JSON.stringify(car)}' > car.json`];
    if (street && scene) said.push("--scene scene.json");
    else {
        said.push(`--length ${plain(inputs.length)}`, `--width ${plain(inputs.width)}`);
        if (street && angle) said.push(`--angle ${plain(angle)}`);
        if (street && road !== null) said.push(`--road ${plain(road)}`);
        // What a street is to `leave`: its stretch, where nothing else says so.
        if (street && out && !angle && road === null) said.push("--stretch 10");
        if (inputs.frontSetback) said.push(`--front-setback ${plain(inputs.frontSetback)}`);
        if (inputs.rearSetback) said.push(`--rear-setback ${plain(inputs.rearSetback)}`);
        if (inputs.curb !== "high") said.push(`--curb ${inputs.curb}`);
        if (inputs.side !== "right") said.push(`--side ${inputs.side}`);
        if (inputs.enter !== "backward") said.push(`--enter ${inputs.enter}`);
    }
    if (inputs.clearance) said.push(`--clearance ${plain(inputs.clearance)}`);
    if (street && pose) said.push(`--from ${pose.x},${pose.y},${pose.heading}`);
    if (!street && inputs.strategy !== "max-steer") said.push(`--strategy ${inputs.strategy}`);
    else if (!street && heading !== null) {
        // The command answers for all headings: up to so many changes this one is in a range it prints.
        if (moves !== undefined) said.push(`--max-changes ${moves}`);
        said.push(`# heading ${plain(heading, 9)} rad`);
    }
    return [...files, said.join(" ")].join(" && ");
}
